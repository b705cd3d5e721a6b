#include "volume/slices/tiff_deep_tile.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include <tiffio.h>

#include "core/base/errors.h"

namespace isoloop {
namespace {

/// A file in memory, as libtiff wants one.
struct MemoryFile {
  std::vector<std::byte> bytes;
  std::size_t at = 0;
};

tmsize_t read_some(thandle_t handle, void* to, tmsize_t size) {
  auto& file = *static_cast<MemoryFile*>(handle);
  const std::size_t left = file.at < file.bytes.size() ? file.bytes.size() - file.at : 0;
  const std::size_t count = std::min(left, static_cast<std::size_t>(size));
  std::copy_n(file.bytes.data() + std::min(file.at, file.bytes.size()), count,
              static_cast<std::byte*>(to));
  file.at += count;
  return static_cast<tmsize_t>(count);
}

tmsize_t write_some(thandle_t handle, void* from, tmsize_t size) {
  auto& file = *static_cast<MemoryFile*>(handle);
  const auto count = static_cast<std::size_t>(size);
  file.bytes.resize(std::max(file.bytes.size(), file.at + count));
  std::copy_n(static_cast<const std::byte*>(from), count, file.bytes.data() + file.at);
  file.at += count;
  return size;
}

toff_t seek(thandle_t handle, toff_t offset, int whence) {
  auto& file = *static_cast<MemoryFile*>(handle);
  const std::size_t from = whence == SEEK_SET   ? 0
                           : whence == SEEK_CUR ? file.at
                                                : file.bytes.size();
  file.at = from + static_cast<std::size_t>(offset);
  return file.at;
}

int close_nothing(thandle_t /*handle*/) { return 0; }

toff_t size_of(thandle_t handle) { return static_cast<MemoryFile*>(handle)->bytes.size(); }

struct Closer {
  void operator()(TIFF* file) const { TIFFClose(file); }
};
using Handle = std::unique_ptr<TIFF, Closer>;

int ignore_message(TIFF* /*file*/, void* /*to*/, const char* /*module*/, const char* /*format*/,
                   va_list /*arguments*/) {
  return 1;
}

Handle open_memory(MemoryFile& memory, const char* mode) {
  using Options = std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)>;
  const Options options(TIFFOpenOptionsAlloc(), &TIFFOpenOptionsFree);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), ignore_message, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_message, nullptr);
  memory.at = 0;
  return Handle(TIFFClientOpenExt("tile", mode, &memory, read_some, write_some, seek, close_nothing,
                                  size_of, nullptr, nullptr, options.get()));
}

/// The field of the page, if it states one.
void copy_field(TIFF* from, TIFF* to, std::uint32_t tag) {
  std::uint16_t value = 0;
  if (TIFFGetField(from, tag, &value) != 0) TIFFSetField(to, tag, value);
}

bool write_strip(TIFF* page, TIFF* to, std::uint32_t width, std::uint32_t rows,
                 std::vector<std::byte>& stored) {
  TIFFSetField(to, TIFFTAG_IMAGEWIDTH, width);
  TIFFSetField(to, TIFFTAG_IMAGELENGTH, rows);
  TIFFSetField(to, TIFFTAG_ROWSPERSTRIP, rows);
  TIFFSetField(to, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(to, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(to, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  for (const std::uint32_t tag : {TIFFTAG_BITSPERSAMPLE, TIFFTAG_SAMPLEFORMAT, TIFFTAG_COMPRESSION,
                                  TIFFTAG_FILLORDER, TIFFTAG_PREDICTOR}) {
    copy_field(page, to, tag);
  }
  const auto size = static_cast<tmsize_t>(stored.size());
  return TIFFWriteRawStrip(to, 0, stored.data(), size) == size && TIFFWriteDirectory(to) == 1;
}

}  // namespace

void read_deep_tile(const TiffFile& file, std::uint32_t number, std::uint32_t width,
                    std::uint32_t rows, std::span<std::byte> to) {
  TIFF* const page = file.get();
  std::vector<std::byte> stored(TIFFGetStrileByteCount(page, number));
  const auto bytes = static_cast<tmsize_t>(stored.size());
  if (bytes == 0 || TIFFReadRawTile(page, number, stored.data(), bytes) != bytes) file.fail();
  MemoryFile memory;
  {
    const Handle written = open_memory(memory, TIFFIsBigEndian(page) != 0 ? "wb8" : "wl8");
    if (!written || !write_strip(page, written.get(), width, rows, stored)) file.fail();
  }
  const Handle strip = open_memory(memory, "rm");
  const auto size = static_cast<tmsize_t>(to.size());
  if (!strip || TIFFReadEncodedStrip(strip.get(), 0, to.data(), size) != size) file.fail();
}

}  // namespace isoloop
