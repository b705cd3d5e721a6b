#include "tests/samples/sample_run.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace isoloop {
namespace {

Volume sample_volume() {
  Volume volume;
  volume.dims = {10, 10, 10};
  volume.values = std::vector<float>(1000, 2.0F);
  volume.spacing = {0.5, 0.5, 0.5};
  volume.origin = {100.0, 0.0, 0.0};
  volume.frame = Frame::world;
  return volume;
}

Surface torus_surface() {
  Surface surface;
  surface.spacing = {0.5, 0.5, 0.5};
  constexpr double third = 2.0 * std::numbers::pi / 3.0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (std::uint32_t j = 0; j < 3; ++j) {
      const double radius = 3.0 + std::cos(third * j);
      surface.points.push_back({static_cast<float>(5.0 + radius * std::cos(third * i)),
                                static_cast<float>(5.0 + radius * std::sin(third * i)),
                                static_cast<float>(5.0 + std::sin(third * j))});
      surface.grid_edges.push_back(3 * i + j);
      surface.component_of_vertex.push_back(0);
      const auto at = [](std::uint32_t a, std::uint32_t b) { return 3 * (a % 3) + b % 3; };
      surface.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      surface.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  surface.polygons = 9;  // a square is one polygon: 9 vertices - 9 squares = 0
  surface.components = {{.vertices = 9, .triangles = 18, .euler = 0, .genus = 1}};
  return surface;
}

}  // namespace

LoopsRun torus_run() {
  LoopsRun run;
  run.file = "torus.raw";
  run.volume = sample_volume();
  run.range = {-1.0, 2.0};
  run.level = {.iso = 0.25, .inside = InsideRule::below};
  run.analysis.surface = torus_surface();
  run.analysis.betti = {.b0 = 1, .b1 = 1, .b2 = 0};
  const Loop handle{
      .kind = LoopKind::handle,
      .id = 1,
      .size = 1.5,
      .length = 2.598,
      .found_length = 2.75,
      .component = 0,
      .center_index = {8.0, 5.0, 5.0},
      .curves = {{0, 1, 2}},
      .certificate = {
          .nontrivial_on_surface = true, .trivial_inside = true, .trivial_outside = false}};
  const Loop tunnel{
      .kind = LoopKind::tunnel,
      .id = 1,
      .size = std::numeric_limits<double>::infinity(),
      .length = 10.392,
      .found_length = 10.392,
      .component = 0,
      .center_index = {5.0, 5.0, 5.0},
      .curves = {{0, 3, 6}},
      .certificate = {
          .nontrivial_on_surface = true, .trivial_inside = false, .trivial_outside = true}};
  run.analysis.loops = {handle, tunnel};
  run.reported = run.analysis.loops;
  run.cost = {.read_seconds = 0.25, .total_seconds = 1.5, .peak_bytes = 1024};
  return run;
}

LoopsRun torus_run_with_features() {
  LoopsRun run = torus_run();
  run.with_features = true;
  run.features = {{.area = 4.0,
                   .axis = {0.0, 1.0, 0.0},
                   .depth = 1.5,
                   .least_girth = 2.0,
                   .mean_girth = 2.25,
                   .vertices = {0, 1, 2, 3, 4, 5}},
                  {.area = 9.0,
                   .axis = {0.0, 0.0, 1.0},
                   .depth = 0.5,
                   .least_girth = 10.0,
                   .mean_girth = 10.25,
                   .vertices = {0, 3, 6, 7}}};
  return run;
}

LoopsRun open_run() {
  LoopsRun run = torus_run();
  Surface& surface = run.analysis.surface;
  surface.boundary = Boundary::open;
  surface.triangles.resize(12);  // six for each angle round the axis
  for (std::uint32_t j = 0; j < 3; ++j) {
    surface.border_edges.push_back({(j + 1) % 3, j});
    surface.border_edges.push_back({6 + j, 6 + (j + 1) % 3});
  }
  surface.components = {{.vertices = 9, .triangles = 12, .euler = 0, .genus = 0, .borders = 2}};
  Loop& loop = run.analysis.loops[0];
  loop.kind = LoopKind::loop;
  loop.certificate = {
      .nontrivial_on_surface = true, .trivial_inside = false, .trivial_outside = false};
  run.analysis.loops.resize(1);
  run.reported = run.analysis.loops;
  run.tighten = Tighten::none;
  return run;
}

LoopsRun empty_run() {
  LoopsRun run;
  run.file = "torus.raw";
  run.volume = sample_volume();
  run.range = {-1.0, 2.0};
  run.level = {.iso = 7.0, .inside = InsideRule::above};
  return run;
}

}  // namespace isoloop
