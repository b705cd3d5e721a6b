#include "tools/drawings/simplified_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "core/grid/vec3.h"

namespace isoloop {
namespace {

using Corners = std::array<std::uint32_t, 3>;

Vec3 middle(const Vec3& a, const Vec3& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// Of length twice the triangle's area.
Vec3 normal_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return cross(minus(b, a), minus(c, a));
}

/// Sum of squared distances from planes, each by the area of its triangle: x A x + 2 b x + c.
struct Quadric {
  std::array<double, 6> a{};  // xx xy xz yy yz zz
  Vec3 b{};
  double c = 0.0;

  void add_plane(const Vec3& unit, const Vec3& point, double weight) {
    const double d = -dot(unit, point);
    const auto [x, y, z] = unit;
    const std::array<double, 6> products{x * x, x * y, x * z, y * y, y * z, z * z};
    for (std::size_t i = 0; i < 6; ++i) a[i] += weight * products[i];
    for (std::size_t i = 0; i < 3; ++i) b[i] += weight * d * unit[i];
    c += weight * d * d;
  }

  void add(const Quadric& other) {
    for (std::size_t i = 0; i < 6; ++i) a[i] += other.a[i];
    for (std::size_t i = 0; i < 3; ++i) b[i] += other.b[i];
    c += other.c;
  }

  double at(const Vec3& p) const {
    const auto [x, y, z] = p;
    return a[0] * x * x + a[3] * y * y + a[5] * z * z +
           2 * (a[1] * x * y + a[2] * x * z + a[4] * y * z) + 2 * dot(b, p) + c;
  }

  /// The least point; none where the planes leave a line or a plane of them.
  std::optional<Vec3> least() const {
    const double m00 = a[3] * a[5] - a[4] * a[4];
    const double m01 = a[2] * a[4] - a[1] * a[5];
    const double m02 = a[1] * a[4] - a[2] * a[3];
    const double determinant = a[0] * m00 + a[1] * m01 + a[2] * m02;
    const double trace = a[0] + a[3] + a[5];
    if (!(determinant > 1e-4 * trace * trace * trace)) return std::nullopt;
    const double m11 = a[0] * a[5] - a[2] * a[2];
    const double m12 = a[1] * a[2] - a[0] * a[4];
    const double m22 = a[0] * a[3] - a[1] * a[1];
    return Vec3{-(m00 * b[0] + m01 * b[1] + m02 * b[2]) / determinant,
                -(m01 * b[0] + m11 * b[1] + m12 * b[2]) / determinant,
                -(m02 * b[0] + m12 * b[1] + m22 * b[2]) / determinant};
  }
};

struct Collapse {
  double cost = 0.0;
  std::uint32_t keep = 0;
  std::uint32_t drop = 0;
  std::uint32_t changes = 0;  // of both ends when this was put down
  Vec3 place{};

  /// The least cost comes out of a std::priority_queue first.
  bool operator<(const Collapse& other) const {
    return std::tie(cost, keep, drop, changes) >
           std::tie(other.cost, other.keep, other.drop, other.changes);
  }
};

class Simplifier {
 public:
  Simplifier(TriangleMesh mesh, HandleRule handles)
      : mesh_(std::move(mesh)),
        handles_(handles),
        left_(mesh_.triangles.size()),
        fans_(mesh_.points.size()),
        quadrics_(mesh_.points.size()),
        changes_(mesh_.points.size()),
        is_fixed_(mesh_.points.size()) {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const std::uint32_t corner : mesh_.triangles[t]) fans_[corner].push_back(t);
    sum_quadrics();
    std::vector<std::uint32_t> around;
    for (std::uint32_t v = 0; v < fans_.size(); ++v) {
      neighbours(v, around);
      is_fixed_[v] = around.size() == fans_[v].size() ? 0 : 1;  // a fan that does not close
    }
    for (const Corners& corners : mesh_.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        if (corners[i] < corners[(i + 1) % 3]) propose(corners[i], corners[(i + 1) % 3]);
  }

  void reduce(std::size_t most_triangles) {
    while (left_ > most_triangles && !queue_.empty()) {
      const Collapse next = queue_.top();
      queue_.pop();
      if (next.changes != changes_[next.keep] + changes_[next.drop]) continue;
      if (fans_[next.keep].empty() || fans_[next.drop].empty()) continue;
      if (may_go(next)) collapse(next);
    }
  }

  TriangleMesh result() {
    TriangleMesh result;
    std::vector<std::uint32_t> number(mesh_.points.size());
    for (std::size_t v = 0; v < number.size(); ++v) {
      number[v] = static_cast<std::uint32_t>(result.points.size());
      if (fans_[v].empty()) continue;
      result.points.push_back(mesh_.points[v]);
      result.sources.push_back(mesh_.sources[v]);
    }
    for (const Corners& corners : mesh_.triangles) {
      if (corners[0] == corners[1]) continue;
      result.triangles.push_back({number[corners[0]], number[corners[1]], number[corners[2]]});
    }
    return result;
  }

 private:
  void sum_quadrics() {
    for (const auto& [a, b, c] : mesh_.triangles) {
      const Vec3 normal = normal_of(mesh_.points[a], mesh_.points[b], mesh_.points[c]);
      const double length = std::sqrt(dot(normal, normal));
      if (!(length > 0)) continue;
      const Vec3 unit{normal[0] / length, normal[1] / length, normal[2] / length};
      for (const std::uint32_t v : {a, b, c})
        quadrics_[v].add_plane(unit, mesh_.points[a], length / 2);
    }
  }

