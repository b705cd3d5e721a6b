// Small TIFF files, as libtiff writes them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <tiffio.h>

namespace isoloop::test {

/// Pages of 5 x 4 pixels of 16 bits: 100 z + x + 5 y.
struct TiffSample {
  const char* mode = "wl";  // "wb": big-endian, "w8": BigTIFF
  std::uint16_t compression = COMPRESSION_NONE;
  bool tiled = false;
  int pages = 2;
  std::uint32_t width = 5;
  std::uint16_t samples = 1;
  std::uint16_t format = SAMPLEFORMAT_UINT;
  std::string description{};
};

inline void write_tiff_page(TIFF* file, const TiffSample& sample, int z) {
  TIFFSetField(file, TIFFTAG_IMAGEWIDTH, sample.width);
  TIFFSetField(file, TIFFTAG_IMAGELENGTH, 4);
  TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 16);
  TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, sample.samples);
  TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, sample.format);
  TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(file, TIFFTAG_PHOTOMETRIC,
               sample.samples == 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
  TIFFSetField(file, TIFFTAG_COMPRESSION, sample.compression);
  if (!sample.description.empty()) {
    TIFFSetField(file, TIFFTAG_IMAGEDESCRIPTION, sample.description.c_str());
  }
  bool written = true;
  if (sample.tiled) {
    TIFFSetField(file, TIFFTAG_TILEWIDTH, 16);
    TIFFSetField(file, TIFFTAG_TILELENGTH, 16);
    std::vector<std::uint16_t> tile(256);
    for (std::uint16_t y = 0; y < 4; ++y) {
      for (std::uint16_t x = 0; x < sample.width; ++x) {
        tile[16U * y + x] = static_cast<std::uint16_t>(100 * z + x + 5 * y);
      }
    }
    written = TIFFWriteEncodedTile(file, 0, tile.data(), 512) > 0;
  } else {
    TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, 3);
    for (std::uint16_t y = 0; y < 4; ++y) {
      std::vector<std::uint16_t> row(std::size_t{sample.width} * sample.samples);
      for (std::size_t x = 0; x < row.size(); ++x) {
        row[x] = static_cast<std::uint16_t>(100U * static_cast<unsigned>(z) + x + 5U * y);
      }
      written = written && TIFFWriteScanline(file, row.data(), y) == 1;
    }
  }
  if (!written || TIFFWriteDirectory(file) != 1) throw std::runtime_error("libtiff does not write");
}

/// All pages, written to `path` first and read from there.
inline std::string tiff_bytes(const TiffSample& sample, const std::filesystem::path& path) {
  TIFF* file = TIFFOpen(path.c_str(), sample.mode);
  if (file == nullptr) throw std::runtime_error("libtiff does not open " + path.string());
  for (int z = 0; z < sample.pages; ++z) write_tiff_page(file, sample, z);
  TIFFClose(file);
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  std::filesystem::remove(path);
  return bytes.str();
}

inline std::vector<TiffSample> every_sort_of_tiff() {
  return {{},
          {.mode = "wb"},
          {.mode = "w8"},
          {.compression = COMPRESSION_LZW},
          {.mode = "wb", .compression = COMPRESSION_ADOBE_DEFLATE},
          {.compression = COMPRESSION_PACKBITS},
          {.tiled = true},
          {.compression = COMPRESSION_LZW, .tiled = true}};
}

}  // namespace isoloop::test
