#include "tools/reports/report_features.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "core/base/memory_budget.h"
#include "tools/reports/report_table.h"
#include "tools/words/number_text.h"
#include "tools/words/text_rows.h"
#include "volume/base/memory_limit.h"

namespace isoloop {
namespace {

Row<9> row_of(const LoopsRun& run, const Loop& loop) {
  const std::size_t place = place_of(run, loop);
  const Feature& feature = run.features[place];
  const int decimals = length_decimals(run.volume.spacing);
  const Vec3 axis = world_axis(run, feature);
  std::string axis_text;
  for (const double x : axis)
    axis_text.append(axis_text.empty() ? "(" : ", ").append(fixed_text(x, 2));
  return {std::to_string(loop.id),
          kind_text(loop.kind),
          std::to_string(place + 1),
          fixed_text(feature.area, decimals),
          fixed_text(feature.depth, decimals),
          fixed_text(feature.thickness(), decimals),
          fixed_text(feature.least_girth, decimals),
          fixed_text(feature.mean_girth, decimals),
          axis_text + ")"};
}

/// Reported loops, so that what shorter ones paint later is seen.
std::vector<const Loop*> longest_first(const LoopsRun& run) {
  std::vector<const Loop*> loops;
  for (const Loop& loop : run.reported) loops.push_back(&loop);
  std::stable_sort(loops.begin(), loops.end(),
                   [](const Loop* a, const Loop* b) { return a->length > b->length; });
  return loops;
}

/// The voxels at the ends of the grid edge that a vertex of M lies on, as far as they lie in the
/// volume and not in the layer round it. None for vertices within cubes.
template <class Visit>
void for_each_voxel_beside(const LoopsRun& run, std::uint32_t vertex, const Visit& visit) {
  const Surface& surface = run.analysis.surface;
  if (vertex >= surface.grid_edges.size()) return;
  const Index3& dims = run.volume.dims;
  for (const bool upper : {false, true}) {
    Index3 voxel{};
    bool within = true;
    for (std::size_t a = 0; a < 3; ++a) {
      const float x = surface.points[vertex][a];
      voxel[a] = static_cast<std::int64_t>(upper ? std::ceil(x) : std::floor(x));
      within = within && voxel[a] >= 0 && voxel[a] < dims[a];
    }
    if (within)
      visit(static_cast<std::size_t>(voxel[0] + dims[0] * (voxel[1] + dims[1] * voxel[2])));
  }
}

template <class T>
std::vector<T> label_values(const LoopsRun& run) {
  const Index3& dims = run.volume.dims;
  std::vector<T> values(static_cast<std::size_t>(dims[0] * dims[1] * dims[2]));
  for (const Loop* loop : longest_first(run)) {
    const std::size_t place = place_of(run, *loop);
    for (const std::uint32_t vertex : run.features[place].vertices)
      for_each_voxel_beside(run, vertex,
                            [&](std::size_t voxel) { values[voxel] = static_cast<T>(place + 1); });
  }
  return values;
}

}  // namespace

std::size_t place_of(const LoopsRun& run, const Loop& loop) {
  const std::span<const Loop> all = run.analysis.loops;
  const std::span<const Loop> of_kind = loops_of_kind(all, loop.kind);
  return static_cast<std::size_t>(of_kind.data() - all.data() + loop.id - 1);
}

Vec3 world_axis(const LoopsRun& run, const Feature& feature) {
  Vec3 world{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t c = 0; c < 3; ++c) world[c] += feature.axis[a] * run.volume.direction[a][c];
  return world;
}

void write_features(std::ostream& out, const LoopsRun& run, std::size_t most_rows) {
  if (run.reported.empty()) return;
  const Volume& volume = run.volume;
  std::vector<Row<9>> rows{{"id", "kind", "label", with_unit("area", volume, 2),
                            with_unit("depth", volume), with_unit("thickness", volume),
                            with_unit("least girth", volume), with_unit("mean girth", volume),
                            "axis"}};
  for (const Loop* loop : loops_in_rows(run, most_rows)) rows.push_back(row_of(run, *loop));
  out << "\nfeatures\n";
  write_rows(out, rows, {false, true, false, false, false, false, false, false, false});
  write_more(out, rows.size() - 1, run.reported.size());
}

nlohmann::ordered_json feature_json(const LoopsRun& run, const Loop& loop) {
  const std::size_t place = place_of(run, loop);
  const Feature& feature = run.features[place];
  return {{"label", place + 1},
          {"area", feature.area},
          {"axis", world_axis(run, feature)},
          {"depth", feature.depth},
          {"thickness", feature.thickness()},
          {"least_girth", feature.least_girth},
          {"mean_girth", feature.mean_girth}};
}

std::vector<std::uint32_t> vertex_labels(const LoopsRun& run) {
  std::vector<std::uint32_t> labels(run.analysis.surface.points.size());
  for (const Loop* loop : longest_first(run)) {
    const std::size_t place = place_of(run, *loop);
    for (const std::uint32_t vertex : run.features[place].vertices)
      labels[vertex] = static_cast<std::uint32_t>(place) + 1;
  }
  return labels;
}

Volume label_volume(const LoopsRun& run, std::uint64_t writer_bytes_per_voxel) {
  const bool many = run.analysis.loops.size() > std::numeric_limits<std::uint16_t>::max();
  const std::uint64_t bytes_per_voxel = (many ? 4 : 2) + writer_bytes_per_voxel;
  const std::uint64_t held = held_bytes(run.analysis.surface, run.features);
  check_memory("labels", held + checked_voxel_bytes(run.volume.dims, bytes_per_voxel, run.file),
               run.cost.max_bytes);
  Volume labels = {.dims = run.volume.dims,
                   .spacing = run.volume.spacing,
                   .unit = run.volume.unit,
                   .origin = run.volume.origin,
                   .direction = run.volume.direction,
                   .frame = run.volume.frame,
                   .name = "labels"};
  if (many) {
    labels.values = label_values<std::uint32_t>(run);
  } else {
    labels.values = label_values<std::uint16_t>(run);
  }
  return labels;
}

}  // namespace isoloop
