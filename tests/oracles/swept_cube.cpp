#include "tests/oracles/swept_cube.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace isoloop::oracle {
namespace {

constexpr std::array<std::size_t, 4> edge_of{0, 2, 6, 4};  // the edges along x, in ring order

std::array<double, 4> slice_at(const std::array<double, 8>& f, double x) {
  std::array<double, 4> slice{};
  for (std::size_t i = 0; i < 4; ++i) slice[i] = f[edge_of[i]] * (1 - x) + f[edge_of[i] + 1] * x;
  return slice;
}

/// Where the slices change: at the ends, where an edge or the saddle is 0.
std::vector<double> events(const std::array<double, 8>& f) {
  std::vector<double> at{0.0, 1.0};
  for (const std::size_t edge : edge_of)
    if ((f[edge] >= 0) != (f[edge + 1] >= 0)) at.push_back(f[edge] / (f[edge] - f[edge + 1]));
  const auto saddle = [&](double x) {
    const auto s = slice_at(f, x);
    return s[0] * s[2] - s[1] * s[3];
  };
  // A parabola through three points: c + b x + a x^2.
  const double c = saddle(0);
  const double a = 2 * (saddle(1) - 2 * saddle(0.5) + c);
  const double b = saddle(1) - a - c;
  const double discriminant = b * b - 4 * a * c;
  if (discriminant > 0) {
    const double t = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    for (const double root : {t / a, c / t})
      if (root > 0 && root < 1) at.push_back(root);
  }
  std::sort(at.begin(), at.end());
  return at;
}

/// For each edge the first edge of its part of the slice.
std::array<int, 4> parts_of(const std::array<double, 4>& slice) {
  std::array<int, 4> part{0, 1, 2, 3};
  const auto merge = [&](std::size_t a, std::size_t b) {
    std::replace(part.begin(), part.end(), std::max(part[a], part[b]), std::min(part[a], part[b]));
  };
  const auto inside = [&](std::size_t i) { return slice[i % 4] >= 0; };
  for (std::size_t i = 0; i < 4; ++i)
    if (inside(i) == inside(i + 1)) merge(i, (i + 1) % 4);
  if (inside(0) == inside(2) && inside(1) == inside(3) && inside(0) != inside(1)) {
    const std::size_t in = inside(0) ? 0 : 1;
    const bool joined = slice[in] * slice[in + 2] > slice[1 - in] * slice[3 - in];
    const std::size_t first = joined ? in : 1 - in;
    merge(first, first + 2);
  }
  return part;
}

}  // namespace

SweptCube sweep(const std::array<double, 8>& values_at_corners, double lowered_by) {
  std::array<double, 8> values = values_at_corners;
  for (double& value : values)
    if (value != 0) value -= lowered_by;
  const std::vector<double> at = events(values);
  std::vector<double> places{0.0};
  for (std::size_t i = 0; i + 1 < at.size(); ++i)
    if (at[i] < at[i + 1]) places.push_back((at[i] + at[i + 1]) / 2);
  places.push_back(1.0);
  // Nodes: 4 * slice + first edge of a part. Links: parts of neighbouring slices on one side that
  // hold a common edge.
  const auto count = 4 * static_cast<int>(places.size());
  std::vector<int> root(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) root[static_cast<std::size_t>(i)] = i;
  std::array<std::set<int>, 2> nodes;
  std::array<std::set<std::pair<int, int>>, 2> links;
  std::array<double, 4> before{};
  for (std::size_t s = 0; s < places.size(); ++s) {
    const std::array<double, 4> slice = slice_at(values, places[s]);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t side = slice[i] >= 0 ? 1 : 0;
      const int node = 4 * static_cast<int>(s) + parts_of(slice)[i];
      nodes[side].insert(node);
      if (s == 0 || (before[i] >= 0) != (slice[i] >= 0)) continue;
      const int last = 4 * static_cast<int>(s - 1) + parts_of(before)[i];
      links[side].insert({last, node});
      const int from = root[static_cast<std::size_t>(node)];
      std::replace(root.begin(), root.end(), from, root[static_cast<std::size_t>(last)]);
    }
    before = slice;
  }
  SweptCube swept;
  for (std::size_t side = 0; side < 2; ++side) {
    std::set<int> parts;
    for (const int node : nodes[side]) parts.insert(root[static_cast<std::size_t>(node)]);
    swept.parts[side] = static_cast<int>(parts.size());
    swept.cycles[side] = static_cast<int>(links[side].size()) -
                         static_cast<int>(nodes[side].size()) + swept.parts[side];
  }
  for (std::size_t i = 0; i < 4; ++i)
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t s = end == 0 ? 0 : places.size() - 1;
      const int node = 4 * static_cast<int>(s) + parts_of(slice_at(values, places[s]))[i];
      swept.part_of_corner[edge_of[i] + end] = root[static_cast<std::size_t>(node)];
    }
  return swept;
}

}  // namespace isoloop::oracle
