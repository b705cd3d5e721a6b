// Files for the tests of the readers, cut short.
#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/volume_test_files.h"
#include "volume/voxels/volume.h"

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

/// Flips bits of one byte in `step` after the other: read(bytes) must return a volume of as many
/// voxels as its dimensions say, or throw an error of isoloop's own. It must throw some, or the
/// bytes were not looked at.
template <class Read>
void expect_flipped_bytes_are_noticed_or_harmless(const std::string& whole, std::size_t step,
                                                  const Read& read) {
  int refused = 0;
  for (std::size_t at = 0; at < whole.size(); at += step) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0xff);
    try {
      const Volume volume = read(damaged);
      const auto voxels =
          static_cast<std::size_t>(volume.dims[0] * volume.dims[1] * volume.dims[2]);
      std::visit([&](const auto& values) { EXPECT_EQ(values.size(), voxels) << "byte " << at; },
                 volume.values);
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

}  // namespace isoloop::test
