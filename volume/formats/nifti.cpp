#include "volume/formats/nifti.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/errors.h"
#include "volume/base/byte_order.h"
#include "volume/base/refuse.h"
#include "volume/voxels/stored_voxels.h"

namespace isoloop {
namespace {

constexpr std::size_t first_header_bytes = 348;
constexpr std::size_t second_header_bytes = 540;

struct Header {
  bool detached = false;        // voxels lie in an .img file
  std::uint64_t data_from = 0;  // byte of the voxels
  VoxelLayout layout;
  std::array<double, 4> pixdim{};  // the sign of the qform's third axis, and three lengths
  int qform_code = 0;
  int sform_code = 0;
  std::array<double, 6> quaternion{};         // b, c, d and the offset
  std::array<std::array<double, 4>, 3> rows;  // of the sform
  int units = 0;
};

StoredType type_of(int code, int bits, const std::string& what) {
  struct Code {
    int code;
    StoredType type;
  };
  static constexpr std::array<Code, 10> codes{{{2, StoredType::uint8},
                                               {4, StoredType::int16},
                                               {8, StoredType::int32},
                                               {16, StoredType::float32},
                                               {64, StoredType::float64},
                                               {256, StoredType::int8},
                                               {512, StoredType::uint16},
                                               {768, StoredType::uint32},
                                               {1024, StoredType::int64},
                                               {1280, StoredType::uint64}}};
  for (const auto& [number, type] : codes) {
    if (number != code) continue;
    if (bits != static_cast<int>(8 * bytes_per_voxel(type))) {
      refuse(what, "its header states " + std::to_string(bits) + " bits per voxel for datatype " +
                       std::to_string(code) + ", which do not fit");
    }
    return type;
  }
  if (code == 128 || code == 2304)
    refuse(what, "holds colour (RGB) voxels; take one channel", Fault::unsupported);
  if (code == 32 || code == 1792 || code == 2048) {
    refuse(what, "holds complex voxels; take their magnitude or phase", Fault::unsupported);
  }
  refuse(what,
         "holds voxels of NIfTI datatype " + std::to_string(code) +
             ", which isoloop does not read; convert them to float32",
         Fault::unsupported);
}

// Extents along x to z, t and three more axes.
void set_dims(const std::array<std::int64_t, 8>& dim, VoxelLayout& layout,
              const std::string& what) {
  if (dim[0] < 1 || dim[0] > 7) {
    refuse(what, "its header states " + std::to_string(dim[0]) + " dimensions; 1 to 7 make sense",
           Fault::unsupported);
  }
  for (std::size_t axis = 1; axis <= static_cast<std::size_t>(dim[0]); ++axis) {
    if (axis > 3 && dim[axis] == 0) continue;  // programs leave it so where there is no such axis
    if (dim[axis] < 1) {
      refuse(what, "its header states " + std::to_string(dim[axis]) + " voxels along axis " +
                       std::to_string(axis) + "; correct it");
    }
    if (axis <= 3) layout.dims[axis - 1] = dim[axis];
    if (axis == 4) layout.frames = static_cast<std::uint64_t>(dim[axis]);
    if (axis > 4 && dim[axis] > 1) {
      refuse(what,
             "holds " + std::to_string(dim[axis]) +
                 " numbers per voxel (vector or multi-channel); take one channel",
             Fault::unsupported);
    }
  }
}

// Values at fixed places: the two versions differ in the places and the widths.
class Fields {
 public:
  Fields(std::span<const std::byte> bytes, Endian endian) : bytes_(bytes), endian_(endian) {}

  template <class T>
  double number(std::size_t at) const {
    return static_cast<double>(load<T>(bytes_, at, endian_));
  }
  template <class T>
  std::int64_t whole(std::size_t at) const {
    return static_cast<std::int64_t>(load<T>(bytes_, at, endian_));
  }
  template <class T, std::size_t Count>
  void numbers(std::size_t at, std::array<double, Count>& to) const {
    for (std::size_t i = 0; i < Count; ++i) to[i] = number<T>(at + i * sizeof(T));
  }