  /// Ascending, each once.
  void neighbours(std::uint32_t v, std::vector<std::uint32_t>& found) const {
    found.clear();
    for (const std::uint32_t t : fans_[v])
      for (const std::uint32_t corner : mesh_.triangles[t])
        if (corner != v) found.push_back(corner);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }

  void propose(std::uint32_t a, std::uint32_t b) {
    if (is_fixed_[a] != 0 || is_fixed_[b] != 0) return;
    Quadric sum = quadrics_[a];
    sum.add(quadrics_[b]);
    const Vec3& p = mesh_.points[a];
    const Vec3& q = mesh_.points[b];
    const Vec3 edge = minus(q, p);
    Vec3 place = middle(p, q);
    const std::optional<Vec3> least = sum.least();
    if (least) {
      const Vec3 away = minus(*least, place);
      if (dot(away, away) <= dot(edge, edge)) place = *least;
    }
    for (const Vec3& end : {p, q})
      if (sum.at(end) < sum.at(place)) place = end;
    // On a plane every place costs nothing: short edges go first.
    const double cost = std::max(0.0, sum.at(place)) + 1e-6 * dot(edge, edge);
    queue_.push({cost, a, b, changes_[a] + changes_[b], place});
  }

  bool may_go(const Collapse& edge) {
    neighbours(edge.keep, around_keep_);
    neighbours(edge.drop, around_drop_);
    common_.clear();
    std::set_intersection(around_keep_.begin(), around_keep_.end(), around_drop_.begin(),
                          around_drop_.end(), std::back_inserter(common_));
    if (handles_ == HandleRule::keep && common_.size() != 2) return false;
    if (around_keep_.size() == 3 && around_drop_.size() == 3) return false;  // a tetrahedron
    // Where handles may go, no component may.
    if (handles_ == HandleRule::drop_small && (around_keep_.size() < 4 || around_drop_.size() < 4))
      return false;
    return !turns_over(edge.keep, edge.drop, edge.place) &&
           !turns_over(edge.drop, edge.keep, edge.place);
  }

  /// Whether a triangle at `moved` that stays would turn too far.
  bool turns_over(std::uint32_t moved, std::uint32_t other, const Vec3& place) const {
    for (const std::uint32_t t : fans_[moved]) {
      const Corners& corners = mesh_.triangles[t];
      if (std::find(corners.begin(), corners.end(), other) != corners.end()) continue;
      std::array<Vec3, 3> after{};
      for (std::size_t i = 0; i < 3; ++i)
        after[i] = corners[i] == moved ? place : mesh_.points[corners[i]];
      const Vec3 was =
          normal_of(mesh_.points[corners[0]], mesh_.points[corners[1]], mesh_.points[corners[2]]);
      const Vec3 is = normal_of(after[0], after[1], after[2]);
      if (dot(was, is) <= 0.3 * std::sqrt(dot(was, was) * dot(is, is))) return true;
    }
    return false;
  }

  void collapse(const Collapse& edge) {
    const auto [cost, keep, drop, changes, place] = edge;
    mesh_.points[keep] = place;
    quadrics_[keep].add(quadrics_[drop]);
    const auto has = [&](std::uint32_t t, std::uint32_t v) {
      const Corners& corners = mesh_.triangles[t];
      return std::find(corners.begin(), corners.end(), v) != corners.end();
    };
    for (const std::uint32_t t : fans_[drop]) {
      if (!has(t, keep)) continue;
      for (const std::uint32_t corner : mesh_.triangles[t])
        if (corner != drop) std::erase(fans_[corner], t);
      mesh_.triangles[t] = {keep, keep, keep};
      --left_;
    }
    for (const std::uint32_t t : fans_[drop]) {
      if (!has(t, drop)) continue;  // gone
      Corners& corners = mesh_.triangles[t];
      std::replace(corners.begin(), corners.end(), drop, keep);
      fans_[keep].push_back(t);
    }
    fans_[drop] = {};
    ++changes_[keep];
    neighbours(keep, around_keep_);
    for (const std::uint32_t v : around_keep_) propose(keep, v);
  }

  TriangleMesh mesh_;  // of triangles that are gone all corners are one
  HandleRule handles_;
  std::size_t left_;                              // triangles
  std::vector<std::vector<std::uint32_t>> fans_;  // triangles at each vertex
  std::vector<Quadric> quadrics_;
  std::vector<std::uint32_t> changes_;  // how often a vertex moved
  std::vector<char> is_fixed_;
  std::priority_queue<Collapse> queue_;
  std::vector<std::uint32_t> around_keep_;
  std::vector<std::uint32_t> around_drop_;
  std::vector<std::uint32_t> common_;
};

}  // namespace

TriangleMesh simplified(TriangleMesh mesh, std::size_t most_triangles, HandleRule handles) {
  mesh.sources.resize(mesh.points.size());
  std::iota(mesh.sources.begin(), mesh.sources.end(), 0U);
  if (mesh.triangles.size() <= most_triangles) return mesh;
  Simplifier simplifier(std::move(mesh), handles);
  simplifier.reduce(most_triangles);
  return simplifier.result();
}

}  // namespace isoloop
