// Files for the tests of the readers, cut short.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/volume_test_files.h"

namespace isoloop::test {

/// `read` must take the whole file, and refuse each of its beginnings as invalid input.
template <class Read>
void expect_no_beginning_is_read(const std::filesystem::path& path, const std::string& whole,
                                 const Read& read) {
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write_bytes(path, whole.substr(0, length));
    EXPECT_THROW(read(), InvalidInput) << path << " cut to " << length << " of " << whole.size();
  }
  write_bytes(path, whole);
  EXPECT_NO_THROW(read()) << path;
}

/// The same but for the end of the last line of a text.
template <class Read>
void expect_no_beginning_is_read_but_the_last_line(const std::filesystem::path& path,
                                                   const std::string& whole, const Read& read) {
  for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
    write_bytes(path, whole.substr(0, length));
    EXPECT_THROW(read(), InvalidInput) << path << " cut to " << length << " of " << whole.size();
  }
  for (const std::size_t length : {whole.size() - 1, whole.size()}) {
    write_bytes(path, whole.substr(0, length));
    EXPECT_NO_THROW(read()) << path << " cut to " << length << " of " << whole.size();
  }
}

}  // namespace isoloop::test
