// Small VTK image files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/samples/byte_samples.h"

namespace isoloop::test {

inline std::string base64_text(const std::string& bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      bits = bits << 8 | (i + j < bytes.size() ? static_cast<std::uint8_t>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text.push_back(i + j <= bytes.size() ? letters[bits >> (18 - 6 * j) & 63U] : '=');
    }
  }
  return text;
}

/// A file of 3 x 2 x 2 voxels of 16 bits, 0 to 11, whose first has the index (1, 0, 0).
struct VtiSample {
  Endian endian = Endian::little;
  bool wide_sizes = false;
  bool packed = false;
  std::string format = "ascii";  // "binary", "raw" or "base64" (appended)
  std::string image = "Origin=\"10 20 30\" Spacing=\"1 2 3\"";
  std::string array{};  // more attributes
  std::string type = "Int16";
  std::string extent = "1 3 0 1 0 1";
  std::string more{};      // more point data
  std::string cells{};     // cell data
  std::size_t block = 16;  // bytes of a compressed block

  std::string size(std::uint64_t bytes) const {
    return wide_sizes ? number_bytes(bytes, endian)
                      : number_bytes(static_cast<std::uint32_t>(bytes), endian);
  }
  // Of 24 bytes in two blocks, in one that they do not fill, or as they are.
  std::string data(bool as_text) const {
    const std::string bytes = dozen_voxels(endian);
    if (!packed) {
      const std::string all = size(bytes.size()) + bytes;
      return as_text ? base64_text(all) : all;
    }
    const std::size_t whole = block > bytes.size() ? 0 : block;
    const std::string first = whole > 0 ? zlib_bytes(bytes.substr(0, whole)) : "";
    const std::string last = zlib_bytes(bytes.substr(whole));
    const std::string sizes = size(whole > 0 ? 2 : 1) + size(block) + size(bytes.size() - whole) +
                              (whole > 0 ? size(first.size()) : "") + size(last.size());
    return as_text ? base64_text(sizes) + base64_text(first + last) : sizes + first + last;
  }
  std::string file() const {
    std::string text =
        "<?xml version=\"1.0\"?>\n<!-- a <comment> -->\n<VTKFile "
        "type=\"ImageData\" version=\"1.0\" byte_order=\"";
    text += endian == Endian::big ? "BigEndian\"" : "LittleEndian\"";
    if (wide_sizes) text += " header_type=\"UInt64\"";
    if (packed) text += " compressor=\"vtkZLibDataCompressor\"";
    text += ">\n<ImageData WholeExtent=\"" + extent + "\" " + image + ">\n<Piece Extent=\"" +
            extent + "\">\n<PointData Scalars=\"density\">\n<DataArray type=\"" + type +
            "\" Name=\"density\" " + array;
    const bool appended = format == "raw" || format == "base64";
    if (appended) {
      text += " format=\"appended\" offset=\"0\"/>\n";
    } else if (format == "ascii") {
      text += " format=\"ascii\">0 1 2 3 4 5\n6 7 8 9 10 11</DataArray>\n";
    } else {
      text += " format=\"binary\">\n" + data(true) + "\n</DataArray>\n";
    }
    text += more + "</PointData>\n" + (cells.empty() ? "<CellData/>" : cells) +
            "</Piece></ImageData>\n";
    if (appended) {
      text += "<AppendedData encoding=\"" + format + "\">\n _" + data(format == "base64") +
              "\n</AppendedData>\n";
    }
    return text + "</VTKFile>";
  }
};

inline std::vector<VtiSample> every_sort_of_vti() {
  std::vector<VtiSample> sorts{{}};
  for (const char* format : {"binary", "raw", "base64"}) {
    for (const bool packed : {false, true}) {
      sorts.push_back({.packed = packed, .format = format});
      sorts.push_back(
          {.endian = Endian::big, .wide_sizes = true, .packed = packed, .format = format});
      if (packed) sorts.push_back({.packed = true, .format = format, .block = 32768});
    }
  }
  return sorts;
}

}  // namespace isoloop::test
