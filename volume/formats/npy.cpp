#include "volume/formats/npy.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "volume/base/header_text.h"
#include "volume/base/refuse.h"
#include "volume/voxels/stored_voxels.h"

namespace isoloop {
namespace {

/// The text of the dictionary that describes the array.
std::string read_dictionary(ByteStream& stream, const std::string& what) {
  std::array<std::byte, 8> start{};
  stream.read(start, "its header");
  constexpr std::string_view magic = "\x93NUMPY";
  for (std::size_t i = 0; i < magic.size(); ++i) {
    if (start[i] != static_cast<std::byte>(magic[i])) refuse(what, "is no .npy file");
  }
  const int version = std::to_integer<int>(start[6]);
  if (version < 1 || version > 3)
    refuse(what, "is of a .npy version that isoloop does not know", Fault::unsupported);
  std::array<std::byte, 4> size{};
  stream.read(std::span(size).first(version == 1 ? 2 : 4), "its header");
  const auto bytes = load<std::uint32_t>(size, 0, Endian::little);
  constexpr std::uint32_t most = 1 << 20;
  if (bytes > most) refuse(what, "has a header of " + std::to_string(bytes) + " bytes");
  std::string text(bytes, '\0');
  stream.read(std::as_writable_bytes(std::span(text)), "its header");
  return text;
}

/// What follows 'name': in the dictionary, from its first letter to the text's end.
std::string_view value_of(std::string_view text, const std::string& name, const std::string& what) {
  const std::size_t at = text.find("'" + name + "':");
  if (at == std::string_view::npos) refuse(what, "its header does not state its " + name);
  return trimmed(text.substr(at + name.size() + 3));
}

bool is_fortran(std::string_view text, const std::string& what) {
  const std::string_view value = value_of(text, "fortran_order", what);
  if (value.starts_with("True")) return true;
  if (!value.starts_with("False")) refuse(what, "its header's fortran_order is no bool");
  return false;
}

std::vector<std::int64_t> shape_of(std::string_view text, const std::string& what) {
  const std::string_view value = value_of(text, "shape", what);
  const std::size_t end = value.find(')');
  if (!value.starts_with('(') || end == std::string_view::npos) {
    refuse(what, "its header's shape is no tuple");
  }
  std::string inner(value.substr(1, end - 1));
  std::replace(inner.begin(), inner.end(), ',', ' ');
  return whole_numbers_of(inner, 0, what);
}

bool is_bool(std::string_view text, const std::string& what) {
  return value_of(text, "descr", what).substr(0, 4).ends_with("b1");
}

void set_type(std::string_view text, VoxelLayout& layout, const std::string& what) {
  const std::string_view value = value_of(text, "descr", what);
  const std::size_t end = value.find('\'', 1);
  if (!value.starts_with('\'') || end == std::string_view::npos) {
    refuse(what, "holds records of several fields, not one number per voxel", Fault::unsupported);
  }
  const std::string name(value.substr(1, end - 1));
  if (name.size() != 3)
    refuse(what, "holds values of type '" + name + "', not numbers", Fault::unsupported);
  const char order = name[0];
  const char kind = name[1];
  const auto bytes = static_cast<std::uint64_t>(name[2] - '0');
  layout.endian = order == '>' ? Endian::big : Endian::little;
  std::optional<StoredType> type;
  if (kind == 'b' && bytes == 1) type = StoredType::uint8;
  if (kind == 'u' || kind == 'i') type = integer_type(bytes, kind == 'i');
  if (kind == 'f') type = float_type(bytes);
  const bool ordered = order == '<' || order == '>' || (order == '|' && bytes == 1);
  if (!type || !ordered) {
    refuse(what,
           kind == 'c' ? "holds complex numbers; take their magnitude or phase"
                       : "holds values of type '" + name + "', which isoloop does not read",
           Fault::unsupported);
  }
  layout.type = *type;
}

/// From z fastest to x fastest.
template <class T>
std::vector<T> transposed(const std::vector<T>& values, const Index3& dims) {
  std::vector<T> turned(values.size());
  std::size_t to = 0;
  for (std::int64_t z = 0; z < dims[2]; ++z) {
    for (std::int64_t y = 0; y < dims[1]; ++y) {
      for (std::int64_t x = 0; x < dims[0]; ++x) {
        turned[to++] = values[static_cast<std::size_t>(z + dims[2] * (y + dims[1] * x))];
      }
    }
  }
  return turned;
}

}  // namespace

Volume read_npy(const std::filesystem::path& path, const FormatOptions& options,
                const VoxelLimits& limits) {
  const std::string what = path.string();
  ByteStream stream(path, Packing::plain);
  const std::string text = read_dictionary(stream, what);
  VoxelLayout layout;
  set_type(text, layout, what);
  const bool fortran = is_fortran(text, what);
  std::vector<std::int64_t> shape = shape_of(text, what);
  if (shape.size() < 2 || shape.size() > 4 || (fortran && shape.size() == 4)) {
    refuse(what,
           "is an array of " + std::to_string(shape.size()) +
               " axes; isoloop reads [y, x], [z, y, x] and, in C order, [frame, z, y, x]",
           Fault::unsupported);
  }
  if (*std::min_element(shape.begin(), shape.end()) < 1) refuse(what, "has an axis of no voxels");
  if (shape.size() == 4) {
    layout.frames = static_cast<std::uint64_t>(shape.front());
    shape.erase(shape.begin());
  }
  for (std::size_t axis = 0; axis < shape.size(); ++axis) {
    layout.dims[axis] = shape[shape.size() - 1 - axis];
  }
  if (options.crop && !fortran) layout.part = voxels_in(*options.crop, layout.dims, what);
  check_layout(layout, limits, what);
  // While it is transposed the volume is there twice.
  if (fortran) check_voxel_memory(layout.dims, 2 * bytes_per_voxel(layout.type), limits, what);
  Volume volume;
  volume.dims = layout.dims;
  place(volume, {}, options.spacing, what);
  volume.mask = is_bool(text, what);
  const std::uint64_t frame = choose_frame(layout, options.frame, what);
  read_voxels(stream, layout, frame, limits, what, volume);
  if (fortran) {
    volume.stored_at.reset();
    volume.values = std::visit(
        [&](const auto& values) -> VoxelArray { return transposed(values, volume.dims); },
        volume.values);
  }
  return volume;
}

}  // namespace isoloop
