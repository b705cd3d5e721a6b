#include "volume/slices/png.h"

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include <png.h>

#include "core/base/errors.h"
#include "volume/base/byte_stream.h"

namespace isoloop {
namespace {

/// What the header states, after small samples are spread to 8 bits and palettes to colours.
struct PngLayout {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::size_t samples = 1;       // a pixel, as decoded
  std::size_t sample_bytes = 1;  // as decoded
  bool has_alpha = false;        // the last sample
};

/// libpng leaves its functions by longjmp where something is wrong: what it passes over on its way
/// to setjmp must have no destructors, so what it writes to belongs to this object.
class Decoder {
 public:
  explicit Decoder(const std::filesystem::path& path)
      : what_(path.string()), file_(path, std::ios::binary) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, keep_message, ignore_message);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw LimitExceeded({.file = what_, .text = "no memory to read it"});
    }
    png_set_read_fn(png_, this, read_bytes);
    // Texts and profiles unpack to far more than their bytes.
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  }
  ~Decoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  PngLayout header() {
    if (!read_header()) fail();
    return layout_;
  }

  /// All pixels, with their samples as decoded. After header().
  void pixels(std::span<std::byte> to) {
    to_ = to;
    if (!read_image()) fail();
  }

 private:
  static void keep_message(png_structp png, png_const_charp text) {
    auto* const self = static_cast<Decoder*>(png_get_error_ptr(png));
    std::strncpy(self->message_.data(), text, self->message_.size() - 1);
    png_longjmp(png, 1);
  }
  static void ignore_message(png_structp /*png*/, png_const_charp /*text*/) {}

  static void read_bytes(png_structp png, png_bytep to, std::size_t count) {
    auto* const self = static_cast<Decoder*>(png_get_io_ptr(png));
    if (!self->file_.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(count))) {
      png_error(png, "it ends early");
    }
  }

  [[noreturn]] void fail() const {
    throw InvalidInput(
        {.file = what_,
         .text = std::string("is no PNG file, or is cut short or damaged (libpng: ") +
                 message_.data() + "); fetch the file again"});
  }

  bool read_header() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    constexpr png_uint_32 most = 0x7fffffff;
    png_set_user_limits(png_, most, most);
    png_read_info(png_, info_);
    png_set_expand(png_);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(png_);
    passes_ = png_set_interlace_handling(png_);
    layout_.width = png_get_image_width(png_, info_);
    layout_.height = png_get_image_height(png_, info_);
    const auto colours = png_get_color_type(png_, info_);
    const bool transparent = png_get_valid(png_, info_, PNG_INFO_tRNS) != 0;
    layout_.has_alpha = transparent || (colours & PNG_COLOR_MASK_ALPHA) != 0;
    layout_.samples = ((colours & PNG_COLOR_MASK_COLOR) != 0 ? 3 : 1) + (layout_.has_alpha ? 1 : 0);
    layout_.sample_bytes = png_get_bit_depth(png_, info_) == 16 ? 2 : 1;
    return true;
  }

  bool read_image() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_update_info(png_, info_);
    const std::size_t row = layout_.width * layout_.samples * layout_.sample_bytes;
    if (png_get_rowbytes(png_, info_) != row) png_error(png_, "rows of another length");
    for (int pass = 0; pass < passes_; ++pass) {
      for (std::size_t y = 0; y < layout_.height; ++y) {
        png_read_row(png_, reinterpret_cast<png_bytep>(to_.data() + y * row), nullptr);
      }
    }
    png_read_end(png_, nullptr);
    return true;
  }

  std::string what_;
  std::array<char, 128> message_{};
  std::ifstream file_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  PngLayout layout_;
  int passes_ = 1;
  std::span<std::byte> to_;
};

/// The grey of each pixel. Throws InvalidInput for a pixel that is not grey or not opaque.
void take_grey(std::span<const std::byte> decoded, const PngLayout& layout, const std::string& what,
               std::span<std::byte> to) {
  const std::size_t size = layout.sample_bytes;
  const std::size_t pixel = layout.samples * size;
  const std::size_t colours = layout.samples - (layout.has_alpha ? 1 : 0);
  constexpr std::array<std::byte, 2> opaque{std::byte{0xff}, std::byte{0xff}};
  for (std::size_t i = 0; i * size < to.size(); ++i) {
    const std::byte* const from = decoded.data() + i * pixel;
    for (std::size_t c = 1; c < colours; ++c) {
      if (std::memcmp(from, from + c * size, size) != 0) {
        throw InvalidInput(
            {.file = what, .text = "holds colour, not one value per pixel; save it as grey"},
            Fault::unsupported);
      }
    }
    if (layout.has_alpha && std::memcmp(from + colours * size, opaque.data(), size) != 0) {
      throw InvalidInput(
          {.file = what, .text = "has transparent pixels; save it as grey without transparency"},
          Fault::unsupported);
    }
    std::copy_n(from, size, to.data() + i * size);
  }
}

}  // namespace

SliceImage png_image(const std::filesystem::path& path) {
  check_is_file(path);
  const PngLayout layout = Decoder(path).header();
  return {layout.width, layout.height,
          layout.sample_bytes == 2 ? StoredType::uint16 : StoredType::uint8};
}

void read_png(const std::filesystem::path& path, const VoxelLimits& limits,
              std::span<std::byte> to) {
  const std::string what = path.string();
  check_is_file(path);
  Decoder decoder(path);
  const PngLayout layout = decoder.header();
  if (layout.samples == 1) return decoder.pixels(to);
  const std::uint64_t pixel = layout.samples * layout.sample_bytes;
  check_voxel_memory({layout.width, layout.height, 1}, pixel, limits.max_bytes, what);
  std::vector<std::byte> decoded(pixel * layout.width * layout.height);
  decoder.pixels(decoded);
  take_grey(decoded, layout, what, to);
}

}  // namespace isoloop
