#include "volume/voxels/volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <type_traits>

#include "volume/voxels/value_range.h"

namespace isoloop {
namespace {

struct TypeWords {
  std::string_view name;
  std::string_view short_name;
  std::uint64_t bytes;
};

constexpr std::array<TypeWords, 8> type_words{{{"uint8", "u8", 1},
                                               {"int8", "i8", 1},
                                               {"uint16", "u16", 2},
                                               {"int16", "i16", 2},
                                               {"uint32", "u32", 4},
                                               {"int32", "i32", 4},
                                               {"float32", "f32", 4},
                                               {"float64", "f64", 8}}};
static_assert(std::variant_size_v<VoxelArray> == type_words.size());

const TypeWords& words_of(VoxelType type) { return type_words.at(static_cast<std::size_t>(type)); }

template <class T>
bool is_nan(T value) {
  if constexpr (std::is_floating_point_v<T>) return std::isnan(value);
  return false;
}

template <class Iterator>
Iterator first_number(Iterator begin, Iterator end) {
  return std::find_if(begin, end, [](auto value) { return !is_nan(value); });
}

/// Adds the values up to `end`, each once, or until they are more than most_distinct. Returns where
/// it stopped.
template <class Iterator, class T>
Iterator collect_distinct(Iterator begin, Iterator end, std::vector<T>& distinct) {
  T last = *begin;  // neighbours are often equal
  distinct.push_back(last);
  for (; begin != end && distinct.size() <= most_distinct; ++begin) {
    if (*begin == last || is_nan(*begin)) continue;
    last = *begin;
    if (std::find(distinct.begin(), distinct.end(), last) == distinct.end()) {
      distinct.push_back(last);
    }
  }
  return begin;
}

}  // namespace

AnyGridView view(const Volume& volume) {
  return std::visit(
      [&]<class T>(const std::vector<T>& values) -> AnyGridView {
        return GridView<T>{values, volume.dims, volume.spacing};
      },
      volume.values);
}

Vec3 to_world(const Volume& volume, const Vec3& index) {
  Vec3 world = volume.origin;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double length = index[axis] * volume.spacing[axis];
    for (std::size_t c = 0; c < 3; ++c) world[c] += length * volume.direction[axis][c];
  }
  return world;
}

std::vector<std::vector<Vec3>> to_world(const Volume& volume,
                                        std::vector<std::vector<Vec3>> curves) {
  for (std::vector<Vec3>& curve : curves)
    for (Vec3& point : curve) point = to_world(volume, point);
  return curves;
}

bool frame_mirrors(const Volume& volume) {
  const auto& [a, b, c] = volume.direction;
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]) <
         0.0;
}

VoxelType voxel_type(const VoxelArray& values) { return static_cast<VoxelType>(values.index()); }

std::uint64_t bytes_per_voxel(VoxelType type) { return words_of(type).bytes; }

std::string type_name(VoxelType type) { return std::string(words_of(type).name); }

std::string type_name(const VoxelArray& values) { return type_name(voxel_type(values)); }

std::string frame_name(Frame frame) {
  switch (frame) {
    case Frame::index:
      return "index";
    case Frame::world:
      return "world";
    case Frame::lps:
      return "LPS";
    case Frame::ras:
      return "RAS";
  }
  return "index";
}

std::optional<VoxelType> parse_voxel_type(std::string_view name) {
  for (std::size_t i = 0; i < type_words.size(); ++i) {
    if (name == type_words[i].name || name == type_words[i].short_name) {
      return static_cast<VoxelType>(i);
    }
  }
  return std::nullopt;
}

ValueRange value_range(const Volume& volume) { return value_range(view(volume)); }

ValueRange value_range(const AnyGridView& grid) {
  return std::visit(
      []<class T>(const GridView<T>& view) {
        const std::span<const T> values = view.values;
        std::vector<T> distinct;  // in the order in which they are met
        const auto begin = first_number(values.begin(), values.end());
        if (begin == values.end()) return ValueRange{};
        const auto many = collect_distinct(begin, values.end(), distinct);
        T low = *std::min_element(distinct.begin(), distinct.end());
        T high = *std::max_element(distinct.begin(), distinct.end());
        for (auto value = many; value != values.end(); ++value) {
          if (is_nan(*value)) continue;
          low = std::min(low, *value);
          high = std::max(high, *value);
        }
        ValueRange range{static_cast<double>(low), static_cast<double>(high), {}};
        if (distinct.size() > most_distinct) return range;
        std::sort(distinct.begin(), distinct.end());
        range.distinct.assign(distinct.begin(), distinct.end());
        return range;
      },
      grid);
}

}  // namespace isoloop
