#include "volume/shapes/engine_block.h"

#include <algorithm>
#include <vector>

#include "volume/shapes/shape_field.h"

namespace isoloop {
namespace {

// All lengths below are in design units: the block spans [0, 112] x [0, 56] x [0, 72], with x
// along the crankshaft and z towards the cylinder head. No wall is thinner than 3.5 units.
constexpr Vec3 design{112.0, 56.0, 72.0};
constexpr double beyond = 20.0;  // how far an open passage is drilled past the block

struct Rod {
  Vec3 from;
  Vec3 to;
  double radius;
};

Rod along_x(double y, double z, double radius) {
  return {{-beyond, y, z}, {design[0] + beyond, y, z}, radius};
}

Rod along_y(double x, double z, double radius) {
  return {{x, -beyond, z}, {x, design[1] + beyond, z}, radius};
}

Rod down_to(double x, double y, double bottom, double radius) {
  return {{x, y, design[2] + beyond}, {x, y, bottom}, radius};
}

// The closure of the complement W in the 3-sphere is the space around the block (a ball) with
// passages attached. A connected system of passages is a graph; with k openings and c independent
// cycles of its own it adds (k - 1) + c to b1(W). By Alexander duality b1(block) = b1(W), and
// b2(block) = components of W - 1.

/// The crankshaft bore (2 openings) and four cylinders that end in it (4): k = 6, c = 0.
constexpr std::int64_t crank_tunnels = 5;
void add_crank_and_cylinders(std::vector<Rod>& rods) {
  rods.push_back(along_x(28.0, 20.0, 8.0));
  for (const double x : {20.0, 44.0, 68.0, 92.0}) rods.push_back(down_to(x, 28.0, 20.0, 6.5));
}

/// Two galleries (4 openings) with two risers each (4), joined by three cross passages between
/// the cylinders (two cycles): k = 8, c = 2.
constexpr std::int64_t coolant_tunnels = 9;
void add_coolant(std::vector<Rod>& rods) {
  for (const double y : {10.0, 46.0}) {
    rods.push_back(along_x(y, 56.0, 2.25));
    for (const double x : {20.0, 92.0}) rods.push_back(down_to(x, y, 56.0, 2.0));
  }
  for (const double x : {32.0, 56.0, 80.0}) {
    rods.push_back({{x, 10.0, 56.0}, {x, 46.0, 56.0}, 2.0});
  }
}

/// The main oil gallery, crossed at its own height by two bores: k = 6, c = 0.
constexpr std::int64_t oil_tunnels = 5;
void add_oil(std::vector<Rod>& rods) {
  rods.push_back(along_x(44.0, 6.0, 2.5));
  for (const double x : {32.0, 80.0}) rods.push_back(along_y(x, 6.0, 2.5));
}

/// Ten bolt holes in the deck and four engine mounts in the flanks. Blind: k = 1, c = 0 each.
void add_blind_holes(std::vector<Rod>& rods) {
  for (const double y : {18.0, 38.0}) {
    for (const double x : {8.0, 32.0, 56.0, 80.0, 104.0}) {
      rods.push_back(down_to(x, y, 64.5, 2.25));
    }
  }
  for (const double x : {20.0, 68.0}) {
    rods.push_back({{x, -beyond, 38.0}, {x, 8.0, 38.0}, 3.0});
    rods.push_back({{x, design[1] + beyond, 38.0}, {x, design[1] - 8.0, 38.0}, 3.0});
  }
}

// A closed water jacket round the fourth cylinder: a component of W with b1 = 1. The casting void
// is a component with b1 = 0.
constexpr std::int64_t jacket_tunnels = 1;
constexpr std::int64_t closed_voids = 2;
double closed_void_distance(const Vec3& u) {
  return std::min(ring_distance(u, {92.0, 28.0, 40.0}, 2, 12.0, 2.0),
                  ball_distance(u, {56.0, 13.0, 36.0}, 4.0));
}

/// Walls, a wider crankcase below, a deck above, and three ribs a side. Without its passages
/// this is a ball: every part overlaps the walls in a convex set.
double casting_distance(const Vec3& u) {
  double d = box_distance(u, {0.0, 4.0, 0.0}, {112.0, 52.0, 72.0}, 2.0);
  d = std::min(d, box_distance(u, {0.0, 0.0, 0.0}, {112.0, 56.0, 30.0}, 2.0));
  d = std::min(d, box_distance(u, {0.0, 0.0, 64.0}, {112.0, 56.0, 72.0}, 2.0));
  for (const double x : {32.0, 56.0, 80.0}) {
    d = std::min(d, box_distance(u, {x - 3.0, 0.0, 26.0}, {x + 3.0, 56.0, 68.0}, 1.5));
  }
  return d;
}

double nearest_rod_distance(const std::vector<Rod>& rods, const Vec3& u) {
  double least = 1e6;
  for (const Rod& rod : rods) {
    const double reach = least + rod.radius;
    const double squared = squared_segment_distance(u, rod.from, rod.to);
    if (reach > 0.0 && squared < reach * reach) least = std::sqrt(squared) - rod.radius;
  }
  return least;
}

}  // namespace

Shape make_engine_block(double extent, std::uint64_t max_bytes) {
  const double scale = extent / design[0];  // voxels per design unit
  const Index3 dims = shape_dims({extent, design[1] * scale, design[2] * scale});
  std::vector<Rod> rods;
  add_crank_and_cylinders(rods);
  add_coolant(rods);
  add_oil(rods);
  add_blind_holes(rods);
  Shape shape;
  shape.volume = sample_distance(dims, max_bytes, "engine_block", [&](const Vec3& p) {
    Vec3 u{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double centre = 0.5 * static_cast<double>(dims[axis] - 1);
      u[axis] = 0.5 * design[axis] + (p[axis] - centre) / scale;
    }
    const double passages = std::min(nearest_rod_distance(rods, u), closed_void_distance(u));
    return scale * std::max(casting_distance(u), -passages);
  });
  shape.known = KnownTopology{1, crank_tunnels + coolant_tunnels + oil_tunnels + jacket_tunnels,
                              closed_voids};
  return shape;
}

}  // namespace isoloop
