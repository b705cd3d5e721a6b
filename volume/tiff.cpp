#include "volume/tiff.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <tiffio.h>

#include "core/base/errors.h"
#include "volume/header_text.h"
#include "volume/stored_voxels.h"
#include "volume/tiff_pages.h"

namespace isoloop {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& complaint) {
  throw InvalidInput(what + ": " + complaint);
}

/// libtiff's file, and what it complained of last.
class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& path) : what_(path.string()) {
    using Options = std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)>;
    const Options options(TIFFOpenOptionsAlloc(), &TIFFOpenOptionsFree);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_message, &message_);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_message, nullptr);
    tiff_.reset(TIFFOpenExt(path.c_str(), "rm", options.get()));
    if (!tiff_) fail();
  }

  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  TIFF* get() const { return tiff_.get(); }
  const std::string& what() const { return what_; }

  [[noreturn]] void fail() const {
    refuse(what_, "its pixels are damaged (libtiff: " + message_ + "); fetch the file again");
  }

  void open_page(std::uint64_t at) const {
    if (TIFFSetSubDirectory(get(), at) == 0) fail();
  }

  template <class T>
  T field(std::uint32_t tag, T missing) const {
    T value = missing;
    return TIFFGetFieldDefaulted(get(), tag, &value) == 0 ? missing : value;
  }

 private:
  static int keep_message(TIFF* /*file*/, void* to, const char* /*module*/, const char* format,
                          va_list arguments) {
    std::array<char, 256> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    *static_cast<std::string*>(to) = text.data();
    return 1;
  }
  static int ignore_message(TIFF* /*file*/, void* /*to*/, const char* /*module*/,
                            const char* /*format*/, va_list /*arguments*/) {
    return 1;
  }

  std::string what_;
  std::string message_ = "unreadable";
  std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff_{nullptr, &TIFFClose};
};

/// What pages of one volume share.
struct Image {
  std::int64_t width = 0;
  std::int64_t height = 0;
  StoredType type = StoredType::uint8;

  friend bool operator==(const Image&, const Image&) = default;
};

