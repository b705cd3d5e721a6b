// Small NIfTI files.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "tests/samples/byte_samples.h"

namespace isoloop::test {

/// A header of NIfTI-1 with both maps, and int16 voxels 0, 1, 2, ...
struct NiftiSample {
  Endian endian = Endian::little;
  std::array<std::int16_t, 8> dim{3, 3, 2, 2, 1, 1, 1, 1};
  std::int16_t type = 4;
  std::int16_t bits = 16;
  std::array<float, 4> pixdim{1, 2, 3, 4};
  float from = 352;
  float slope = 0;
  float intercept = 0;
  std::int16_t qform = 0;
  std::int16_t sform = 0;
  std::array<float, 6> quaternion{};
  std::array<float, 12> rows{};
  std::string magic{"n+1\0", 4};

  std::string header() const {
    std::string bytes(352, '\0');
    put(bytes, 0, std::int32_t{348}, endian);
    for (std::size_t i = 0; i < 8; ++i) put(bytes, 40 + 2 * i, dim[i], endian);
    put(bytes, 70, type, endian);
    put(bytes, 72, bits, endian);
    for (std::size_t i = 0; i < 4; ++i) put(bytes, 76 + 4 * i, pixdim[i], endian);
    put(bytes, 108, from, endian);
    put(bytes, 112, slope, endian);
    put(bytes, 116, intercept, endian);
    bytes[123] = 2;
    put(bytes, 252, qform, endian);
    put(bytes, 254, sform, endian);
    for (std::size_t i = 0; i < 6; ++i) put(bytes, 256 + 4 * i, quaternion[i], endian);
    for (std::size_t i = 0; i < 12; ++i) put(bytes, 280 + 4 * i, rows[i], endian);
    bytes.replace(344, 4, magic);
    return bytes;
  }
  std::string voxels() const {
    std::int64_t count = 1;
    for (int i = 1; i <= std::min<int>(dim[0], 7); ++i) count *= dim[i];
    std::string bytes;
    for (std::int64_t i = 0; i < count; ++i)
      bytes += number_bytes(static_cast<std::int16_t>(i), endian);
    return bytes;
  }
  std::string file() const { return header() + voxels(); }
};

/// A file of NIfTI-2: 2 x 2 x 2 voxels of 8 bits in each frame, 0, 1, 2, ...
inline std::string nifti_2_file(Endian endian, std::int64_t frames) {
  std::string bytes(544, '\0');
  put(bytes, 0, std::int32_t{540}, endian);
  bytes.replace(4, 8, std::string("n+2\0\r\n\032\n", 8));
  put(bytes, 12, std::int16_t{2}, endian);
  put(bytes, 14, std::int16_t{8}, endian);
  const std::array<std::int64_t, 5> dim{4, 2, 2, 2, frames};
  for (std::size_t i = 0; i < 5; ++i) put(bytes, 16 + 8 * i, dim[i], endian);
  for (std::size_t i = 0; i < 4; ++i) put(bytes, 104 + 8 * i, 1.0 + static_cast<double>(i), endian);
  put(bytes, 168, std::int64_t{544}, endian);
  for (std::int64_t value = 0; value < 8 * frames; ++value)
    bytes.push_back(static_cast<char>(value));
  return bytes;
}

}  // namespace isoloop::test
