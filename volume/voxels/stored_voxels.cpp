#include "volume/voxels/stored_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/errors.h"

namespace isoloop {
namespace {

bool is_identity(const VoxelLayout& layout) {
  return layout.slope == 1.0 && layout.intercept == 0.0;
}

std::uint64_t voxel_count(const Index3& dims) {
  return static_cast<std::uint64_t>(dims[0] * dims[1] * dims[2]);
}

Index3 kept_dims(const VoxelLayout& layout) {
  return layout.part ? layout.part->dims : layout.dims;
}

/// Hands out the rows of a box of voxels from a stream that stands at the first voxel of all, and
/// passes over what lies between them.
class RowReader {
 public:
  RowReader(ByteStream& stream, const Index3& dims, const VoxelBox& box, std::uint64_t voxel_bytes,
            std::string what)
      : stream_(stream),
        start_(stream.position()),
        dims_(dims),
        box_(box),
        voxel_bytes_(voxel_bytes),
        what_(std::move(what)) {}

  void read(std::span<std::byte> to) {
    while (!to.empty()) {
      if (left_ == 0) go_to_next_row();
      const auto now = static_cast<std::size_t>(std::min<std::uint64_t>(left_, to.size()));
      stream_.read(to.first(now), what_);
      left_ -= now;
      to = to.subspan(now);
    }
  }

 private:
  void go_to_next_row() {
    const std::int64_t y = box_.first[1] + row_ % box_.dims[1];
    const std::int64_t z = box_.first[2] + row_ / box_.dims[1];
    const std::int64_t voxel = box_.first[0] + dims_[0] * (y + dims_[1] * z);
    const std::uint64_t at = start_ + static_cast<std::uint64_t>(voxel) * voxel_bytes_;
    stream_.skip(at - stream_.position(), what_);
    left_ = static_cast<std::uint64_t>(box_.dims[0]) * voxel_bytes_;
    ++row_;
  }

  ByteStream& stream_;
  std::uint64_t start_;
  Index3 dims_;
  VoxelBox box_;
  std::uint64_t voxel_bytes_;
  std::string what_;
  std::int64_t row_ = 0;
  std::uint64_t left_ = 0;  // bytes of the row
};

template <class T>
std::vector<T> read_values(const ByteSource& next, std::uint64_t count, Endian endian) {
  std::vector<T> values(count);
  next(std::as_writable_bytes(std::span(values)));
  if (endian != native_endian) swap_bytes(std::span(values));
  return values;
}

// In pieces, so that the wide integers never take memory all at once.
template <class Wide, class Narrow>
std::vector<Narrow> read_wide(const ByteSource& next, std::uint64_t count, Endian endian,
                              const std::string& what) {
  constexpr std::uint64_t piece = 8192;
  std::vector<Narrow> values(count);
  for (std::uint64_t done = 0; done < count;) {
    const std::uint64_t now = std::min(piece, count - done);
    for (const Wide value : read_values<Wide>(next, now, endian)) {
      if (value < std::numeric_limits<Narrow>::min() ||
          value > std::numeric_limits<Narrow>::max()) {
        throw InvalidInput(
            {.file = what,
             .text = "a voxel is " + std::to_string(value) +
                     ", and integers of 64 bits are read only if they fit 32; convert the "
                     "volume to a smaller type"},
            Fault::unsupported);
      }
      values[done++] = static_cast<Narrow>(value);
    }
  }
  return values;
}

template <class To, class From>
std::vector<To> scaled_values(const std::vector<From>& values, double slope, double intercept) {
  std::vector<To> scaled(values.size());
  std::transform(values.begin(), values.end(), scaled.begin(), [&](From value) {
    return static_cast<To>(slope * static_cast<double>(value) + intercept);
  });
  return scaled;
}

// The smallest type for whole numbers between both ends; floating point where none holds them.
template <class From>
VoxelArray scaled_integers(const std::vector<From>& values, double slope, double intercept) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  double least = values.empty() ? 0.0 : slope * static_cast<double>(*low) + intercept;
  double most = values.empty() ? 0.0 : slope * static_cast<double>(*high) + intercept;
  if (least > most) std::swap(least, most);
  const auto fits = [&]<class To>(To) {
    return least >= static_cast<double>(std::numeric_limits<To>::min()) &&
           most <= static_cast<double>(std::numeric_limits<To>::max());
  };
  if (fits(std::int16_t{})) return scaled_values<std::int16_t>(values, slope, intercept);
  if (fits(std::int32_t{})) return scaled_values<std::int32_t>(values, slope, intercept);
  if (fits(std::uint32_t{})) return scaled_values<std::uint32_t>(values, slope, intercept);
  return scaled_values<double>(values, slope, intercept);
}

}  // namespace

