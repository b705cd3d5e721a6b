// Headers of small MetaImage files.
#pragma once

#include <string>

namespace isoloop::test {

/// Of 3 x 2 x 2 voxels of 16 bits, with more lines.
inline std::string meta_image_header(const std::string& lines, const std::string& data = "LOCAL") {
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 3 2 2\n"
         "ElementType = MET_SHORT\n" +
         lines + "ElementDataFile = " + data + "\n";
}

/// A file whose voxels are packed.
inline std::string meta_image_packed(const std::string& packed, const std::string& lines = "") {
  return meta_image_header("CompressedData = True\nCompressedDataSize = " +
                           std::to_string(packed.size()) + "\n" + lines) +
         packed;
}

}  // namespace isoloop::test
