#include <array>
#include <cmath>
#include <cstring>
#include <ostream>
#include <string>

#include "core/base/errors.h"
#include "volume/base/byte_order.h"
#include "volume/base/byte_sink.h"
#include "volume/formats/nifti.h"
#include "volume/formats/raw.h"

namespace isoloop {
namespace {

constexpr std::size_t header_bytes = 352;  // with the four that say: no extension follows

/// Numbers at fixed places, little-endian.
class Fields {
 public:
  template <class T>
  void put(std::size_t at, T value) {
    if (native_endian != Endian::little) swap_bytes(std::span(&value, 1));
    std::memcpy(bytes_.data() + at, &value, sizeof(T));
  }

  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::array<std::byte, header_bytes> bytes_{};
};

/// In the order of VoxelType.
constexpr std::array<std::int16_t, 8> type_codes{2, 256, 512, 4, 768, 8, 16, 64};

std::uint8_t unit_code(const std::string& unit) {
  return unit == "m" ? 1 : unit == "mm" ? 2 : unit == "µm" ? 3 : 0;
}

/// The sform; a volume that has no place states none.
void put_place(const Volume& volume, Fields& fields) {
  if (volume.frame == Frame::index) return;
  constexpr std::int16_t aligned = 2;
  fields.put<std::int16_t>(254, aligned);
  for (std::size_t row = 0; row < 3; ++row) {
    const double sign = volume.frame == Frame::lps && row < 2 ? -1.0 : 1.0;
    const auto put = [&](std::size_t column, double number) {
      fields.put(280 + 16 * row + 4 * column, static_cast<float>(sign * number));
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
      put(axis, volume.direction[axis][row] * volume.spacing[axis]);
    put(3, volume.origin[row]);
  }
}

Fields header_of(const Volume& volume, const std::string& what) {
  Fields fields;
  const VoxelType type = voxel_type(volume.values);
  fields.put<std::int32_t>(0, 348);
  fields.put<std::int16_t>(40, 3);
  fields.put<float>(76, 1.0F);
  for (std::size_t axis = 0; axis < 7; ++axis) {
    const std::int64_t length = axis < 3 ? volume.dims[axis] : 1;
    if (length > most_nifti_voxels) {
      throw InvalidArgument({.file = what,
                             .text = "NIfTI holds " + std::to_string(most_nifti_voxels) +
                                     " voxels along an axis at most; write a .nrrd"});
    }
    fields.put(42 + 2 * axis, static_cast<std::int16_t>(length));
    fields.put(80 + 4 * axis, static_cast<float>(axis < 3 ? volume.spacing[axis] : 1.0));
  }
  fields.put(70, type_codes[volume.values.index()]);
  fields.put(72, static_cast<std::int16_t>(8 * bytes_per_voxel(type)));
  fields.put<float>(108, static_cast<float>(header_bytes));
  fields.put<float>(112, 1.0F);
  fields.put(123, unit_code(volume.unit));
  put_place(volume, fields);
  constexpr std::array<char, 4> magic{'n', '+', '1', '\0'};
  for (std::size_t i = 0; i < magic.size(); ++i) fields.put(344 + i, magic[i]);
  return fields;
}

}  // namespace

bool nifti_has_unit(const std::string& unit) { return unit_code(unit) != 0; }

void write_nifti(std::ostream& out, const Volume& volume, const std::string& what, bool packed) {
  const Fields header = header_of(volume, what);
  ByteSink sink(out, packed);
  sink.write(header.bytes());
  for_each_little_endian(volume.values,
                         [&](std::span<const std::byte> voxels) { sink.write(voxels); });
  sink.finish();
}

}  // namespace isoloop
