#include "volume/voxelize/mesh_winding.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <tbb/parallel_for.h>

#include "core/base/errors.h"

namespace isoloop {
namespace {

constexpr std::int64_t steps = 4096;                      // per voxel
constexpr std::int64_t most_dim = std::int64_t{1} << 18;  // products of two lengths fit 63 bits

using Point = std::array<std::int64_t, 3>;  // in steps

/// Twice the signed area of a, b, (y, z) as seen along x.
std::int64_t area(const Point& a, const Point& b, std::int64_t y, std::int64_t z) {
  return (b[1] - a[1]) * (z - a[2]) - (b[2] - a[2]) * (y - a[1]);
}

/// The sign of area() after (y, z) has moved by (ε, ε²): never 0 for an edge that has a length.
bool is_left(std::int64_t area_of_edge, const Point& a, const Point& b) {
  if (area_of_edge != 0) return area_of_edge > 0;
  return a[2] != b[2] ? a[2] > b[2] : b[1] > a[1];
}

struct Crossing {
  std::int64_t row;    // j
  std::int64_t voxel;  // the first voxel of the row beyond it
  int way;             // 1: the row leads in
  bool operator<(const Crossing& other) const {
    return std::tie(row, voxel) < std::tie(other.row, other.voxel);
  }
};

std::int64_t first_at_or_after(std::int64_t coordinate) {
  return coordinate >= 0 ? (coordinate + steps - 1) / steps : -((-coordinate) / steps);
}

/// Crossings of the triangle with the rows of the slice z = k.
void append_crossings(const std::array<Point, 3>& corners, std::int64_t k, const Index3& dims,
                      std::vector<Crossing>& crossings) {
  std::array<Point, 3> p = corners;
  const std::int64_t whole = area(p[0], p[1], p[2][1], p[2][2]);
  if (whole == 0) return;  // seen edge-on
  if (whole < 0) std::swap(p[1], p[2]);
  const auto [low, high] = std::minmax({p[0][1], p[1][1], p[2][1]});
  const std::int64_t z = k * steps;
  const std::int64_t last = std::min(high / steps, dims[1] - 1);
  for (std::int64_t j = std::max<std::int64_t>(first_at_or_after(low), 0); j <= last; ++j) {
    const std::int64_t y = j * steps;
    const std::array<std::int64_t, 3> parts{area(p[1], p[2], y, z), area(p[2], p[0], y, z),
                                            area(p[0], p[1], y, z)};
    if (!is_left(parts[0], p[1], p[2]) || !is_left(parts[1], p[2], p[0]) ||
        !is_left(parts[2], p[0], p[1])) {
      continue;
    }
    double x = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      x += static_cast<double>(parts[c]) * static_cast<double>(p[c][0]);
    }
    x /= static_cast<double>(std::abs(whole)) * static_cast<double>(steps);
    const auto voxel = static_cast<std::int64_t>(std::ceil(x));
    // The outward normal of an anticlockwise triangle looks along x: the row leads out.
    crossings.push_back({j, std::clamp<std::int64_t>(voxel, 0, dims[0]), whole > 0 ? -1 : 1});
  }
}

struct SliceResult {
  int least = 0;
  int most = 0;
};

/// Negates the inside voxels of one slice.
SliceResult sweep(std::vector<Crossing>& crossings, float* slice, const Index3& dims,
                  InsideOf rule) {
  std::sort(crossings.begin(), crossings.end());
  SliceResult result;
  int winding = 0;
  std::int64_t passed = 0;
  for (std::size_t c = 0; c < crossings.size(); ++c) {
    const Crossing& crossing = crossings[c];
    const bool new_row = c == 0 || crossings[c - 1].row != crossing.row;
    if (new_row) {
      winding = 0;
      passed = 0;
    }
    winding += crossing.way;
    ++passed;
    const bool last = c + 1 == crossings.size() || crossings[c + 1].row != crossing.row;
    const std::int64_t end = last ? dims[0] : crossings[c + 1].voxel;
    if (end == crossing.voxel || last) continue;  // beyond the last crossing is outside
    result.least = std::min(result.least, winding);
    result.most = std::max(result.most, winding);
    const bool inside = rule == InsideOf::winding ? winding != 0 : passed % 2 != 0;
    float* const row = slice + dims[0] * crossing.row;
    if (inside) std::for_each(row + crossing.voxel, row + end, [](float& v) { v = -v; });
  }
  return result;
}

/// Triangles by slice: those of slice k are triangles[first[k]] to triangles[first[k + 1]].
struct Slices {
  std::vector<std::size_t> first;
  std::vector<std::uint32_t> triangles;
};

std::pair<std::int64_t, std::int64_t> slices_of(const std::array<Point, 3>& p, const Index3& dims) {
  const auto [low, high] = std::minmax({p[0][2], p[1][2], p[2][2]});
  return {std::max<std::int64_t>(first_at_or_after(low), 0), std::min(high / steps, dims[2] - 1)};
}

}  // namespace