void check_colours(const OpenFile& file) {
  const auto samples = file.field<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL, 1);
  const auto meaning = file.field<std::uint16_t>(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  if (samples != 1 || meaning == PHOTOMETRIC_RGB) {
    refuse(file.what(), "holds " + std::to_string(samples) +
                            " samples per pixel (colour or channels); take one channel");
  }
  const auto compression = file.field<std::uint16_t>(TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  const bool lossy = compression == COMPRESSION_JPEG || compression == COMPRESSION_OJPEG ||
                     compression == COMPRESSION_WEBP;
  if (lossy || TIFFIsCODECConfigured(compression) == 0) {
    refuse(file.what(), "is compressed in a way (" + std::to_string(compression) +
                            ") that isoloop does not read; save it with LZW or without");
  }
}

Image image_of(const OpenFile& file) {
  check_colours(file);
  Image image;
  image.width = file.field<std::uint32_t>(TIFFTAG_IMAGEWIDTH, 0);
  image.height = file.field<std::uint32_t>(TIFFTAG_IMAGELENGTH, 0);
  const auto bits = file.field<std::uint16_t>(TIFFTAG_BITSPERSAMPLE, 1);
  const auto format = file.field<std::uint16_t>(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  const std::uint64_t bytes = bits % 8 == 0 ? bits / 8 : 0;
  std::optional<StoredType> type;
  if (format == SAMPLEFORMAT_IEEEFP) {
    type = float_type(bytes);
  } else if (format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_INT ||
             format == SAMPLEFORMAT_VOID) {
    type = integer_type(bytes, format == SAMPLEFORMAT_INT);
  }
  if (!type || bytes_per_voxel(*type) == 8) {
    if (!type || *type != StoredType::float64) {
      refuse(file.what(), "holds pixels of " + std::to_string(bits) + " bits, sample format " +
                              std::to_string(format) + ", which isoloop does not read");
    }
  }
  image.type = *type;
  return image;
}

/// Decodes whole strips, each of which must come out complete.
void read_strips(const OpenFile& file, std::span<std::byte> page) {
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

void read_tiles(const OpenFile& file, const Image& image, const VoxelLimits& limits,
                std::span<std::byte> page) {
  const std::int64_t width = file.field<std::uint32_t>(TIFFTAG_TILEWIDTH, 0);
  const std::int64_t height = file.field<std::uint32_t>(TIFFTAG_TILELENGTH, 0);
  const std::uint64_t pixel = bytes_per_voxel(image.type);
  if (width < 1 || height < 1) refuse(file.what(), "has tiles of no size");
  check_voxel_memory({width, height, 1}, pixel, limits, file.what());
  std::vector<std::byte> tile(static_cast<std::size_t>(width * height) * pixel);
  for (std::int64_t y = 0; y < image.height; y += height) {
    for (std::int64_t x = 0; x < image.width; x += width) {
      const auto number = TIFFComputeTile(file.get(), static_cast<std::uint32_t>(x),
                                          static_cast<std::uint32_t>(y), 0, 0);
      const auto size = static_cast<tmsize_t>(tile.size());
      if (TIFFReadEncodedTile(file.get(), number, tile.data(), size) != size) file.fail();
      const std::size_t row = static_cast<std::size_t>(std::min(width, image.width - x)) * pixel;
      for (std::int64_t line = 0; line < std::min(height, image.height - y); ++line) {
        const std::size_t from = static_cast<std::size_t>(line * width) * pixel;
        const std::size_t to = static_cast<std::size_t>((y + line) * image.width + x) * pixel;
        std::copy_n(tile.begin() + static_cast<std::ptrdiff_t>(from), row,
                    page.begin() + static_cast<std::ptrdiff_t>(to));
      }
    }
  }
}

VoxelArray empty_values(StoredType type) {
  switch (type) {
    case StoredType::uint8:
      return std::vector<std::uint8_t>{};
    case StoredType::int8:
      return std::vector<std::int8_t>{};
    case StoredType::uint16:
      return std::vector<std::uint16_t>{};
    case StoredType::int16:
      return std::vector<std::int16_t>{};
    case StoredType::uint32:
      return std::vector<std::uint32_t>{};
    case StoredType::int32:
      return std::vector<std::int32_t>{};
    case StoredType::float32:
      return std::vector<float>{};
    default:
      return std::vector<double>{};
  }
}

/// A slice: a page of a file.
struct Slice {
  std::filesystem::path path;
  std::uint64_t at = 0;  // byte of the page's directory
};

/// All slices must be like the first.
VoxelArray read_slices(const std::vector<Slice>& slices, const Image& image,
                       const VoxelLimits& limits) {
  VoxelArray values = empty_values(image.type);
  const auto pixels = static_cast<std::size_t>(image.width * image.height);
  std::visit(
      [&]<class T>(std::vector<T>& voxels) {
        voxels.resize(pixels * slices.size());
        std::optional<OpenFile> file;
        for (std::size_t z = 0; z < slices.size(); ++z) {
          if (!file || file->what() != slices[z].path.string()) file.emplace(slices[z].path);
          file->open_page(slices[z].at);
          if (image_of(*file) != image) {
            refuse(file->what(), "its page " + std::to_string(z) +
                                     " differs from the first in size or type (slices of one "
                                     "volume are alike)");
          }
          const auto page = std::as_writable_bytes(std::span(voxels).subspan(z * pixels, pixels));
          if (TIFFIsTiled(file->get()) != 0) {
            read_tiles(*file, image, limits, page);
          } else {
            read_strips(*file, page);
          }
        }
      },
      values);
  return values;
}

/// The number after "name=" in what ImageJ writes of an image; 1 if it is not there.
std::int64_t stated(const std::string& description, const std::string& name) {
  if (!description.starts_with("ImageJ=")) return 1;
  const std::size_t at = description.find("\n" + name + "=");
  if (at == std::string::npos) return 1;
  const std::string_view rest = std::string_view(description).substr(at + name.size() + 2);
  return whole_number_of(rest.substr(0, rest.find('\n'))).value_or(1);
}

std::vector<Slice> pages_of(const std::filesystem::path& path, VoxelLayout& layout) {
  std::vector<Slice> slices;
  const TiffPages pages = read_tiff_pages(path);
  slices.reserve(pages.at.size());
  for (const std::uint64_t at : pages.at) slices.push_back({path, at});
  const std::string& text = pages.description;
  const auto count = static_cast<std::int64_t>(pages.at.size());
  if (stated(text, "images") > count) {
    refuse(path.string(), "states " + std::to_string(stated(text, "images")) +
                              " images but holds " + std::to_string(count) +
                              " pages; fetch the file again or save it as a plain TIFF");
  }
  if (stated(text, "channels") > 1) {
    refuse(path.string(),
           "holds " + std::to_string(stated(text, "channels")) + " channels; take one of them");
  }
  const std::int64_t frames = stated(text, "frames");
  // Without slices, frames are what somebody calls the slices of a stack.
  if (frames > 1 && stated(text, "slices") > 1) {
    if (count % frames != 0) refuse(path.string(), "has pages that do not fill its frames");
    layout.frames = static_cast<std::uint64_t>(frames);
  }
  return slices;
}

bool is_tiff(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  return (extension == ".tif" || extension == ".tiff") &&
         !path.filename().string().starts_with('.');
}

/// Numbers within names compare by their value: slice_9 comes before slice_10.
bool name_less(const std::string& a, const std::string& b) {
  const auto digits = [](const std::string& text, std::size_t at) {
    const std::size_t end = text.find_first_not_of("0123456789", at);
    return text.substr(at, end == std::string::npos ? end : end - at);
  };
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    std::string x = digits(a, i);
    std::string y = digits(b, j);
    if (x.empty() || y.empty()) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i;
      ++j;
      continue;
    }
    i += x.size();
    j += y.size();
    x.erase(0, std::min(x.find_first_not_of('0'), x.size() - 1));
    y.erase(0, std::min(y.find_first_not_of('0'), y.size() - 1));
    if (x != y) return std::pair(x.size(), x) < std::pair(y.size(), y);
  }
  return std::pair(a.size() - i, a) < std::pair(b.size() - j, b);
}

std::vector<Slice> files_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (is_tiff(entry.path())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
    return name_less(a.filename().string(), b.filename().string());
  });
  std::vector<Slice> slices;
  for (const auto& file : files) {
    const TiffPages pages = read_tiff_pages(file);
    if (pages.at.size() > 1 && files.size() > 1) {
      refuse(file.string(), "has " + std::to_string(pages.at.size()) +
                                " pages; in a folder of slices each file is one page");
    }
    for (const std::uint64_t at : pages.at) slices.push_back({file, at});
  }
  return slices;
}

}  // namespace

