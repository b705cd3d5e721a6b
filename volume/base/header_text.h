// Words and numbers of text headers, read strictly.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/finding.h"
#include "volume/base/byte_stream.h"

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

/// The same, but where the file ends within the line, what is there of it, with `is_ended` false.
std::string read_line_or_rest(ByteStream& stream, const std::string& what, bool& is_ended);

/// What is said where a header without an end to its last line is read.
Finding unended_header_warning(const std::string& what);

/// Whether what a header says of its data file stands for several: a list of names, or a pattern
/// with numbers such as "slice%03d.raw 1 20 1". A file that is there by that very name is one.
bool names_several_files(const std::filesystem::path& header, std::string_view name);

/// The file that a header names: beside the header unless the name is a whole path.
std::filesystem::path beside(const std::filesystem::path& header, std::string_view name);

}  // namespace isoloop
