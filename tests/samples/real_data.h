// The real data that lies beside the repository. A test that needs a missing file skips by name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop::testing {

inline std::filesystem::path data(const std::string& name) {
  return std::filesystem::path(ISOLOOP_TEST_DATA) / name;
}

/// The bytes of a file of the data; of a raw volume of uint8, its voxels.
inline std::vector<std::uint8_t> bytes_of(const std::string& name) {
  std::ifstream file(data(name), std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  return {bytes.begin(), bytes.end()};
}

/// "engine_half" of "engine_half_128x128x64_uint8.raw".
inline std::string short_name(const std::string& file) {
  return file.substr(0, file.find_first_of("0123456789") - 1);
}

}  // namespace isoloop::testing

/// Skips the test, naming the file, where the data folder does not hold it.
#define ISOLOOP_NEEDS(name)                                        \
  if (!std::filesystem::exists(isoloop::testing::data(name))) {    \
    GTEST_SKIP() << isoloop::testing::data(name) << " is missing"; \
  }                                                                \
  static_assert(true)
