// Features: how far handles and tunnels extend, as a table, as JSON and as labels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/runs/run_result.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// The place of the loop in Analysis::loops and LoopsRun::features. Its label is one more.
std::size_t place_of(const LoopsRun& run, const Loop& loop);

/// The feature's axis in the frame of the volume.
Vec3 world_axis(const LoopsRun& run, const Feature& feature);

/// One row for each reported loop, as write_table() has them: label, area, depth, thickness, girths
/// and axis of its feature.
void write_features(std::ostream& out, const LoopsRun& run, std::size_t most_rows = 0);

/// `label`, `area`, `axis` (in the frame of the volume), `depth`, `thickness`, `least_girth`,
/// `mean_girth`.
nlohmann::ordered_json feature_json(const LoopsRun& run, const Loop& loop);

/// By vertex of M: the label of the reported loop whose feature it belongs to, of several the
/// shortest; 0 for none.
std::vector<std::uint32_t> vertex_labels(const LoopsRun& run);

/// A volume like the input: the voxels on either side of M beside the vertices of a reported loop's
/// feature have its label, of several the shortest loop's, all others 0. uint16, or uint32 where
/// labels outgrow it; named "labels". Throws LimitExceeded where it and, to write it,
/// `writer_bytes_per_voxel` would take more than run.cost.max_bytes leaves.
Volume label_volume(const LoopsRun& run, std::uint64_t writer_bytes_per_voxel = 0);

}  // namespace isoloop
