// Input that cannot be read twice: standard input and pipes, copied to a file first.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "tools/flags/input_flags.h"

namespace isoloop {

/// A file in a folder of its own, both gone with the last copy of the object.
using StagedFile = std::shared_ptr<const std::filesystem::path>;

/// A copy of what `flags.file` names, if that is "-" or a pipe; else null. Its extension is that of
/// the pipe's name, or .raw where --type is given. Throws InvalidArgument where neither says what
/// the bytes are, InvalidInput and LimitExceeded where they cannot be copied.
StagedFile staged_input(const VolumeFlags& flags);

}  // namespace isoloop
