// Small PNG and BMP files.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <zlib.h>

#include "tests/samples/byte_samples.h"

namespace isoloop::test {

inline std::string png_chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const auto sum = static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())));
  return number_bytes(static_cast<std::uint32_t>(data.size()), Endian::big) + body +
         number_bytes(sum, Endian::big);
}

/// 3 x 2 pixels unless stated otherwise.
struct PngSample {
  std::uint32_t width = 3;
  std::uint32_t height = 2;
  char bits = 8;
  char colours = 0;  // 0: grey, 2: RGB, 3: palette, 4: grey with alpha, 6: RGB with alpha
  char interlace = 0;
  std::string before_pixels{};  // chunks
  std::vector<std::string> rows{{"\0\1\2", 3}, {"\3\4\5", 3}};

  std::string file() const {
    std::string pixels;
    for (const std::string& row : rows) pixels += '\0' + row;
    return "\x89PNG\r\n\x1a\n" +
           png_chunk("IHDR", number_bytes(width, Endian::big) + number_bytes(height, Endian::big) +
                                 bits + colours + '\0' + '\0' + interlace) +
           before_pixels + png_chunk("IDAT", zlib_bytes(pixels)) + png_chunk("IEND", "");
  }
};

inline std::string grey_palette(int colours, int entry_bytes) {
  std::string palette;
  for (int i = 0; i < colours; ++i) {
    palette += std::string(3, static_cast<char>(10 * i));
    if (entry_bytes == 4) palette += '\0';
  }
  return palette;
}

inline std::vector<PngSample> every_sort_of_png() {
  const std::string palette = png_chunk("PLTE", grey_palette(6, 3));
  return {{},
          {.bits = 16, .rows = {{"\0\0\0\1\0\2", 6}, {"\0\3\0\4\0\5", 6}}},
          {.bits = 1, .rows = {"\xa0", "\x40"}},
          {.colours = 3, .before_pixels = palette},
          {.bits = 4, .colours = 3, .before_pixels = palette, .rows = {"\x01\x20", "\x34\x50"}},
          {.colours = 2, .rows = {{"\0\0\0\1\1\1\2\2\2", 9}, "\3\3\3\4\4\4\5\5\5"}},
          {.colours = 4, .rows = {{"\0\xff\1\xff\2\xff", 6}, "\3\xff\4\xff\5\xff"}},
          {.interlace = 1, .rows = {{"\0", 1}, "\2", "\1", "\3\4\5"}}};
}

/// 3 x 2 pixels, values 0 to 5 from the first row on.
struct BmpSample {
  std::uint32_t header = 40;  // bytes; 12: OS/2
  std::uint16_t bits = 8;
  bool top_down = false;
  std::uint32_t packing = 0;
  std::int32_t width = 3;
  std::int32_t height = 2;
  std::string palette = grey_palette(6, 4);
  std::string first_row{"\0\1\2\0", 4};
  std::string last_row{"\3\4\5\0", 4};

  std::string file() const {
    const auto number = [](auto value) { return number_bytes(value, Endian::little); };
    const std::string colours = bits == 8 ? palette : "";
    const std::string pixels = top_down ? first_row + last_row : last_row + first_row;
    const auto at = static_cast<std::uint32_t>(14 + header + colours.size());
    std::string bytes = "BM" + number(static_cast<std::uint32_t>(at + pixels.size())) +
                        number(std::uint32_t{0}) + number(at) + number(header);
    if (header == 12) {
      bytes += number(static_cast<std::uint16_t>(width)) +
               number(static_cast<std::uint16_t>(height)) + number(std::uint16_t{1}) + number(bits);
    } else {
      bytes += number(width) + number(top_down ? -height : height) + number(std::uint16_t{1}) +
               number(bits) + number(packing) + std::string(12, '\0') +
               number(static_cast<std::uint32_t>(colours.size() / 4)) + std::string(4, '\0') +
               std::string(header - 40, '\0');
    }
    return bytes + colours + pixels;
  }
};

inline std::vector<BmpSample> every_sort_of_bmp() {
  const BmpSample colours{.bits = 24,
                          .first_row = {"\0\0\0\1\1\1\2\2\2\0\0\0", 12},
                          .last_row = {"\3\3\3\4\4\4\5\5\5\0\0\0", 12}};
  BmpSample top_down = colours;
  top_down.top_down = true;
  return {{},
          {.top_down = true},
          colours,
          top_down,
          {.header = 108},
          {.header = 124},
          {.header = 12, .palette = grey_palette(256, 3)}};
}

}  // namespace isoloop::test
