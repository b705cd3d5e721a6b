#include "python/module/axes.h"

#include <cstdint>
#include <cstdio>
#include <utility>

#include "core/base/errors.h"

namespace isoloop::python {
namespace {

/// Whether a turn of the axes is a mirror image too.
bool mirrors(const Axes& axes) {
  return axes != Axes{0, 1, 2} && axes != Axes{1, 2, 0} && axes != Axes{2, 0, 1};
}

void turn_surface(const Axes& axes, SurfaceMesh& surface) {
  for (auto& point : surface.points) point = in_array_axes(axes, point);
  surface.spacing = in_array_axes(axes, surface.spacing);
  if (!mirrors(axes)) return;
  for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
}

void turn_loops(const Axes& axes, std::vector<Loop>& loops) {
  for (Loop& loop : loops) loop.center_index = in_array_axes(axes, loop.center_index);
}

}  // namespace

void check_axes(const Axes& axes) {
  std::array<bool, 3> met{};
  for (const std::size_t axis : axes)
    if (axis > 2 || std::exchange(met[axis], true))
      throw InvalidArgument("axes must be 0, 1 and 2 in some order");
}

void turn_to_array(const Axes& axes, CountRun& run) { turn_surface(axes, run.analysis.surface); }

void turn_to_array(const Axes& axes, LoopsRun& run) {
  turn_surface(axes, run.analysis.surface);
  turn_loops(axes, run.analysis.loops);
  turn_loops(axes, run.reported);
  for (Feature& feature : run.features) {
    feature.axis = in_array_axes(axes, feature.axis);
    // Its largest component is positive, of several the first: which one that is may change.
    std::size_t largest = 0;
    for (std::size_t a = 1; a < 3; ++a)
      if (std::abs(feature.axis[a]) > std::abs(feature.axis[largest])) largest = a;
    if (feature.axis[largest] < 0.0)
      for (double& x : feature.axis) x = 0.0 - x;
  }
}

void turn_to_array(const Axes& axes, RepairRun& run) {
  for (Analysis* analysis : {&run.repair.before, &run.repair.after}) {
    turn_surface(axes, analysis->surface);
    turn_loops(axes, analysis->loops);
  }
  for (Removal& removal : run.repair.removals)
    removal.center_index = in_array_axes(axes, removal.center_index);
  for (KeptLoop& kept : run.repair.kept) kept.center_index = in_array_axes(axes, kept.center_index);
}

std::string place_in_array(const Axes& axes, const std::string& place) {
  std::array<long long, 3> voxel{};
  int end = 0;
  if (std::sscanf(place.c_str(), "voxel (%lld, %lld, %lld)%n", &voxel[0], &voxel[1], &voxel[2],
                  &end) != 3 ||
      end != static_cast<int>(place.size()))
    return place;
  const auto [i, j, k] = in_array_axes(axes, voxel);
  return "voxel (" + std::to_string(i) + ", " + std::to_string(j) + ", " + std::to_string(k) + ")";
}

}  // namespace isoloop::python
