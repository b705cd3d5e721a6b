#include "volume/voxelize/voxelize_auto.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/base/errors.h"
#include "volume/base/rounded_text.h"
#include "volume/mesh/mesh_box.h"
#include "volume/mesh_topology/mesh_counts.h"

namespace isoloop {
namespace {

struct Attempt {
  std::int64_t resolution = 0;
  Betti betti{};
};

/// "at 64 b0 1, b1 1, b2 0; at 128 ...".
std::string text(const std::vector<Attempt>& attempts) {
  std::string text;
  for (const Attempt& attempt : attempts) {
    text += (text.empty() ? "at " : "; at ") + std::to_string(attempt.resolution) + ' ' +
            betti_text(attempt.betti);
  }
  return text;
}

std::uint64_t voxel_bytes(const Volume& volume) {
  return static_cast<std::uint64_t>(volume.dims[0] * volume.dims[1] * volume.dims[2]) *
         sizeof(float);
}

Betti betti_of(const Volume& volume, std::uint64_t max_bytes) {
  const std::uint64_t held = voxel_bytes(volume);
  return count_topology(view(volume), {0.0, InsideRule::below},
                        {.max_bytes = max_bytes - std::min(max_bytes, held)})
      .betti;
}

/// The volume at a resolution with its counts; or the limit that has no room for them.
struct Step {
  std::optional<Volume> volume{};
  Betti betti{};
  std::optional<LimitExceeded> limit{};
};

Step step_at(std::int64_t resolution, const Mesh& mesh, const MeshCounts& counts,
             const VoxelLimits& limits, const std::string& what) {
  Step step;
  try {
    Volume volume = voxelize(mesh, {.resolution = resolution}, limits, what, counts);
    step.betti = betti_of(volume, limits.max_bytes);
    step.volume = std::move(volume);
  } catch (const LimitExceeded& error) {
    step.limit = error;
  } catch (const std::bad_alloc&) {
    step.limit = LimitExceeded({.file = what, .text = "there is not enough memory"});
  }
  return step;
}

/// Whether the last counts are the mesh's own, or where it has none those of the step before.
bool ends_with_answer(const std::vector<Attempt>& attempts, const MeshCounts& counts) {
  const Betti& last = attempts.back().betti;
  if (counts.betti) return *counts.betti == last;
  return attempts.size() > 1 && attempts[attempts.size() - 2].betti == last;
}

/// How far counts are from the mesh's own; 0 where it has none.
std::int64_t distance(const Betti& betti, const MeshCounts& counts) {
  if (!counts.betti) return 0;
  return std::abs(betti.b0 - counts.betti->b0) + std::abs(betti.b1 - counts.betti->b1) +
         std::abs(betti.b2 - counts.betti->b2);
}

/// What was found, for the reader of the result.
Finding account(const std::vector<Attempt>& attempts, const Attempt& best,
                const std::optional<LimitExceeded>& limit, const MeshCounts& counts) {
  std::string how;
  if (limit) {
    how = counts.betti ? ", the nearest to the mesh's own counts"
                       : ", the finest, whose counts may not stay";
  } else if (!counts.betti) {
    how = ", whose counts are those of half the resolution";
  }
  std::string found = ": the voxels have " + text(attempts);
  found += counts.betti ? ", the mesh itself " + betti_text(*counts.betti)
                        : ", and the mesh has no counts of its own, because " + counts.unknown;
  if (counts.gap) found += " with shells " + rounded_text(*counts.gap, 4) + " apart";
  if (limit) found += "; a limit ended it: " + limit->finding.text;
  return {.about = Option::automatic_resolution,
          .text = "took " + std::to_string(best.resolution) + how + found,
          .advice = limit ? limit->finding.advice : std::vector<Advice>{}};
}

/// As a warning where the counts are not proved to be those of the mesh.
void tell(Finding account, bool is_proved, const std::string& what, Volume& volume) {
  if (!is_proved) account.file = what;
  (is_proved ? volume.notes : volume.warnings).push_back(std::move(account));
}

}  // namespace

Volume voxelize_until_counts_agree(const Mesh& mesh, const VoxelSize& size,
                                   const VoxelLimits& limits, const std::string& what) {
  if (size.length || size.resolution) {
    throw InvalidArgument({.file = what,
                           .about = Option::automatic_resolution,
                           .text = "does not go with another size of voxels"});
  }
  const std::uint64_t max_bytes = limits.max_bytes == 0 ? default_voxel_limit() : limits.max_bytes;
  const MeshCounts counts =
      count_mesh(mesh, diagonal(box_of(mesh)) / static_cast<double>(first_resolution), max_bytes);
  VoxelLimits left{max_bytes, limits.max_voxels > 0 ? limits.max_voxels : most_automatic_voxels};
  std::vector<Attempt> attempts;
  Attempt best;
  std::optional<Volume> volume;  // that of the best
  std::optional<LimitExceeded> limit;
  for (std::int64_t resolution = first_resolution;; resolution *= 2) {
    Step step = step_at(resolution, mesh, counts, left, what);
    if (!step.volume) {
      if (!volume) throw *step.limit;
      limit = step.limit;
      break;
    }
    attempts.push_back({resolution, step.betti});
    if (!volume || distance(step.betti, counts) <= distance(best.betti, counts)) {
      best = attempts.back();
      volume = std::move(step.volume);
    }
    if (ends_with_answer(attempts, counts)) break;
    // The best so far is kept while the next is made.
    left.max_bytes = max_bytes - std::min(max_bytes - 1, voxel_bytes(*volume));
  }
  volume->mesh->voxels = best.betti;
  tell(account(attempts, best, limit, counts), counts.betti && !limit, what, *volume);
  return std::move(*volume);
}

}  // namespace isoloop