WindingResult negate_inside(std::vector<float>& values, const Index3& dims, const Mesh& mesh,
                            const std::vector<Vec3>& index_points, InsideOf rule,
                            std::uint64_t max_bytes, const std::string& what) {
  if (std::max({dims[0], dims[1], dims[2]}) > most_dim) {
    throw LimitExceeded({.file = what,
                         .text = "more than 262144 voxels along an axis",
                         .advice = {Advice::take_larger_voxels}},
                        {.unit = Excess::Unit::voxels});
  }
  const auto corners = [&](std::size_t t) {
    std::array<Point, 3> p{};
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t a = 0; a < 3; ++a) {
        p[c][a] = std::llround(index_points[mesh.triangles[t][c]][a] * static_cast<double>(steps));
      }
    }
    return p;
  };
  const auto slice_count = static_cast<std::size_t>(dims[2]);
  Slices slices{.first = std::vector<std::size_t>(slice_count + 1), .triangles = {}};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [low, high] = slices_of(corners(t), dims);
    for (std::int64_t k = low; k <= high; ++k) ++slices.first[static_cast<std::size_t>(k) + 1];
  }
  for (std::size_t k = 0; k < slice_count; ++k) slices.first[k + 1] += slices.first[k];
  if (slices.first.back() > max_bytes / sizeof(std::uint32_t)) {
    throw LimitExceeded({.file = what,
                         .text = "its triangles cross so many slices of voxels that they take more "
                                 "memory than the limit",
                         .advice = {Advice::raise_memory_limit, Advice::take_larger_voxels}},
                        {.unit = Excess::Unit::bytes,
                         .needed = slices.first.back() * sizeof(std::uint32_t),
                         .limit = max_bytes,
                         .stage = "read"});
  }
  slices.triangles.resize(slices.first.back());
  std::vector<std::size_t> next(slices.first.begin(), slices.first.end() - 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [low, high] = slices_of(corners(t), dims);
    for (std::int64_t k = low; k <= high; ++k) {
      slices.triangles[next[static_cast<std::size_t>(k)]++] = static_cast<std::uint32_t>(t);
    }
  }
  std::vector<SliceResult> results(slice_count);
  tbb::parallel_for(std::size_t{0}, slice_count, [&](std::size_t k) {
    std::vector<Crossing> crossings;
    for (std::size_t i = slices.first[k]; i < slices.first[k + 1]; ++i) {
      append_crossings(corners(slices.triangles[i]), static_cast<std::int64_t>(k), dims, crossings);
    }
    const std::size_t slice_voxels = static_cast<std::size_t>(dims[0] * dims[1]);
    results[k] = sweep(crossings, values.data() + slice_voxels * k, dims, rule);
  });
  int least = 0;
  int most = 0;
  for (const SliceResult& result : results) {
    least = std::min(least, result.least);
    most = std::max(most, result.most);
  }
  return {.twice = least < -1 || most > 1, .opposite = least < 0 && most > 0};
}

}  // namespace isoloop
