#include "volume/shapes/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <tbb/parallel_for.h>

#include "core/base/errors.h"
#include "core/grid/vec3.h"
#include "volume/shapes/curve_distance.h"
#include "volume/shapes/engine_block.h"
#include "volume/shapes/shape_field.h"

namespace isoloop {
namespace {

constexpr double narrowest = 3.0;  // voxels; every wall and passage is at least this wide

Vec3 centre_of(const Index3& dims) {
  return {0.5 * static_cast<double>(dims[0] - 1), 0.5 * static_cast<double>(dims[1] - 1),
          0.5 * static_cast<double>(dims[2] - 1)};
}

/// Samples `distance`, which takes points relative to the volume's centre.
template <class Distance>
Shape centred_shape(const ShapeOptions& options, std::string_view name, const Vec3& extents,
                    const std::optional<KnownTopology>& known, const Distance& distance) {
  const Index3 dims = shape_dims(extents);
  const Vec3 centre = centre_of(dims);
  Shape shape;
  shape.volume = sample_distance(dims, options.max_bytes, std::string(name),
                                 [&](const Vec3& p) { return distance(minus(p, centre)); });
  shape.known = known;
  return shape;
}

Shape make_ball(double extent, const ShapeOptions& options) {
  return centred_shape(options, "ball", {extent, extent, extent}, KnownTopology{1, 0, 0},
                       [=](const Vec3& p) { return root_of_squares(p) - 0.5 * extent; });
}

/// A ball with a cavity of half its radius.
Shape make_shell(double extent, const ShapeOptions& options) {
  const double radius = 0.5 * extent;
  return centred_shape(
      options, "shell", {extent, extent, extent}, KnownTopology{1, 0, 1}, [=](const Vec3& p) {
        return std::max(root_of_squares(p) - radius, 0.5 * radius - root_of_squares(p));
      });
}

Shape make_torus(double extent, const ShapeOptions& options) {
  const double minor = extent / 6.0;  // also the radius of the hole
  return centred_shape(options, "torus", {extent, extent, 2.0 * minor}, KnownTopology{1, 1, 0},
                       [=](const Vec3& p) { return ring_distance(p, {}, 2, 2.0 * minor, minor); });
}

/// The solid between two coaxial tori, a thickened torus surface: b1 = 2, b2 = 1.
Shape make_nested_tori(double extent, const ShapeOptions& options) {
  const double unit = 0.1 * extent;  // thickness of the shell, radius of the cavity and the hole
  return centred_shape(options, "nested_tori", {extent, extent, 4.0 * unit}, KnownTopology{1, 2, 1},
                       [=](const Vec3& p) {
                         const double d = ring_distance(p, {}, 2, 3.0 * unit, 0.0);
                         return std::max(d - 2.0 * unit, unit - d);
                       });
}

/// A Hopf link. The circles, of radius R and each through the other's centre, are R apart
/// everywhere: the squared distance is R^2 (3 + 2 (v - u - u v)) with cosines u, v, and
/// v - u - u v = (1 - u)(1 + v) - 1 >= -1. Tubes of radius R / 4 leave a gap of R / 2.
Shape make_linked_tori(double extent, const ShapeOptions& options) {
  const double major = extent / 3.5;
  const double minor = 0.25 * major;
  const double across = 2.0 * (major + minor);
  return centred_shape(options, "linked_tori", {extent, across, across}, KnownTopology{2, 2, 0},
                       [=](const Vec3& p) {
                         const Vec3 left{-0.5 * major, 0.0, 0.0};
                         const Vec3 right{0.5 * major, 0.0, 0.0};
                         return std::min(ring_distance(p, left, 2, major, minor),
                                         ring_distance(p, right, 1, major, minor));
                       });
}

/// Columns of holes in a plate: as near to a square as the number allows.
int plate_columns(const ShapeOptions& options) {
  int columns = 1;
  while (columns * columns < options.holes) ++columns;
  return columns;
}

/// Drilled through in rows and columns, a `pitch` apart: each hole adds 1 to b1.
Shape make_plate(double extent, const ShapeOptions& options) {
  const int columns = plate_columns(options);
  const int rows = std::max(1, (options.holes + columns - 1) / columns);
  const double pitch = extent / columns;
  const double thickness = std::min(0.5 * pitch, 0.2 * extent);
  const Vec3 size{extent, pitch * rows, thickness};
  const Vec3 half{0.5 * size[0], 0.5 * size[1], 0.5 * size[2]};
  const auto hole_depth = [=](const Vec3& p) {
    const int column = static_cast<int>(std::floor((p[0] + half[0]) / pitch));
    const int row = static_cast<int>(std::floor((p[1] + half[1]) / pitch));
    double nearest = 2.0 * extent;  // a hole further off than the next cell does not show
    for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r) {
      for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c) {
        if (c + columns * r >= options.holes) continue;
        nearest = std::min(nearest, std::hypot(p[0] + half[0] - (c + 0.5) * pitch,
                                               p[1] + half[1] - (r + 0.5) * pitch));
      }
    }
    return 0.25 * pitch - nearest;
  };
  return centred_shape(
      options, "plate", size, KnownTopology{1, options.holes, 0}, [=](const Vec3& p) {
        const Vec3 low{-half[0], -half[1], -half[2]};
        return std::max(box_distance(p, low, half, 0.15 * thickness), hole_depth(p));
      });
}