 private:
  std::span<const std::byte> bytes_;
  Endian endian_;
};

// Places of the fields that both versions have, in bytes.
struct Places {
  std::size_t dim, type, bits, pixdim, slope, codes, quaternion, rows, units;
};
constexpr Places first_places{40, 70, 72, 76, 112, 252, 256, 280, 123};
constexpr Places second_places{16, 12, 14, 104, 176, 344, 352, 400, 500};

template <class Whole, class Number, class Code, class Unit>
void parse(const Fields& fields, const Places& places, Header& header, const std::string& what) {
  std::array<std::int64_t, 8> dim{};
  for (std::size_t i = 0; i < 8; ++i) dim[i] = fields.whole<Whole>(places.dim + i * sizeof(Whole));
  set_dims(dim, header.layout, what);
  header.layout.type = type_of(static_cast<int>(fields.whole<std::int16_t>(places.type)),
                               static_cast<int>(fields.whole<std::int16_t>(places.bits)), what);
  header.layout.slope = fields.number<Number>(places.slope);
  header.layout.intercept = fields.number<Number>(places.slope + sizeof(Number));
  // By the standard a slope of 0 stands for none; common programs write NaN for that.
  if (header.layout.slope == 0.0 || std::isnan(header.layout.slope)) {
    header.layout.slope = 1.0;
    header.layout.intercept = 0.0;
  }
  fields.numbers<Number>(places.pixdim, header.pixdim);
  header.qform_code = static_cast<int>(fields.whole<Code>(places.codes));
  header.sform_code = static_cast<int>(fields.whole<Code>(places.codes + sizeof(Code)));
  fields.numbers<Number>(places.quaternion, header.quaternion);
  for (std::size_t row = 0; row < 3; ++row) {
    fields.numbers<Number>(places.rows + row * 4 * sizeof(Number), header.rows[row]);
  }
  header.units = static_cast<int>(fields.whole<Unit>(places.units));
}

void check_offset(double from, std::size_t least, Header& header, const std::string& what) {
  const double low = header.detached ? 0.0 : static_cast<double>(least);
  if (!(from >= low) || from > 1e15 || from != std::floor(from)) {
    refuse(what,
           "its header states that voxels begin at byte " + std::to_string(from) + "; correct it");
  }
  header.data_from = static_cast<std::uint64_t>(from);
}

bool holds(std::span<const std::byte> bytes, std::size_t at, std::string_view text) {
  return std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                    [](char a, std::byte b) { return static_cast<std::byte>(a) == b; });
}

Header parse_first(std::span<const std::byte> bytes, Endian endian, const std::string& what) {
  Header header;
  header.layout.endian = endian;
  header.detached = holds(bytes, 344, {"ni1\0", 4});
  if (!header.detached && !holds(bytes, 344, {"n+1\0", 4})) {
    refuse(what,
           "is no NIfTI file (perhaps ANALYZE 7.5, which does not say left from right); "
           "convert it to NIfTI",
           Fault::unsupported);
  }
  const Fields fields(bytes, endian);
  parse<std::int16_t, float, std::int16_t, std::uint8_t>(fields, first_places, header, what);
  check_offset(fields.number<float>(108), first_header_bytes + 4, header, what);
  return header;
}

Header parse_second(std::span<const std::byte> bytes, Endian endian, const std::string& what) {
  Header header;
  header.layout.endian = endian;
  header.detached = holds(bytes, 4, {"ni2\0\r\n\032\n", 8});
  if (!header.detached && !holds(bytes, 4, {"n+2\0\r\n\032\n", 8})) {
    refuse(what, "is no NIfTI-2 file: its signature is damaged; fetch the file again");
  }
  const Fields fields(bytes, endian);
  parse<std::int64_t, double, std::int32_t, std::int32_t>(fields, second_places, header, what);
  check_offset(static_cast<double>(fields.whole<std::int64_t>(168)), second_header_bytes + 4,
               header, what);
  return header;
}

/// Leaves `read` at the number of bytes taken from the stream.
Header read_header(ByteStream& stream, std::uint64_t& read, const std::string& what) {
  std::vector<std::byte> bytes(first_header_bytes);
  stream.read(bytes, "its header");
  read = first_header_bytes;
  for (const Endian endian : {Endian::little, Endian::big}) {
    const auto size = load<std::int32_t>(bytes, 0, endian);
    if (size == static_cast<int>(first_header_bytes)) return parse_first(bytes, endian, what);
    if (size != static_cast<int>(second_header_bytes)) continue;
    bytes.resize(second_header_bytes);
    stream.read(std::span(bytes).subspan(first_header_bytes), "its header");
    read = second_header_bytes;
    return parse_second(bytes, endian, what);
  }
  refuse(what, "is no NIfTI file: its header's size is neither 348 nor 540");
}

Placement sform_of(const Header& header) {
  Placement placement{.frame = Frame::ras};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      placement.columns[axis][row] = header.rows[row][axis];
    }
    placement.origin[row] = header.rows[row][3];
  }
  return placement;
}

