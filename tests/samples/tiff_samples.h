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

#include "tests/samples/byte_samples.h"

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
  float per_unit = 0.0F;          // pixels, along x and y; 0: not stated
  int white_is_zero_from = 1000;  // pages from this one on are negatives
  int reduced_from = 1000;        // and are previews
  std::uint32_t depth = 1;  // slices within each page (ImageDepth), which must be tiled, in this
                            // machine's byte order, without compression or by ADOBE_DEFLATE
};

inline void write_tiff_page(TIFF* file, const TiffSample& sample, int z) {
  TIFFSetField(file, TIFFTAG_IMAGEWIDTH, sample.width);
  TIFFSetField(file, TIFFTAG_IMAGELENGTH, 4);
  TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 16);
  TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, sample.samples);
  TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, sample.format);
  TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(file, TIFFTAG_PHOTOMETRIC,
               sample.samples == 3              ? PHOTOMETRIC_RGB
               : z >= sample.white_is_zero_from ? PHOTOMETRIC_MINISWHITE
                                                : PHOTOMETRIC_MINISBLACK);
  if (z >= sample.reduced_from) TIFFSetField(file, TIFFTAG_SUBFILETYPE, FILETYPE_REDUCEDIMAGE);
  TIFFSetField(file, TIFFTAG_COMPRESSION, sample.compression);
  if (!sample.description.empty()) {
    TIFFSetField(file, TIFFTAG_IMAGEDESCRIPTION, sample.description.c_str());
  }
  if (sample.per_unit > 0.0F) {
    TIFFSetField(file, TIFFTAG_XRESOLUTION, sample.per_unit);
    TIFFSetField(file, TIFFTAG_YRESOLUTION, sample.per_unit);
    TIFFSetField(file, TIFFTAG_RESOLUTIONUNIT, RESUNIT_NONE);
  }
  bool written = true;
  if (sample.tiled) {
    TIFFSetField(file, TIFFTAG_TILEWIDTH, 16);
    TIFFSetField(file, TIFFTAG_TILELENGTH, 16);
    if (sample.depth > 1) {
      TIFFSetField(file, TIFFTAG_IMAGEDEPTH, sample.depth);
      TIFFSetField(file, TIFFTAG_TILEDEPTH, 2);
    }
    const std::uint32_t tile_depth = sample.depth > 1 ? 2 : 1;
    std::vector<std::uint16_t> tile(std::size_t{256} * tile_depth);
    for (std::uint32_t first = 0; first < sample.depth; first += tile_depth) {
      for (std::size_t i = 0; i < tile.size(); ++i) {
        const std::size_t slice = static_cast<std::size_t>(z) * sample.depth + first + i / 256;
        tile[i] = static_cast<std::uint16_t>(100 * slice + i % 16 + 5 * (i / 16 % 16));
      }
      const auto bytes = static_cast<tmsize_t>(2 * tile.size());
      const auto number = TIFFComputeTile(file, 0, 0, first, 0);
      // libtiff encodes the first slice of a tile alone.
      std::string raw(reinterpret_cast<const char*>(tile.data()), static_cast<std::size_t>(bytes));
      if (sample.depth > 1 && sample.compression == COMPRESSION_ADOBE_DEFLATE)
        raw = zlib_bytes(raw);
      written = written &&
                (sample.depth > 1
                     ? TIFFWriteRawTile(file, number, raw.data(), static_cast<tmsize_t>(raw.size()))
                     : TIFFWriteEncodedTile(file, number, tile.data(), bytes)) > 0;
    }
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

/// OME-XML of 2 slices, 3 channels and 1 frame on pages, with `pixels` among the attributes of its
/// Pixels and `blocks` within.
inline std::string ome_xml(const std::string& pixels = "", const std::string& blocks = "") {
  return "<?xml version=\"1.0\"?><!-- a --><OME xmlns=\"http://www.openmicroscopy.org/Schemas/OME/"
         "2016-06\"><Image ID=\"Image:0\"><Pixels ID=\"Pixels:0\" SizeX=\"5\" SizeY=\"4\" "
         "SizeZ=\"2\" SizeC=\"3\" SizeT=\"1\" " +
         pixels + ">" + blocks + "</Pixels></Image></OME>";
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

/// One page with more planes behind its pixels, as ImageJ writes more than 4 GB.
inline std::string one_page_tiff_bytes(int planes, const std::string& description) {
  std::string bytes("II*\0\x08\0\0\0\x08\0", 10);
  const auto number = [](auto value) { return number_bytes(value, Endian::little); };
  const auto length = static_cast<std::uint32_t>(description.size() + 1);
  const std::uint32_t text_at = 8 + 2 + 8 * 12 + 4;
  const auto entry = [&](std::uint16_t tag, std::uint16_t type, std::uint32_t count,
                         std::uint32_t value) {
    bytes += number(tag) + number(type) + number(count) + number(value);
  };
  entry(TIFFTAG_IMAGEWIDTH, TIFF_LONG, 1, 5);
  entry(TIFFTAG_IMAGELENGTH, TIFF_LONG, 1, 4);
  entry(TIFFTAG_BITSPERSAMPLE, TIFF_SHORT, 1, 16);
  entry(TIFFTAG_PHOTOMETRIC, TIFF_SHORT, 1, PHOTOMETRIC_MINISBLACK);
  entry(TIFFTAG_IMAGEDESCRIPTION, TIFF_ASCII, length, text_at);
  entry(TIFFTAG_STRIPOFFSETS, TIFF_LONG, 1, text_at + length);
  entry(TIFFTAG_ROWSPERSTRIP, TIFF_LONG, 1, 4);
  entry(TIFFTAG_STRIPBYTECOUNTS, TIFF_LONG, 1, 40);
  bytes += std::string(4, '\0') + description + '\0';
  for (int z = 0; z < planes; ++z) {
    for (int i = 0; i < 20; ++i) bytes += number(static_cast<std::uint16_t>(100 * z + i));
  }
  return bytes;
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
