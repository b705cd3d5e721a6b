#include "core/curves/geodesic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "core/curves/sleeve.h"

namespace isoloop {
namespace {

using Portals = std::vector<Portal>;

/// Where the path would cross an edge and come straight back.
bool turns_back(const Portal& portal, const Portal& next) {
  return portal.left == next.right && portal.right == next.left;
}

/// The edges to the left of the curve, crossed at the curve's own vertices.
Portals portals_beside(const TriangleFans& fans, const Curve& curve) {
  Portals portals;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const std::uint32_t vertex = curve[i];
    const std::uint32_t next = curve[(i + 1) % curve.size()];
    const std::uint32_t previous = curve[(i + curve.size() - 1) % curve.size()];
    for (std::uint32_t left = fans.apex(previous, vertex); left != next;
         left = fans.apex(left, vertex)) {
      const Portal portal{left, vertex, 0.0};
      if (!portals.empty() && turns_back(portals.back(), portal)) {
        portals.pop_back();
      } else {
        portals.push_back(portal);
      }
    }
  }
  std::size_t cut = 0;
  while (2 * cut + 1 < portals.size() &&
         turns_back(portals[portals.size() - 1 - cut], portals[cut]))
    ++cut;
  const auto begin = portals.begin() + static_cast<std::ptrdiff_t>(cut);
  return {begin, portals.end() - static_cast<std::ptrdiff_t>(cut)};
}

/// Shortens the path within its triangles. Which point stays changes from pull to pull; points that
/// meet at a vertex may have to move off it together, so that one pull without gain says little.
void make_taut(const Surface& surface, Portals& portals) {
  constexpr int most_pulls = 64;
  constexpr int most_in_vain = 3;
  constexpr double gain = 1e-10;  // of the length, worth another pull
  int in_vain = 0;
  double length = length_of_path(surface, portals);
  for (int pull = 0; pull < most_pulls && in_vain < most_in_vain; ++pull) {
    const std::size_t half = portals.size() / 2 + static_cast<std::size_t>(pull % 3);
    std::rotate(portals.begin(), portals.begin() + static_cast<std::ptrdiff_t>(half),
                portals.end());
    pull_taut(surface, portals);
    const double shorter = length_of_path(surface, portals);
    in_vain = shorter > length * (1.0 - gain) ? in_vain + 1 : 0;
    length = shorter;
  }
}

double angle_at(const Vec3& corner, const Vec3& p, const Vec3& q) {
  double dot = 0.0;
  double pp = 0.0;
  double qq = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    dot += (p[a] - corner[a]) * (q[a] - corner[a]);
    pp += (p[a] - corner[a]) * (p[a] - corner[a]);
    qq += (q[a] - corner[a]) * (q[a] - corner[a]);
  }
  return std::acos(std::clamp(dot / std::sqrt(pp * qq), -1.0, 1.0));
}

std::uint32_t end_of(const Portal& portal, bool right) {
  return right ? portal.right : portal.left;
}

bool is_crossed_at(const Portal& portal, bool right) { return portal.at == (right ? 0.0 : 1.0); }

/// Portals from `first` on that end at one vertex, on the right or left, and are crossed there; the
/// first and the last may be crossed at their other end, where the path runs along them. 0 if there
/// are none, or if others follow that end there.
std::size_t run_at_vertex(const Portals& portals, std::size_t first, bool right) {
  const std::uint32_t vertex = end_of(portals[first], right);
  std::size_t count = 1;
  while (first + count < portals.size() && end_of(portals[first + count], right) == vertex) ++count;
  bool goes_there = false;
  for (std::size_t i = 0; i < count; ++i) {
    const Portal& portal = portals[first + i];
    const bool outer = i == 0 || i + 1 == count;
    if (is_crossed_at(portal, right)) {
      goes_there = true;
    } else if (!outer || !is_crossed_at(portal, !right)) {
      return 0;
    }
  }
  return goes_there ? count : 0;
}

/// The path goes through the vertex on the right or left end of `run` and past these edges on that
/// side of it, from `before` to `behind`, which do not end there. The edges on the other side, if
/// that side leaves less than a straight angle.
std::optional<Portals> across_vertex(const Surface& surface, const TriangleFans& fans,
                                     const Portal& before, std::span<const Portal> run,
                                     const Portal& behind, bool right) {
  constexpr double hardly_less = 1e-7;
  const std::uint32_t vertex = end_of(run.front(), right);
  const Vec3 corner = scaled_point(surface, vertex);
  Vec3 from = point_on(surface, is_crossed_at(run.front(), right) ? before : run.front());
  double angle = 0.0;
  const auto turn_to = [&](const Vec3& to) {
    if (from != to) angle += angle_at(corner, from, to);
    from = to;
  };
  Portals across;
  for (std::uint32_t rim = end_of(before, right);;
       rim = right ? fans.apex(vertex, rim) : fans.apex(rim, vertex)) {
    turn_to(scaled_point(surface, rim));
    across.push_back(right ? Portal{vertex, rim, 1.0} : Portal{rim, vertex, 0.0});
    if (rim == end_of(behind, right)) break;
  }
  turn_to(point_on(surface, is_crossed_at(run.back(), right) ? behind : run.back()));
  if (angle >= std::numbers::pi - hardly_less) return std::nullopt;
  return across;
}

