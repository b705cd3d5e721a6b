#include "core/curves/sleeve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoloop {
namespace {

struct Point2 {
  double x = 0.0;
  double y = 0.0;

  Point2 operator+(const Point2& p) const { return {x + p.x, y + p.y}; }
  Point2 operator-(const Point2& p) const { return {x - p.x, y - p.y}; }
  Point2 operator*(double s) const { return {s * x, s * y}; }
};

double dot(const Point2& p, const Point2& q) { return p.x * q.x + p.y * q.y; }
double cross(const Point2& p, const Point2& q) { return p.x * q.y - p.y * q.x; }

struct FlatPortal {
  Point2 left;
  Point2 right;
};

/// The far corner of the triangle ahead of a portal.
Point2 corner_ahead(const FlatPortal& portal, double to_left, double to_right) {
  const Point2 edge = portal.left - portal.right;
  const double squared = dot(edge, edge);
  const double along =
      (to_right * to_right - to_left * to_left + squared) / (2.0 * squared);  // of the edge
  const double height = std::sqrt(std::max(to_right * to_right / squared - along * along, 0.0));
  const Point2 ahead{edge.y, -edge.x};
  return portal.right + edge * along + ahead * height;
}

/// The portals in the plane, and the first once more behind the last.
std::vector<FlatPortal> lay_out(const Surface& surface, std::span<const Portal> portals) {
  const auto between = [&](std::uint32_t a, std::uint32_t b) {
    return distance(scaled_point(surface, a), scaled_point(surface, b));
  };
  std::vector<FlatPortal> flat{{{0.0, between(portals[0].left, portals[0].right)}, {0.0, 0.0}}};
  for (std::size_t i = 0; i < portals.size(); ++i) {
    const Portal& from = portals[i];
    const Portal& to = portals[(i + 1) % portals.size()];
    const bool keeps_left = from.left == to.left;
    const std::uint32_t corner = keeps_left ? to.right : to.left;
    FlatPortal next = flat.back();
    (keeps_left ? next.right : next.left) =
        corner_ahead(flat.back(), between(corner, from.left), between(corner, from.right));
    flat.push_back(next);
  }
  return flat;
}

/// A point of the taut path: where it starts or ends, or turns at an end of a portal.
struct Turn {
  std::size_t portal = 0;
  Point2 point;
};

std::vector<Turn> string_through(const std::vector<FlatPortal>& flat, double at) {
  const auto start_on = [at](const FlatPortal& portal) {
    return portal.right + (portal.left - portal.right) * at;
  };
  const std::size_t last = flat.size() - 1;
  const Point2 goal = start_on(flat[last]);
  std::vector<Turn> turns{{0, start_on(flat[0])}};
  Turn left = turns[0];
  Turn right = turns[0];
  for (std::size_t i = 1; i <= last; ++i) {
    const Point2 apex = turns.back().point;
    const FlatPortal portal = i < last ? flat[i] : FlatPortal{goal, goal};
    const auto turns_left = [&](const Point2& from, const Point2& to) {
      return cross(from - apex, to - apex);
    };
    const auto restart = [&](const Turn& turn) {
      turns.push_back(turn);
      left = right = turn;
      i = turn.portal;
    };
    if (right.portal == turns.back().portal || turns_left(right.point, portal.right) >= 0.0) {
      if (left.portal != turns.back().portal && turns_left(left.point, portal.right) > 0.0) {
        restart(left);
        continue;
      }
      right = {i, portal.right};
    }
    if (left.portal == turns.back().portal || turns_left(left.point, portal.left) <= 0.0) {
      if (right.portal != turns.back().portal && turns_left(right.point, portal.left) < 0.0) {
        restart(right);
        continue;
      }
      left = {i, portal.left};
    }
  }
  turns.push_back({last, goal});
  return turns;
}

/// Where the straight line from one turn to the next crosses a portal.
double crossing(const FlatPortal& portal, const Point2& from, const Point2& to) {
  constexpr double nearest = 1e-9;  // to an end without being there
  const Point2 edge = portal.left - portal.right;
  const Point2 line = to - from;
  const double across = cross(line, edge);
  double at = 0.0;
  if (std::abs(across) > 1e-12 * dot(edge, edge)) {
    at = cross(from - portal.right, line) / -across;
  } else {  // the path runs along the edge, or stays where it is
    at = dot(from - portal.right, edge) / dot(edge, edge);
  }
  if (at < nearest) return 0.0;
  return at > 1.0 - nearest ? 1.0 : at;
}

}  // namespace

Vec3 point_on(const Surface& surface, const Portal& portal) {
  const Vec3 right = scaled_point(surface, portal.right);
  const Vec3 left = scaled_point(surface, portal.left);
  Vec3 point{};
  for (std::size_t a = 0; a < 3; ++a) point[a] = (1.0 - portal.at) * right[a] + portal.at * left[a];
  return point;
}

double length_of_path(const Surface& surface, std::span<const Portal> portals) {
  double length = 0.0;
  for (std::size_t i = 0; i < portals.size(); ++i)
    length += distance(point_on(surface, portals[i]),
                       point_on(surface, portals[(i + 1) % portals.size()]));
  return length;
}

void pull_taut(const Surface& surface, std::span<Portal> portals) {
  const std::vector<FlatPortal> flat = lay_out(surface, portals);
  const std::vector<Turn> turns = string_through(flat, portals[0].at);
  for (std::size_t t = 0; t + 1 < turns.size(); ++t) {
    const Turn& from = turns[t];
    const Turn& to = turns[t + 1];
    for (std::size_t i = std::max<std::size_t>(from.portal, 1); i < to.portal; ++i)
      portals[i].at = crossing(flat[i], from.point, to.point);
  }
}

}  // namespace isoloop