Placement qform_of(const Header& header) {
  auto [b, c, d, x, y, z] = header.quaternion;
  double a = 1.0 - (b * b + c * c + d * d);
  if (a < 1e-7) {  // a half turn, but for rounding
    const double length = std::sqrt(b * b + c * c + d * d);
    b /= length;
    c /= length;
    d /= length;
    a = 0.0;
  } else {
    a = std::sqrt(a);
  }
  Placement placement{.origin = {x, y, z}, .frame = Frame::ras};
  placement.columns = {
      Vec3{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
      Vec3{2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)},
      Vec3{2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - b * b - c * c}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double turn = axis == 2 && header.pixdim[0] < 0.0 ? -1.0 : 1.0;
    for (double& entry : placement.columns[axis]) entry *= turn * header.pixdim[axis + 1];
  }
  return placement;
}

Vec3 pixdim_of(const Header& header) {
  return {header.pixdim[1], header.pixdim[2], header.pixdim[3]};
}

std::string code_text(const char* form, int code) {
  return std::string(form) + " (code " + std::to_string(code) + ")";
}

// Where both maps are there and put a corner more than a hundredth of a voxel apart.
void compare_forms(const Header& header, bool by_sform, Volume& volume) {
  const double apart = largest_distance(sform_of(header), qform_of(header), volume.dims);
  const double voxel = *std::min_element(volume.spacing.begin(), volume.spacing.end());
  if (apart <= 0.01 * voxel) return;
  volume.warnings.push_back({.text = "sform and qform differ by up to " + std::to_string(apart) +
                                     ": the " + (by_sform ? "sform" : "qform") + " is used",
                             .advice = {by_sform ? Advice::choose_qform : Advice::choose_sform}});
}

void place_volume(const Header& header, const FormatOptions& options, Volume& volume,
                  const std::string& what) {
  const bool has_sform = header.sform_code > 0;
  const bool has_qform = header.qform_code > 0;
  const NiftiTransform wanted = options.transform;
  if ((wanted == NiftiTransform::sform && !has_sform) ||
      (wanted == NiftiTransform::qform && !has_qform)) {
    throw InvalidArgument({.file = what,
                           .text = std::string("its header has no ") +
                                   (wanted == NiftiTransform::sform ? "sform" : "qform")},
                          Option::transform);
  }
  const bool by_sform = has_sform && wanted != NiftiTransform::qform;
  if (by_sform) {
    try {
      place(volume, sform_of(header), options.spacing, what);
    } catch (const InvalidInput& error) {
      if (!has_qform) throw;
      const Vec3 other = pixdim_of(header);
      Finding found = error.finding;
      found.text += "; its qform states the spacing " + std::to_string(other[0]) + " " +
                    std::to_string(other[1]) + " " + std::to_string(other[2]);
      found.advice.push_back(Advice::choose_qform);
      throw InvalidInput(found, error.fault);
    }
  } else if (has_qform) {
    if (!options.spacing) columns_of(pixdim_of(header), what);
    place(volume, qform_of(header), options.spacing, what);
  } else {
    Placement placement;
    if (!options.spacing) placement.columns = columns_of(pixdim_of(header), what);
    place(volume, placement, options.spacing, what);
  }
  if (options.spacing) return;
  volume.notes.push_back(
      {.text =
           by_sform ? "placed by the " + code_text("sform", header.sform_code)
           : has_qform
               ? "placed by the " + code_text("qform", header.qform_code)
               : "the header has neither sform nor qform: the spacing is known, the place is not"});
  if (has_sform && has_qform) compare_forms(header, by_sform, volume);
}

