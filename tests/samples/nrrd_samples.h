// Headers of small NRRD files.
#pragma once

#include <string>

namespace isoloop::test {

/// Of 3 x 2 x 2 voxels of 16 bits, with more lines; without the empty line at its end.
inline std::string nrrd_header(const std::string& lines) {
  return "NRRD0004\n# a comment\ntype: short\ndimension: 3\nsizes: 3 2 2\n" + lines;
}

inline const std::string nrrd_plain = "endian: little\nencoding: raw\n";

}  // namespace isoloop::test
