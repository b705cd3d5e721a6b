// Headers of NumPy files.
#pragma once

#include <cstdint>
#include <string>

#include "tests/samples/byte_samples.h"

namespace isoloop::test {

/// As NumPy writes it, up to the first voxel.
inline std::string npy_header(const std::string& type, const std::string& shape,
                              bool fortran = false, char version = 1) {
  std::string text = "{'descr': '" + type + "', 'fortran_order': " + (fortran ? "True" : "False") +
                     ", 'shape': " + shape + ", }";
  while ((text.size() + 11) % 16 != 0) text.push_back(' ');
  text.push_back('\n');
  const auto size = static_cast<std::uint32_t>(text.size());
  std::string length = number_bytes(size, Endian::little);
  if (version == 1) length.resize(2);
  return std::string("\x93NUMPY") + version + '\0' + length + text;
}

}  // namespace isoloop::test