/// Tubes along the edges of m x m x m cells, a graph with V = (m + 1)^3 vertices and
/// E = 3 m (m + 1)^2 edges: b1 = E - V + 1.
Shape make_lattice(double extent, const ShapeOptions& options) {
  const std::int64_t m = options.cells;
  const double pitch = extent / (static_cast<double>(m) + 0.5);  // tubes of radius pitch / 4
  const double end = static_cast<double>(m);
  const KnownTopology known{1, 3 * m * (m + 1) * (m + 1) - (m + 1) * (m + 1) * (m + 1) + 1, 0};
  return centred_shape(options, "lattice", {extent, extent, extent}, known, [=](const Vec3& p) {
    Vec3 to_line{};  // squared distances to the nearest grid plane, and past the grid's end
    Vec3 past{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double u = p[axis] / pitch + 0.5 * end;
      const double line = u - std::clamp(std::round(u), 0.0, end);
      const double over = u - std::clamp(u, 0.0, end);
      to_line[axis] = line * line;
      past[axis] = over * over;
    }
    const double squared =
        std::min({past[0] + to_line[1] + to_line[2], to_line[0] + past[1] + to_line[2],
                  to_line[0] + to_line[1] + past[2]});
    return pitch * (std::sqrt(squared) - 0.25);
  });
}

/// The curve ((2 + cos 3t) cos 2t, (2 + cos 3t) sin 2t, sin 3t): its strands come within 1.66 of
/// each other, so a tube of radius 0.45 leaves a gap of 0.76. It spans [-2.3644, 3] x
/// [-2.8283, 2.8283] x [-1, 1].
constexpr double trefoil_radius = 0.45;
constexpr double trefoil_gap = 0.76;
constexpr Vec3 trefoil_low{-2.3644, -2.8283, -1.0};
constexpr Vec3 trefoil_high{3.0, 2.8283, 1.0};
constexpr double trefoil_longest = trefoil_high[1] - trefoil_low[1] + 2.0 * trefoil_radius;

Shape make_trefoil(double extent, const ShapeOptions& options) {
  const double scale = extent / trefoil_longest;
  Vec3 extents = minus(trefoil_high, trefoil_low);
  for (double& length : extents) length = scale * (length + 2.0 * trefoil_radius);
  const Index3 dims = shape_dims(extents);
  const Vec3 centre = centre_of(dims);
  constexpr int points = 600;
  std::vector<Vec3> curve;
  for (int i = 0; i < points; ++i) {
    const double t = 2.0 * std::numbers::pi * i / points;
    const double ring = 2.0 + std::cos(3.0 * t);
    Vec3 p{ring * std::cos(2.0 * t), ring * std::sin(2.0 * t), std::sin(3.0 * t)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      p[axis] = scale * (p[axis] - 0.5 * (trefoil_low[axis] + trefoil_high[axis]));
    }
    curve.push_back(plus(p, centre));
  }
  Shape shape;
  check_voxel_memory(dims, sizeof(float), options.max_bytes, "trefoil");
  const CurveDistance distance(std::move(curve), dims);
  shape.volume = sample_distance(dims, options.max_bytes, "trefoil", [&](const Vec3& p) {
    return distance(p) - scale * trefoil_radius;
  });
  shape.known = KnownTopology{1, 1, 0};
  return shape;
}

