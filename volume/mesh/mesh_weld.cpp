#include "volume/mesh/mesh_weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "volume/base/rounded_text.h"
#include "volume/mesh/mesh_box.h"
#include "volume/mesh/mesh_closure.h"
#include "volume/mesh/mesh_edges.h"

namespace isoloop {
namespace {

/// The points of open edges, ascending.
std::vector<std::uint32_t> border_points(const Mesh& mesh) {
  std::vector<std::uint32_t> points;
  for_each_edge(edges_of(mesh), [&](std::span<const MeshEdge> sides) {
    if (sides.size() % 2 == 0) return;
    points.push_back(sides[0].low);
    points.push_back(sides[0].high);
  });
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Points that are farther apart than the tolerance, so few to a cell, which is twice as wide.
class Firsts {
 public:
  Firsts(const std::vector<Vec3>& points, const Box& box, double tolerance)
      : points_(points), low_(box.low), tolerance_(tolerance) {}

  /// The one of least number within the tolerance of the point; it is added if there is none.
  std::uint32_t first_near(std::uint32_t point) {
    const Vec3& place = points_[point];
    std::optional<std::uint32_t> found;
    for (unsigned corner = 0; corner < 8; ++corner) {  // of a cube that is as wide as a cell
      Vec3 at = place;
      for (unsigned a = 0; a < 3; ++a) at[a] += (corner >> a & 1U) != 0 ? tolerance_ : -tolerance_;
      const auto cell = cells_.find(key_of(at));
      if (cell == cells_.end()) continue;
      for (const std::uint32_t first : cell->second) {
        if (distance(points_[first], place) <= tolerance_) {
          found = std::min(found.value_or(first), first);
        }
      }
    }
    if (!found) cells_[key_of(place)].push_back(point);
    return found.value_or(point);
  }

 private:
  std::uint64_t key_of(const Vec3& place) const {
    std::uint64_t key = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      // From 0 to 1 / (2 weld_share) and one more on each side: 20 bits.
      const double cell = std::floor((place[a] - low_[a]) / (2.0 * tolerance_)) + 2.0;
      key = key << 21U | static_cast<std::uint64_t>(cell);
    }
    return key;
  }

  const std::vector<Vec3>& points_;
  Vec3 low_;
  double tolerance_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

/// For each point the one that it is joined to: itself, if none.
std::vector<std::uint32_t> joints(const Mesh& mesh, double tolerance) {
  std::vector<std::uint32_t> joint(mesh.points.size());
  std::iota(joint.begin(), joint.end(), 0U);
  Firsts firsts(mesh.points, box_of(mesh), tolerance);
  for (const std::uint32_t point : border_points(mesh)) joint[point] = firsts.first_near(point);
  std::vector<bool> is_kept_apart(mesh.points.size());
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t first = joint[triangle[c]];
      if (first == joint[triangle[(c + 1) % 3]]) is_kept_apart[first] = true;
    }
  }
  for (std::uint32_t p = 0; p < joint.size(); ++p) {
    if (is_kept_apart[joint[p]]) joint[p] = p;
  }
  return joint;
}

}  // namespace

Mesh weld_equal_points(Mesh mesh) {
  for (Vec3& point : mesh.points) {
    for (double& c : point) c += 0.0;  // -0 becomes 0
  }
  std::vector<std::uint32_t> order(mesh.points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return mesh.points[a] != mesh.points[b] ? mesh.points[a] < mesh.points[b] : a < b;
  });
  std::vector<std::uint32_t> first(mesh.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && mesh.points[order[i]] == mesh.points[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) corner = first[corner];
  }
  std::erase_if(mesh.triangles,
                [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  return mesh;
}

Mesh weld_borders(Mesh mesh, const std::string& what) {
  if (mesh.triangles.empty()) return mesh;
  const std::size_t open_edges = closure_of(mesh).open_edges;
  if (open_edges == 0) return mesh;
  const double tolerance = weld_share * diagonal(box_of(mesh));
  if (!std::isnormal(tolerance)) return mesh;  // no extent, or more than doubles can hold
  const std::vector<std::uint32_t> joint = joints(mesh, tolerance);
  std::size_t joined = 0;
  for (std::uint32_t p = 0; p < joint.size(); ++p) joined += joint[p] != p ? 1 : 0;
  if (joined == 0) return mesh;
  std::vector<std::array<std::uint32_t, 3>> before = mesh.triangles;
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) corner = joint[corner];
  }
  const std::size_t left = closure_of(mesh).open_edges;
  if (left >= open_edges) {
    mesh.triangles = std::move(before);
    return mesh;
  }
  mesh.warnings.push_back(
      {.file = what,
       .text = std::to_string(joined) + " corners at open edges lie within " +
               rounded_text(tolerance, 3) +
               " of another, a millionth of the mesh's diagonal, and were taken to be "
               "one with it; that closes " +
               std::to_string(open_edges - left) + " of " + std::to_string(open_edges) +
               " open edges"});
  return mesh;
}

}  // namespace isoloop