void add_unit(const Header& header, const FormatOptions& options, Volume& volume) {
  constexpr std::array<const char*, 4> units{"", "m", "mm", "micrometres"};
  const auto code = static_cast<std::size_t>(header.units & 7);
  if (code > 0 && code < units.size()) {
    volume.notes.push_back({.text = std::string("lengths are in ") + units[code]});
    if (!options.spacing) volume.unit = code == 3 ? "µm" : units[code];
  }
}

bool is_packed(const std::filesystem::path& path) {
  ByteStream stream(path, Packing::plain);
  std::array<std::byte, 2> magic{};
  if (stream.most_left() < magic.size()) return false;
  stream.read(magic, "its header");
  return magic[0] == std::byte{0x1f} && magic[1] == std::byte{0x8b};
}

/// a.hdr and a.img, each perhaps with .gz after it: the other one of the pair.
std::filesystem::path partner(const std::filesystem::path& path, const std::string& extension) {
  std::filesystem::path stem = path;
  if (stem.extension() == ".gz") stem.replace_extension();
  const std::string own = stem.extension().string();
  const bool upper = own.size() > 1 && own[1] >= 'A' && own[1] <= 'Z';
  std::string wanted = extension;
  if (upper) {
    std::transform(wanted.begin(), wanted.end(), wanted.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  }
  stem.replace_extension(wanted);
  std::filesystem::path packed = stem;
  packed += ".gz";
  return !std::filesystem::exists(stem) && std::filesystem::exists(packed) ? packed : stem;
}

std::string lower_extension(std::filesystem::path path) {
  if (path.extension() == ".gz") path.replace_extension();
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

Packing packing_of(const std::filesystem::path& path) {
  return is_packed(path) ? Packing::gzip : Packing::plain;
}

}  // namespace

Volume read_nifti(const std::filesystem::path& path, const FormatOptions& options,
                  const VoxelLimits& limits) {
  const bool image_named = lower_extension(path) == ".img";
  const std::filesystem::path header_path = image_named ? partner(path, ".hdr") : path;
  const std::string what = path.string();
  check_is_file(header_path);
  ByteStream stream(header_path, packing_of(header_path));
  std::uint64_t read = 0;
  Header header = read_header(stream, read, what);
  if (options.crop) header.layout.part = voxels_in(*options.crop, header.layout.dims, what);
  check_layout(header.layout, limits, what);
  Volume volume;
  volume.dims = header.layout.dims;
  place_volume(header, options, volume, what);
  add_unit(header, options, volume);
  add_scale_note(header.layout, volume);
  const std::uint64_t frame = choose_frame(header.layout, options.frame, what);
  if (header.detached) {
    // Four bytes say whether extensions follow; both may be missing.
    const std::uint64_t rest = stream.skip_rest("its header's extensions");
    if (rest > 0 && rest < 4) refuse(what, "its header ends early; fetch the file again");
    const std::filesystem::path image = partner(header_path, ".img");
    volume.data_file = image_named ? header_path : image;  // the one that was not named
    ByteStream voxels(image, packing_of(image));
    voxels.skip(header.data_from, "what lies before its voxels");
    read_voxels(voxels, header.layout, frame, limits, image.string(), volume);
  } else {
    stream.skip(header.data_from - read, "what lies before its voxels");
    read_voxels(stream, header.layout, frame, limits, what, volume);
  }
  return volume;
}

}  // namespace isoloop
