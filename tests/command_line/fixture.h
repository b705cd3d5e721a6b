// Runs of the built executable in a folder of their own, and small volumes for them.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/samples/run_process.h"
#include "tests/samples/scratch_directory.h"

namespace isoloop {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

inline std::string float_bytes(const std::vector<float>& values) {
  std::string bytes;
  for (const float value : values) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int shift = 0; shift < 32; shift += 8) {
      bytes.push_back(static_cast<char>((bits >> shift) & 0xFF));
    }
  }
  return bytes;
}

// A ring of ones, one voxel thick, in a 5 x 5 x 3 box of zeros: one component, one tunnel.
inline std::string ring_bytes() {
  std::string bytes(75, '\0');
  for (const std::size_t place : {6, 7, 8, 11, 13, 16, 17, 18}) bytes[25 + place] = '\1';
  return bytes;
}

class CommandLine : public ::testing::Test {
 protected:
  ProcessResult run(const Words& arguments) const {
    return run_isoloop(scratch_.path(), arguments);
  }

  // The run failed with this code and one sentence that holds `words`, and wrote nothing.
  void expect_failure(const Words& arguments, int code, const std::string& words) const {
    const Words before = scratch_.files();
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(result.err.starts_with("isoloop: ")) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_EQ(scratch_.files(), before);
  }

  ScratchDirectory scratch_;
};

}  // namespace isoloop