std::uint64_t bytes_per_voxel(StoredType type) {
  if (type == StoredType::int64 || type == StoredType::uint64) return 8;
  return bytes_per_voxel(static_cast<VoxelType>(type));
}

std::optional<StoredType> integer_type(std::uint64_t bytes, bool is_signed) {
  switch (bytes) {
    case 1:
      return is_signed ? StoredType::int8 : StoredType::uint8;
    case 2:
      return is_signed ? StoredType::int16 : StoredType::uint16;
    case 4:
      return is_signed ? StoredType::int32 : StoredType::uint32;
    case 8:
      return is_signed ? StoredType::int64 : StoredType::uint64;
    default:
      return std::nullopt;
  }
}

std::optional<StoredType> float_type(std::uint64_t bytes) {
  if (bytes == 4) return StoredType::float32;
  if (bytes == 8) return StoredType::float64;
  return std::nullopt;
}

void check_layout(const VoxelLayout& layout, const VoxelLimits& limits, const std::string& what) {
  if (*std::min_element(layout.dims.begin(), layout.dims.end()) < 1 || layout.frames < 1) {
    throw InvalidInput({.file = what,
                        .text = "its header states the dimensions " + dims_text(layout.dims) +
                                ", which make no volume"});
  }
  const bool wide = layout.type == StoredType::int64 || layout.type == StoredType::uint64;
  const std::uint64_t stored = wide ? 4 : bytes_per_voxel(layout.type);
  // While it is scaled, the volume is there in both types.
  const std::uint64_t scaled = stored < 4 || layout.type == StoredType::float32 ? 4 : 8;
  check_voxel_memory(kept_dims(layout), is_identity(layout) ? stored : stored + scaled, limits,
                     what);
  const std::uint64_t bytes = checked_voxel_bytes(layout.dims, bytes_per_voxel(layout.type), what);
  if (layout.frames > std::numeric_limits<std::int64_t>::max() / bytes) {
    throw InvalidInput({.file = what,
                        .text = "its header states " + std::to_string(layout.frames) +
                                " frames, more than can be counted"});
  }
}

std::uint64_t choose_frame(const VoxelLayout& layout, const std::optional<std::int64_t>& frame,
                           const std::string& what) {
  const std::string last = std::to_string(layout.frames - 1);
  if (!frame) {
    if (layout.frames == 1) return 0;
    throw InvalidArgument(
        {.file = what,
         .text = "holds " + std::to_string(layout.frames) + " frames (4-D), 0 to " + last,
         .advice = {Advice::choose_frame}},
        Option::frame);
  }
  if (*frame < 0 || static_cast<std::uint64_t>(*frame) >= layout.frames) {
    throw InvalidArgument(
        {.file = what,
         .about = Option::frame,
         .text = "counts from 0 to " + last + ": there is no " + std::to_string(*frame)});
  }
  return static_cast<std::uint64_t>(*frame);
}

