#include "tools/words/base64.h"

#include <gtest/gtest.h>

namespace isoloop {
namespace {

std::string of(const std::string& text) {
  return base64(std::vector<std::uint8_t>(text.begin(), text.end()));
}

TEST(Base64, IsThatOfRfc4648) {
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(of("\xff\xfe"), "//4=");
}

TEST(Base64, NumbersHaveTheirLowByteFirst) {
  std::vector<std::uint8_t> bytes;
  append_little_endian(bytes, std::uint16_t{0x0102});
  append_little_endian(bytes, std::uint32_t{0x03});
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{2, 1, 3, 0, 0, 0}));
}

}  // namespace
}  // namespace isoloop