/// One labyrinth of the gyroid, three periods wide, cut off by a box. How its channels end at the
/// box decides b1; no formula is known.
Shape make_gyroid(double extent, const ShapeOptions& options) {
  const double k = 3.0 * 2.0 * std::numbers::pi / extent;
  const Vec3 half{0.5 * extent, 0.5 * extent, 0.25 * extent};
  const Vec3 size{2.0 * half[0], 2.0 * half[1], 2.0 * half[2]};
  return centred_shape(options, "gyroid", size, std::nullopt, [=](const Vec3& p) {
    const double x = k * p[0];
    const double y = k * p[1];
    const double z = k * p[2];
    const double g =
        std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x);
    // The gradient of g is about 1.5 k on the surface g = 0.
    const Vec3 low{-half[0], -half[1], -half[2]};
    return std::max(g / (1.5 * k), box_distance(p, low, half, 0.0));
  });
}

struct Recipe {
  std::string_view name;
  double (*least_extent)(const ShapeOptions&);  // of the solid, voxels; see `narrowest`
  Shape (*make)(double extent, const ShapeOptions&);
};

constexpr std::array<Recipe, 10> recipes{{
    {"ball", [](const ShapeOptions&) { return narrowest; }, make_ball},
    {"engine_block", [](const ShapeOptions&) { return least_engine_block_extent; },
     [](double extent, const ShapeOptions& o) { return make_engine_block(extent, o.max_bytes); }},
    {"gyroid", [](const ShapeOptions&) { return 42.0; }, make_gyroid},
    {"lattice", [](const ShapeOptions& o) { return narrowest * (2.0 * o.cells + 1.0); },
     make_lattice},
    {"linked_tori", [](const ShapeOptions&) { return 7.0 * narrowest; }, make_linked_tori},
    {"nested_tori", [](const ShapeOptions&) { return 10.0 * narrowest; }, make_nested_tori},
    {"plate",
     [](const ShapeOptions& o) { return narrowest * std::max(5.0, 2.0 * plate_columns(o)); },
     make_plate},
    {"shell", [](const ShapeOptions&) { return 4.0 * narrowest; }, make_shell},
    {"torus", [](const ShapeOptions&) { return 3.0 * narrowest; }, make_torus},
    {"trefoil", [](const ShapeOptions&) { return narrowest * trefoil_longest / trefoil_gap; },
     make_trefoil},
}};

const Recipe& recipe_for(std::string_view name) {
  const auto found = std::find_if(recipes.begin(), recipes.end(),
                                  [&](const Recipe& recipe) { return recipe.name == name; });
  if (found != recipes.end()) return *found;
  std::string names;
  for (const Recipe& recipe : recipes) {
    names += (names.empty() ? "" : ", ") + std::string(recipe.name);
  }
  throw InvalidArgument(
      {.text = "no shape is called '" + std::string(name) + "'; the shapes are " + names},
      Option::shape);
}

std::int64_t minimum_size(const Recipe& recipe, const ShapeOptions& options) {
  if (options.holes < 0 || options.holes > most_holes) {
    throw InvalidArgument({.text = "holes must be 0 to " + std::to_string(most_holes) + ", not " +
                                   std::to_string(options.holes)},
                          Option::shape);
  }
  if (options.cells < 1 || options.cells > most_cells) {
    throw InvalidArgument({.text = "cells must be 1 to " + std::to_string(most_cells) + ", not " +
                                   std::to_string(options.cells)},
                          Option::shape);
  }
  const double extent = recipe.least_extent(options);
  return std::max<std::int64_t>(16, shape_dims({extent, extent, extent})[0]);
}

}  // namespace

std::vector<std::string> shape_names() {
  std::vector<std::string> names;
  names.reserve(recipes.size());
  for (const Recipe& recipe : recipes) names.emplace_back(recipe.name);
  return names;
}

std::int64_t minimum_shape_size(std::string_view name, const ShapeOptions& options) {
  return minimum_size(recipe_for(name), options);
}

Shape make_shape(std::string_view name, const ShapeOptions& options) {
  const Recipe& recipe = recipe_for(name);
  const std::int64_t least = minimum_size(recipe, options);
  if (options.size < least) {
    throw InvalidArgument(
        {.file = std::string(name),
         .text = "size " + std::to_string(options.size) + " is too small to resolve it; take " +
                 std::to_string(least) + " or more"},
        Option::shape);
  }
  check_voxel_memory({options.size, 1, 1}, sizeof(float), options.max_bytes, std::string(name));
  return recipe.make(shape_extent(options.size), options);
}

void clip_to_narrow_band(Shape& shape) {
  constexpr float half_width = 3.0F;  // voxels
  auto& values = std::get<std::vector<float>>(shape.volume.values);
  tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t i) {
    values[i] = std::clamp(values[i], -half_width, half_width);
  });
}

}  // namespace isoloop
