// Words and numbers of text headers, read strictly.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "volume/byte_stream.h"

namespace isoloop {

/// Without blanks at either end.
std::string_view trimmed(std::string_view text);

/// ASCII letters made small.
std::string lower_case(std::string_view text);

/// The words between blanks.
std::vector<std::string> words_of(std::string_view text);

/// The whole of `word` as a number ("nan" and "inf" are some); nothing if it is none.
std::optional<double> number_of(std::string_view word);

/// The whole of `word` as a whole number; nothing if it is none or does not fit.
std::optional<std::int64_t> whole_number_of(std::string_view word);

/// All words of `text` as numbers. Throws InvalidInput, opening with `what` and quoting the text,
/// if a word is none, or if they are not `count` (0: any).
std::vector<double> numbers_of(std::string_view text, std::size_t count, const std::string& what);
std::vector<std::int64_t> whole_numbers_of(std::string_view text, std::size_t count,
                                           const std::string& what);

/// The next line of a plain stream, without its end ("\n" or "\r\n"). Throws InvalidInput if the
/// file ends before the line does, or if it is longer than 64 KiB.
std::string read_line(ByteStream& stream, const std::string& what);

/// The file that a header names: beside the header unless the name is a whole path.
std::filesystem::path beside(const std::filesystem::path& header, std::string_view name);

}  // namespace isoloop