Volume read_tiff(const std::filesystem::path& path, const FormatOptions& options,
                 const VoxelLimits& limits) {
  const std::string what = path.string();
  VoxelLayout layout;
  std::vector<Slice> slices =
      std::filesystem::is_directory(path) ? files_of(path) : pages_of(path, layout);
  if (slices.empty()) refuse(what, "holds no .tif or .tiff files");
  Image image;
  {
    const OpenFile first(slices.front().path);
    first.open_page(slices.front().at);
    image = image_of(first);
  }
  const std::size_t depth = slices.size() / layout.frames;
  layout.dims = {image.width, image.height, static_cast<std::int64_t>(depth)};
  layout.type = image.type;
  check_layout(layout, limits, what);
  const std::uint64_t frame = choose_frame(layout, options.frame, what);
  const auto begin = slices.begin() + static_cast<std::ptrdiff_t>(frame * depth);
  slices = std::vector<Slice>(begin, begin + static_cast<std::ptrdiff_t>(depth));
  Volume volume;
  volume.dims = layout.dims;
  place(volume, {}, options.spacing, what);
  if (!options.spacing) {
    volume.notes.emplace_back("a TIFF does not state a spacing in space: 1 unless --spacing says");
  }
  volume.values = read_slices(slices, image, limits);
  return volume;
}

bool holds_tiff(const std::filesystem::path& folder) {
  std::error_code ignored;
  const std::filesystem::directory_iterator entries(folder, ignored);
  return std::any_of(begin(entries), end(entries),
                     [](const auto& entry) { return is_tiff(entry.path()); });
}

}  // namespace isoloop
