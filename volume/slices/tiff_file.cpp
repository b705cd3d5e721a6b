#include "volume/slices/tiff_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <limits>
#include <optional>
#include <vector>

#include <tiffio.h>

#include "volume/base/refuse.h"
#include "volume/slices/tiff_deep_tile.h"

namespace isoloop {
namespace {

int keep_message(TIFF* /*file*/, void* to, const char* /*module*/, const char* format,
                 va_list arguments) {
  std::array<char, 256> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  *static_cast<std::string*>(to) = text.data();
  return 1;
}

int ignore_message(TIFF* /*file*/, void* /*to*/, const char* /*module*/, const char* /*format*/,
                   va_list /*arguments*/) {
  return 1;
}

template <class T>
T field(const TiffFile& file, std::uint32_t tag, T missing) {
  T value = missing;
  return TIFFGetFieldDefaulted(file.get(), tag, &value) == 0 ? missing : value;
}

void check_colours(const TiffFile& file) {
  const auto samples = field<std::uint16_t>(file, TIFFTAG_SAMPLESPERPIXEL, 1);
  const auto meaning = field<std::uint16_t>(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  if (samples != 1 || meaning == PHOTOMETRIC_RGB) {
    refuse(file.what(),
           "holds " + std::to_string(samples) +
               " samples per pixel (colour or channels); take one channel",
           Fault::unsupported);
  }
  const auto compression = field<std::uint16_t>(file, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  const bool lossy = compression == COMPRESSION_JPEG || compression == COMPRESSION_OJPEG ||
                     compression == COMPRESSION_WEBP;
  if (lossy || TIFFIsCODECConfigured(compression) == 0) {
    refuse(file.what(),
           "is compressed in a way (" + std::to_string(compression) +
               ") that isoloop does not read; save it with LZW or without",
           Fault::unsupported);
  }
}

StoredType type_of(const TiffFile& file) {
  const auto bits = field<std::uint16_t>(file, TIFFTAG_BITSPERSAMPLE, 1);
  const auto format = field<std::uint16_t>(file, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  const std::uint64_t bytes = bits % 8 == 0 ? bits / 8 : 0;
  std::optional<StoredType> type;
  if (format == SAMPLEFORMAT_IEEEFP) {
    type = float_type(bytes);
  } else if ((format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_INT ||
              format == SAMPLEFORMAT_VOID) &&
             bytes != 8) {
    type = integer_type(bytes, format == SAMPLEFORMAT_INT);
  }
  if (!type) {
    refuse(file.what(),
           "holds pixels of " + std::to_string(bits) + " bits, sample format " +
               std::to_string(format) + ", which isoloop does not read",
           Fault::unsupported);
  }
  return *type;
}

double resolution(const TiffFile& file, std::uint32_t tag) {
  float value = 0.0F;
  if (TIFFGetField(file.get(), tag, &value) == 0 || !std::isfinite(value)) return 0.0;
  return value;
}

/// Decodes whole strips, each of which must come out complete.
void read_strips(const TiffFile& file, std::span<std::byte> page) {
  const tmsize_t strip_bytes = TIFFStripSize(file.get());
  std::size_t done = 0;
  for (std::uint32_t strip = 0; strip < TIFFNumberOfStrips(file.get()); ++strip) {
    const std::size_t wanted =
        std::min(page.size() - done, static_cast<std::size_t>(std::max<tmsize_t>(strip_bytes, 0)));
    if (wanted == 0) break;
    const auto size = static_cast<tmsize_t>(wanted);
    if (TIFFReadEncodedStrip(file.get(), strip, page.data() + done, size) != size) file.fail();
    done += wanted;
  }
  if (done != page.size()) refuse(file.what(), "has fewer strips than its pixels take");
}

/// Copies what of a tile at `corner` lies within the page.
void place_tile(std::span<const std::byte> tile, const Index3& tile_dims, const Index3& corner,
                const Index3& page_dims, std::uint64_t pixel, std::span<std::byte> page) {
  Index3 kept{};
  for (std::size_t a = 0; a < 3; ++a) kept[a] = std::min(tile_dims[a], page_dims[a] - corner[a]);
  const std::size_t row = static_cast<std::size_t>(kept[0]) * pixel;
  for (std::int64_t z = 0; z < kept[2]; ++z) {
    for (std::int64_t y = 0; y < kept[1]; ++y) {
      const auto from = static_cast<std::size_t>((z * tile_dims[1] + y) * tile_dims[0]) * pixel;
      const auto to =
          static_cast<std::size_t>(((corner[2] + z) * page_dims[1] + corner[1] + y) * page_dims[0] +
                                   corner[0]) *
          pixel;
      std::copy_n(tile.begin() + static_cast<std::ptrdiff_t>(from), row,
                  page.begin() + static_cast<std::ptrdiff_t>(to));
    }
  }
}

void read_tiles(const TiffFile& file, const TiffPage& page, const VoxelLimits& limits,
                std::span<std::byte> to) {
  const Index3 dims{page.image.width, page.image.height, page.depth};
  const Index3 tile_dims{field<std::uint32_t>(file, TIFFTAG_TILEWIDTH, 0),
                         field<std::uint32_t>(file, TIFFTAG_TILELENGTH, 0),
                         field<std::uint32_t>(file, TIFFTAG_TILEDEPTH, 1)};
  const std::uint64_t pixel = bytes_per_voxel(page.image.type);
  if (*std::min_element(tile_dims.begin(), tile_dims.end()) < 1) {
    refuse(file.what(), "has tiles of no size");
  }
  check_voxel_memory(tile_dims, pixel, limits, file.what());
  std::vector<std::byte> tile(checked_voxel_bytes(tile_dims, pixel, file.what()));
  const auto size = static_cast<tmsize_t>(tile.size());
  if (tile_dims[1] * tile_dims[2] > std::numeric_limits<std::uint32_t>::max()) {
    refuse(file.what(), "has tiles of more rows than TIFF counts");
  }
  const auto rows = static_cast<std::uint32_t>(tile_dims[1] * tile_dims[2]);
  for (std::int64_t z = 0; z < dims[2]; z += tile_dims[2]) {
    for (std::int64_t y = 0; y < dims[1]; y += tile_dims[1]) {
      for (std::int64_t x = 0; x < dims[0]; x += tile_dims[0]) {
        const auto number =
            TIFFComputeTile(file.get(), static_cast<std::uint32_t>(x),
                            static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(z), 0);
        if (tile_dims[2] > 1) {
          read_deep_tile(file, number, static_cast<std::uint32_t>(tile_dims[0]), rows, tile);
        } else if (TIFFReadEncodedTile(file.get(), number, tile.data(), size) != size) {
          file.fail();
        }
        place_tile(tile, tile_dims, {x, y, z}, dims, pixel, to);
      }
    }
  }
}

}  // namespace

void TiffFile::Closer::operator()(tiff* file) const { TIFFClose(file); }

TiffFile::TiffFile(const std::filesystem::path& path) : what_(path.string()) {
  using Options = std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)>;
  const Options options(TIFFOpenOptionsAlloc(), &TIFFOpenOptionsFree);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_message, &message_);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_message, nullptr);
  tiff_.reset(TIFFOpenExt(path.c_str(), "rm", options.get()));
  if (!tiff_) fail();
}

void TiffFile::open_page(std::uint64_t at) const {
  if (TIFFSetSubDirectory(get(), at) == 0) fail();
}

void TiffFile::fail() const {
  refuse(what_, "its pixels are damaged (libtiff: " + message_ + "); fetch the file again");
}

TiffPage page_of(const TiffFile& file) {
  check_colours(file);
  TiffPage page;
  page.image.width = field<std::uint32_t>(file, TIFFTAG_IMAGEWIDTH, 0);
  page.image.height = field<std::uint32_t>(file, TIFFTAG_IMAGELENGTH, 0);
  page.image.type = type_of(file);
  page.image.white_is_zero = field<std::uint16_t>(file, TIFFTAG_PHOTOMETRIC,
                                                  PHOTOMETRIC_MINISBLACK) == PHOTOMETRIC_MINISWHITE;
  page.reduced = (field<std::uint32_t>(file, TIFFTAG_SUBFILETYPE, 0) & FILETYPE_REDUCEDIMAGE) != 0;
  page.depth = std::max<std::int64_t>(1, field<std::uint32_t>(file, TIFFTAG_IMAGEDEPTH, 1));
  page.plain =
      field<std::uint16_t>(file, TIFFTAG_COMPRESSION, COMPRESSION_NONE) == COMPRESSION_NONE &&
      field<std::uint16_t>(file, TIFFTAG_FILLORDER, FILLORDER_MSB2LSB) == FILLORDER_MSB2LSB &&
      TIFFIsTiled(file.get()) == 0;
  page.pixels_per_unit_x = resolution(file, TIFFTAG_XRESOLUTION);
  page.pixels_per_unit_y = resolution(file, TIFFTAG_YRESOLUTION);
  page.resolution_unit = field<std::uint16_t>(file, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
  return page;
}

void read_page(const TiffFile& file, const TiffPage& page, const VoxelLimits& limits,
               std::span<std::byte> to) {
  if (TIFFIsTiled(file.get()) != 0) {
    read_tiles(file, page, limits, to);
  } else if (page.depth == 1) {
    read_strips(file, to);
  } else {
    refuse(file.what(),
           "has " + std::to_string(page.depth) +
               " slices in one page (ImageDepth) in strips that isoloop does not "
               "read; save it as a TIFF of pages, or without compression",
           Fault::unsupported);
  }
}

}  // namespace isoloop