/// Moves the path across each vertex where that lets it become shorter. Looks at no vertex that the
/// first or the last portal ends at.
bool cross_vertices(const Surface& surface, const TriangleFans& fans, Portals& portals) {
  Portals moved{portals[0]};
  bool crossed = false;
  for (std::size_t i = 1; i < portals.size();) {
    std::optional<Portals> across;
    for (const bool right : {true, false}) {
      const std::size_t count = run_at_vertex(portals, i, right);
      const std::size_t behind = i + count;
      if (count == 0 || behind == portals.size()) continue;
      if (end_of(moved.back(), right) == end_of(portals[i], right)) continue;
      across =
          across_vertex(surface, fans, moved.back(), {&portals[i], count}, portals[behind], right);
      if (!across) continue;
      moved.insert(moved.end(), across->begin(), across->end());
      i = behind;
      break;
    }
    if (across) {
      crossed = true;
    } else {
      moved.push_back(portals[i++]);
    }
  }
  portals = std::move(moved);
  return crossed;
}

/// The same for all vertices: turns the portals until one crosses, and round once at most.
bool cross_vertices_anywhere(const Surface& surface, const TriangleFans& fans, Portals& portals) {
  const std::size_t step = std::max<std::size_t>(portals.size() / 8, 1);
  for (std::size_t turned = 0; turned < portals.size(); turned += step) {
    if (cross_vertices(surface, fans, portals)) return true;
    std::rotate(portals.begin(), portals.begin() + static_cast<std::ptrdiff_t>(step),
                portals.end());
  }
  return false;
}

bool ends_at_one_vertex(const Portals& portals) {
  const auto all_end_there = [&](bool right) {
    return std::all_of(portals.begin(), portals.end(), [&](const Portal& portal) {
      return end_of(portal, right) == end_of(portals.front(), right);
    });
  };
  return all_end_there(true) || all_end_there(false);
}

Geodesic points_of(const Portals& portals) {
  Geodesic points;
  for (const auto& [left, right, at] : portals) {
    SurfacePoint point{{right, left}, at};
    if (at == 0.0) point = {{right, right}, 0.0};
    if (at == 1.0) point = {{left, left}, 0.0};
    if (points.empty() || point.at != 0.0 || points.back().edge != point.edge)
      points.push_back(point);
  }
  if (points.size() > 1 && points.front().at == 0.0 && points.front().edge == points.back().edge)
    points.pop_back();
  return points;
}

Geodesic points_of(const Curve& curve) {
  Geodesic points;
  for (const std::uint32_t vertex : curve) points.push_back({{vertex, vertex}, 0.0});
  return points;
}

}  // namespace

bool lies_on(const Surface& surface, const TriangleFans& fans, const Geodesic& geodesic) {
  const auto share_triangle = [&](const SurfacePoint& p, const SurfacePoint& q) {
    const auto around = fans.triangles(p.edge[0]);
    return std::any_of(around.begin(), around.end(), [&](std::uint32_t t) {
      const auto& corners = surface.triangles[t];
      return std::ranges::all_of(std::array{p.edge[0], p.edge[1], q.edge[0], q.edge[1]},
                                 [&](std::uint32_t vertex) {
                                   return std::ranges::find(corners, vertex) != corners.end();
                                 });
    });
  };
  for (std::size_t i = 0; i < geodesic.size(); ++i) {
    const SurfacePoint& point = geodesic[i];
    if (!(point.at >= 0.0 && point.at <= 1.0)) return false;
    if (!share_triangle(point, geodesic[(i + 1) % geodesic.size()])) return false;
  }
  return !geodesic.empty();
}

Vec3 index_point(const SurfaceMesh& surface, const SurfacePoint& point) {
  Vec3 position{};
  for (std::size_t a = 0; a < 3; ++a)
    position[a] = (1.0 - point.at) * surface.points[point.edge[0]][a] +
                  point.at * surface.points[point.edge[1]][a];
  return position;
}

double length_of(const Surface& surface, const Geodesic& geodesic) {
  double length = 0.0;
  for (std::size_t i = 0; i < geodesic.size(); ++i)
    length += scaled_distance(surface, index_point(surface, geodesic[i]),
                              index_point(surface, geodesic[(i + 1) % geodesic.size()]));
  return length;
}

Curve pushed_to_edges(const Geodesic& geodesic) {
  Curve walk;
  for (const SurfacePoint& point : geodesic) {
    const std::uint32_t vertex = point.edge[point.at < 0.5 ? 0 : 1];
    if (walk.empty() || walk.back() != vertex) walk.push_back(vertex);
  }
  while (walk.size() > 1 && walk.front() == walk.back()) walk.pop_back();
  return walk;
}

Geodesic closed_geodesic(const Surface& surface, const TriangleFans& fans, const Curve& curve) {
  constexpr int most_rounds = 10'000;  // each makes the curve shorter
  Portals portals = portals_beside(fans, curve);
  for (int round = 0; round < most_rounds; ++round) {
    if (portals.size() < 3 || ends_at_one_vertex(portals)) return points_of(curve);
    make_taut(surface, portals);
    if (!cross_vertices_anywhere(surface, fans, portals)) break;
  }
  Geodesic geodesic = points_of(portals);
  return length_of(surface, geodesic) < length_of(surface, points_of(curve)) ? geodesic
                                                                             : points_of(curve);
}

}  // namespace isoloop
