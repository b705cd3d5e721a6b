#include "volume/mesh_topology/mesh_crossing.h"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/grid/vec3.h"

namespace isoloop {
namespace {

// Shewchuk (1997): bounds of rounding, rounded up, as shares of the sum of the absolute products.
constexpr double plane_error = 1e-15;
constexpr double turn_error = 4e-16;

int sign_beyond(double value, double error) {
  if (value > error) return 1;
  return value < -error ? -1 : 0;
}

struct Triangle {
  std::array<Vec3, 3> corners;
  std::size_t axis = 0;  // along which it is seen largest
  int turned = 0;        // along that axis; 0: it has no area
};

Triangle triangle_of(const Mesh& mesh, std::size_t t) {
  Triangle triangle;
  for (std::size_t c = 0; c < 3; ++c) triangle.corners[c] = mesh.points[mesh.triangles[t][c]];
  const Vec3 u = minus(triangle.corners[1], triangle.corners[0]);
  const Vec3 v = minus(triangle.corners[2], triangle.corners[0]);
  double largest = -1.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t y = (a + 1) % 3;
    const std::size_t z = (a + 2) % 3;
    const double area = std::abs(u[y] * v[z] - u[z] * v[y]);
    if (!(area > largest)) continue;
    largest = area;
    triangle.axis = a;
  }
  triangle.turned =
      turn(triangle.corners[0], triangle.corners[1], triangle.corners[2], triangle.axis);
  return triangle;
}

/// Whether both points, as seen along the axis, lie beyond one of the triangle's sides.
bool lie_beyond_a_side(const Vec3& p, const Vec3& q, const Triangle& t) {
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3& from = t.corners[c];
    const Vec3& to = t.corners[(c + 1) % 3];
    if (turn(from, to, p, t.axis) == -t.turned && turn(from, to, q, t.axis) == -t.turned)
      return true;
  }
  return false;
}

/// Whether all that `sign` says of 0, 1 and 2 is one side.
template <class Sign>
bool all_on_one_side(const Sign& sign) {
  const int first = sign(0);
  return first != 0 && sign(1) == first && sign(2) == first;
}

bool segment_meets(const Vec3& p, const Vec3& q, const Triangle& t) {
  const auto& [a, b, c] = t.corners;
  const int side_of_p = side_of_plane(a, b, c, p);
  const int side_of_q = side_of_plane(a, b, c, q);
  if (side_of_p * side_of_q > 0) return false;
  // As seen along the axis they lie apart: this also tells triangles apart that share a plane but
  // for the rounding of their corners.
  if (lie_beyond_a_side(p, q, t) ||
      all_on_one_side([&](std::size_t i) { return turn(p, q, t.corners[i], t.axis); })) {
    return false;
  }
  if (side_of_p == 0 && side_of_q == 0) return true;
  if (side_of_p == 0) return !lie_beyond_a_side(p, p, t);
  if (side_of_q == 0) return !lie_beyond_a_side(q, q, t);
  bool has_left = false;
  bool has_right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = side_of_plane(p, q, t.corners[i], t.corners[(i + 1) % 3]);
    has_left = has_left || side > 0;
    has_right = has_right || side < 0;
  }
  return !(has_left && has_right);
}

/// The triangle's corners that the other has not, then those that it has.
struct Shared {
  std::array<std::uint32_t, 3> corners{};
  std::size_t own = 0;  // how many the other has not
};

Shared shared_corners(const std::array<std::uint32_t, 3>& one,
                      const std::array<std::uint32_t, 3>& other) {
  Shared shared;
  std::size_t back = 3;
  for (const std::uint32_t corner : one) {
    const bool is_common = corner == other[0] || corner == other[1] || corner == other[2];
    shared.corners[is_common ? --back : shared.own++] = corner;
  }
  return shared;
}

bool any_side_meets(const Triangle& one, const Triangle& other) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (segment_meets(one.corners[c], one.corners[(c + 1) % 3], other)) return true;
  }
  return false;
}

}  // namespace

int side_of_plane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = minus(a, d);
  const Vec3 v = minus(b, d);
  const Vec3 w = minus(c, d);
  const std::array<double, 6> products{v[0] * w[1], w[0] * v[1], w[0] * u[1],
                                       u[0] * w[1], u[0] * v[1], v[0] * u[1]};
  const double value = u[2] * (products[0] - products[1]) + v[2] * (products[2] - products[3]) +
                       w[2] * (products[4] - products[5]);
  const double size = std::abs(u[2]) * (std::abs(products[0]) + std::abs(products[1])) +
                      std::abs(v[2]) * (std::abs(products[2]) + std::abs(products[3])) +
                      std::abs(w[2]) * (std::abs(products[4]) + std::abs(products[5]));
  return sign_beyond(-value, plane_error * size);  // the determinant is positive below the plane
}

int turn(const Vec3& a, const Vec3& b, const Vec3& c, std::size_t axis) {
  const std::size_t y = (axis + 1) % 3;
  const std::size_t z = (axis + 2) % 3;
  const double left = (b[y] - a[y]) * (c[z] - a[z]);
  const double right = (b[z] - a[z]) * (c[y] - a[y]);
  return sign_beyond(left - right, turn_error * (std::abs(left) + std::abs(right)));
}

bool triangles_meet(const Mesh& mesh, std::size_t one, std::size_t other) {
  const Triangle a = triangle_of(mesh, one);
  const Triangle b = triangle_of(mesh, other);
  if (a.turned == 0 || b.turned == 0) return false;
  const Shared of_a = shared_corners(mesh.triangles[one], mesh.triangles[other]);
  const Shared of_b = shared_corners(mesh.triangles[other], mesh.triangles[one]);
  const auto point = [&](std::uint32_t corner) -> const Vec3& { return mesh.points[corner]; };
  switch (of_a.own) {
    case 0:
      return true;
    case 1: {  // they meet beyond the shared side if they are folded flat
      const Vec3& p = point(of_a.corners[1]);
      const Vec3& q = point(of_a.corners[2]);
      const Vec3& r = point(of_a.corners[0]);
      const Vec3& s = point(of_b.corners[0]);
      return side_of_plane(p, q, r, s) == 0 && turn(p, q, r, a.axis) == turn(p, q, s, a.axis);
    }
    case 2:
      return segment_meets(point(of_a.corners[0]), point(of_a.corners[1]), b) ||
             segment_meets(point(of_b.corners[0]), point(of_b.corners[1]), a);
    default:
      return any_side_meets(a, b) || any_side_meets(b, a);
  }
}

std::optional<std::size_t> meeting_pairs(const Mesh& mesh, const MeshTree& tree) {
  const std::size_t most_looks = 200 * mesh.triangles.size() + 20'000'000;
  std::atomic<std::size_t> looks{0};
  std::atomic<std::size_t> pairs{0};
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.triangles.size(), 64),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      std::size_t looked = 0;
                      std::size_t found = 0;
                      if (looks.load() > most_looks) return;
                      for (std::size_t t = range.begin(); t < range.end(); ++t) {
                        const Box box = box_of(mesh, t);
                        tree.walk([&](const Box& other, std::uint32_t) { return meet(box, other); },
                                  [&](std::uint32_t other) {
                                    ++looked;
                                    if (other <= t || !meet(box, box_of(mesh, other))) return;
                                    found += triangles_meet(mesh, t, other) ? 1 : 0;
                                  });
                      }
                      looks += looked;
                      pairs += found;
                    });
  if (looks > most_looks) return std::nullopt;
  return pairs.load();
}

}  // namespace isoloop
