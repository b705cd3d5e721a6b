// The program vdb_decoder, as bytes within the library: it needs no place where it is found, and is
// always of the library's own version.
#pragma once

#include <span>

namespace isoloop {

/// Exit status of the program.
enum class DecoderStatus { done = 0, failed = 1, out_of_memory = 2 };

std::span<const char> vdb_decoder_program();

}  // namespace isoloop
