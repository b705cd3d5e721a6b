#include "volume/slices/bmp.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "volume/base/byte_order.h"
#include "volume/base/byte_stream.h"
#include "volume/base/refuse.h"

namespace isoloop {
namespace {

struct BmpHeader {
  SliceImage image{};
  bool top_down = false;
  std::uint64_t bits = 8;        // a pixel: 8 or 24
  std::uint64_t pixels_at = 0;   // byte of the file
  std::uint64_t row_bytes = 0;   // padded to four
  std::vector<std::byte> greys;  // of a palette's colours
};

/// Numbers of a header, little-endian.
class Fields {
 public:
  explicit Fields(std::span<const std::byte> bytes) : bytes_(bytes) {}
  template <class T>
  T at(std::size_t byte) const {
    return load<T>(bytes_, byte, Endian::little);
  }

 private:
  std::span<const std::byte> bytes_;
};

constexpr std::size_t file_header_bytes = 14;

/// Sizes and the sort of pixels. `bytes`: the headers.
void set_image(const Fields& fields, bool is_core, BmpHeader& header, const std::string& what) {
  const std::int64_t width = is_core ? fields.at<std::uint16_t>(18) : fields.at<std::int32_t>(18);
  const std::int64_t height = is_core ? fields.at<std::uint16_t>(20) : fields.at<std::int32_t>(22);
  header.bits = fields.at<std::uint16_t>(is_core ? 24 : 28);
  const std::uint32_t packing = is_core ? 0 : fields.at<std::uint32_t>(30);
  if (packing != 0 || (header.bits != 8 && header.bits != 24)) {
    refuse(what,
           "holds pixels of " + std::to_string(header.bits) + " bits, compression " +
               std::to_string(packing) +
               "; isoloop reads 8 and 24 bits without compression: save it as such or as "
               "PNG or TIFF",
           Fault::unsupported);
  }
  header.top_down = height < 0;
  header.image = {width, height < 0 ? -height : height, StoredType::uint8};
  if (width < 1 || height == 0) refuse(what, "is an image of no size; fetch the file again");
  header.row_bytes = (static_cast<std::uint64_t>(width) * header.bits + 31) / 32 * 4;
}

std::vector<std::byte> greys_of(std::span<const std::byte> palette, std::size_t entry,
                                const std::string& what) {
  std::vector<std::byte> greys;
  for (std::size_t i = 0; i + entry <= palette.size(); i += entry) {
    if (palette[i] != palette[i + 1] || palette[i] != palette[i + 2]) {
      refuse(what, "holds a palette of colours, not grey; save it as grey", Fault::unsupported);
    }
    greys.push_back(palette[i]);
  }
  return greys;
}

BmpHeader read_header(ByteStream& stream, const std::string& what) {
  const std::uint64_t size = stream.most_left();
  std::array<std::byte, 138> bytes{};
  const std::span<std::byte> start(bytes);
  stream.read(start.first(file_header_bytes + 4), "its header");
  if (bytes[0] != std::byte{'B'} || bytes[1] != std::byte{'M'}) refuse(what, "is no BMP file");
  const Fields fields(start);
  const auto own = fields.at<std::uint32_t>(14);
  if (own != 12 && (own < 40 || own > 124)) {
    refuse(what, "has a header of " + std::to_string(own) + " bytes, which isoloop does not read",
           Fault::unsupported);
  }
  stream.read(start.subspan(file_header_bytes + 4, own - 4), "its header");
  BmpHeader header;
  header.pixels_at = fields.at<std::uint32_t>(10);
  set_image(fields, own == 12, header, what);
  const std::uint64_t palette_at = file_header_bytes + own;
  if (header.bits == 8) {
    const std::uint64_t stated = own == 12 ? 0 : fields.at<std::uint32_t>(46);
    if (stated > 256) refuse(what, "states a palette of more than 256 colours", Fault::unsupported);
    const std::uint64_t entry = own == 12 ? 3 : 4;
    std::vector<std::byte> palette((stated == 0 ? 256 : stated) * entry);
    stream.read(palette, "its palette");
    if (header.pixels_at < palette_at + palette.size()) {
      refuse(what, "states pixels within its palette; fetch the file again");
    }
    header.greys = greys_of(palette, entry, what);
  }
  if (header.pixels_at < palette_at) refuse(what, "states pixels within its header");
  // Both factors are below 2^33 and 2^31.
  const std::uint64_t pixels = header.row_bytes * static_cast<std::uint64_t>(header.image.height);
  if (header.pixels_at > size || pixels > size - header.pixels_at) {
    refuse(what, "has " + std::to_string(size) + " bytes, but its pixels end at byte " +
                     std::to_string(header.pixels_at + pixels) + "; fetch the file again");
  }
  return header;
}

void take_row(std::span<const std::byte> row, const BmpHeader& header, const std::string& what,
              std::span<std::byte> to) {
  for (std::size_t x = 0; x < to.size(); ++x) {
    if (header.bits == 8) {
      const auto index = std::to_integer<std::size_t>(row[x]);
      if (index >= header.greys.size()) refuse(what, "holds a pixel that its palette does not");
      to[x] = header.greys[index];
    } else {
      const std::span<const std::byte> pixel = row.subspan(3 * x, 3);
      if (pixel[0] != pixel[1] || pixel[0] != pixel[2]) {
        refuse(what, "holds colour, not one value per pixel; save it as grey", Fault::unsupported);
      }
      to[x] = pixel[0];
    }
  }
}

}  // namespace

SliceImage bmp_image(const std::filesystem::path& path) {
  check_is_file(path);
  ByteStream stream(path, Packing::plain);
  return read_header(stream, path.string()).image;
}

void read_bmp(const std::filesystem::path& path, std::span<std::byte> to) {
  const std::string what = path.string();
  check_is_file(path);
  ByteStream stream(path, Packing::plain);
  const BmpHeader header = read_header(stream, what);
  stream.skip(header.pixels_at - stream.position(), "what lies before its pixels");
  const auto width = static_cast<std::size_t>(header.image.width);
  const auto height = static_cast<std::size_t>(header.image.height);
  std::vector<std::byte> row(header.row_bytes);
  for (std::size_t y = 0; y < height; ++y) {
    stream.read(row, "its pixels");
    const std::size_t line = header.top_down ? y : height - 1 - y;
    take_row(row, header, what, to.subspan(line * width, width));
  }
}

}  // namespace isoloop