VoxelArray read_stored(const ByteSource& next, const VoxelLayout& layout, const std::string& what) {
  const std::uint64_t count = voxel_count(kept_dims(layout));
  const Endian endian = layout.endian;
  switch (layout.type) {
    case StoredType::uint8:
      return read_values<std::uint8_t>(next, count, endian);
    case StoredType::int8:
      return read_values<std::int8_t>(next, count, endian);
    case StoredType::uint16:
      return read_values<std::uint16_t>(next, count, endian);
    case StoredType::int16:
      return read_values<std::int16_t>(next, count, endian);
    case StoredType::uint32:
      return read_values<std::uint32_t>(next, count, endian);
    case StoredType::int32:
      return read_values<std::int32_t>(next, count, endian);
    case StoredType::float32:
      return read_values<float>(next, count, endian);
    case StoredType::float64:
      return read_values<double>(next, count, endian);
    case StoredType::int64:
      return read_wide<std::int64_t, std::int32_t>(next, count, endian, what);
    case StoredType::uint64:
      return read_wide<std::uint64_t, std::uint32_t>(next, count, endian, what);
  }
  throw InvalidInput({.file = what, .text = "unknown voxel type"});
}

void read_voxels(ByteStream& stream, const VoxelLayout& layout, std::uint64_t frame,
                 const VoxelLimits& limits, const std::string& what, Volume& volume) {
  check_layout(layout, limits, what);
  const std::uint64_t bytes = voxel_count(layout.dims) * bytes_per_voxel(layout.type);
  const std::string voxels = "its " + dims_text(layout.dims) +
                             (layout.frames > 1 ? " x " + std::to_string(layout.frames) : "") +
                             " voxels";
  stream.check_room(bytes * layout.frames, voxels);
  stream.skip(bytes * frame, voxels);
  const std::uint64_t offset = stream.position();
  if (layout.part) {
    RowReader rows(stream, layout.dims, *layout.part, bytes_per_voxel(layout.type), voxels);
    volume.values = read_stored([&](std::span<std::byte> to) { rows.read(to); }, layout, what);
  } else {
    volume.values =
        read_stored([&](std::span<std::byte> to) { stream.read(to, voxels); }, layout, what);
  }
  stream.skip(offset + bytes * (layout.frames - frame) - stream.position(), voxels);
  stream.expect_end(voxels);
  if (!is_identity(layout))
    volume.values = rescaled(std::move(volume.values), layout.slope, layout.intercept, what);
  else if (bytes == voxel_count(layout.dims) * bytes_per_voxel(voxel_type(volume.values)) &&
           stream.packing() != Packing::zlib)
    volume.stored_at = StoredAt{.file = stream.path(),
                                .first = stream.first(),
                                .packed = stream.packing() == Packing::gzip,
                                .offset = offset,
                                .size = stream.position(),
                                .swapped = layout.endian != native_endian};
  if (layout.part) place_part(volume, *layout.part);
}

void add_scale_note(const VoxelLayout& layout, Volume& volume) {
  if (is_identity(layout)) return;
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "values are %.9g x stored + %.9g", layout.slope,
                layout.intercept);
  volume.notes.push_back({.text = text.data()});
}

VoxelArray rescaled(VoxelArray values, double slope, double intercept, const std::string& what) {
  if (!std::isfinite(slope) || !std::isfinite(intercept) || slope == 0.0) {
    throw InvalidInput({.file = what,
                        .text = "its header scales voxels by slope " + std::to_string(slope) +
                                " and intercept " + std::to_string(intercept) +
                                ", which leaves no values; correct the header"});
  }
  if (slope == 1.0 && intercept == 0.0) return values;
  const bool whole = slope == std::trunc(slope) && intercept == std::trunc(intercept) &&
                     std::abs(slope) <= 65536.0 && std::abs(intercept) <= 1e9;
  return std::visit(
      [&]<class T>(const std::vector<T>& stored) -> VoxelArray {
        if constexpr (std::is_integral_v<T>) {
          if (whole) return scaled_integers(stored, slope, intercept);
        }
        if constexpr (sizeof(T) == 8 || (std::is_integral_v<T> && sizeof(T) == 4)) {
          return scaled_values<double>(stored, slope, intercept);
        } else {
          return scaled_values<float>(stored, slope, intercept);
        }
      },
      values);
}

}  // namespace isoloop
