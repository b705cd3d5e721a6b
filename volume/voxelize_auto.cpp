#include "volume/voxelize_auto.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "core/analysis.h"
#include "core/errors.h"
#include "volume/mesh_box.h"

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

std::string short_text(double length) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.4g", length);
  return digits.data();
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

/// The volume at a resolution with its counts; or why the limits have no room for them.
struct Step {
  std::optional<Volume> volume{};
  Betti betti{};
  std::string limit{};
};

Step step_at(std::int64_t resolution, const Mesh& mesh, const MeshCounts& counts,
             const VoxelLimits& limits, const std::string& what) {
  Step step;
  try {
    Volume volume = voxelize(mesh, {.resolution = resolution}, limits, what, counts);
    step.betti = betti_of(volume, limits.max_bytes);
    step.volume = std::move(volume);
  } catch (const LimitExceeded& error) {
    step.limit = error.what();
  } catch (const std::bad_alloc&) {
    step.limit = what + ": there is not enough memory";
  }
  return step;
}

/// Whether the last counts are the mesh's own, or where it has none those of the step before.
bool ends_with_answer(const std::vector<Attempt>& attempts, const MeshCounts& counts) {
  const Betti& last = attempts.back().betti;
  if (counts.betti) return *counts.betti == last;
  return attempts.size() > 1 && attempts[attempts.size() - 2].betti == last;
}

/// What was found, for the reader of the result.
void tell(const std::vector<Attempt>& attempts, const std::string& limit, const MeshCounts& counts,
          const std::string& what, Volume& volume) {
  const std::string last = std::to_string(attempts.back().resolution);
  const std::string found = "the voxels have " + text(attempts);
  std::string own = counts.betti
                        ? ", the mesh itself " + betti_text(*counts.betti)
                        : ", and the mesh has no counts of its own, because " + counts.unknown;
  if (counts.gap) own += " with shells " + short_text(*counts.gap) + " apart";
  if (!limit.empty()) {
    volume.warnings.push_back(what + ": --resolution auto stopped at " + last + " before " +
                              (counts.betti ? "the counts agreed" : "the counts stayed the same") +
                              ": " + found + own + "; " + limit);
  } else if (counts.betti) {
    volume.notes.push_back("--resolution auto took " + last + ": " + found + own);
  } else {
    volume.warnings.push_back(what + ": --resolution auto took " + last +
                              ", whose counts are those of half the resolution: " + found + own);
  }
}

}  // namespace

Volume voxelize_until_counts_agree(const Mesh& mesh, const VoxelSize& size,
                                   const VoxelLimits& limits, const std::string& what) {
  if (size.length || size.resolution) {
    throw InvalidArgument(what + ": --resolution auto does not go with another size of voxels");
  }
  const std::uint64_t max_bytes = limits.max_bytes == 0 ? default_voxel_limit() : limits.max_bytes;
  const MeshCounts counts =
      count_mesh(mesh, diagonal(box_of(mesh)) / static_cast<double>(first_resolution), max_bytes);
  VoxelLimits left{max_bytes, limits.max_voxels > 0 ? limits.max_voxels : most_automatic_voxels};
  std::vector<Attempt> attempts;
  std::optional<Volume> best;
  std::string limit;
  for (std::int64_t resolution = first_resolution; limit.empty(); resolution *= 2) {
    Step step = step_at(resolution, mesh, counts, left, what);
    if (!step.volume) {
      if (!best) throw LimitExceeded(step.limit);
      limit = step.limit;
      break;
    }
    attempts.push_back({resolution, step.betti});
    best = std::move(step.volume);
    if (ends_with_answer(attempts, counts)) break;
    // The best so far is kept while the next is made.
    left.max_bytes = max_bytes - std::min(max_bytes - 1, voxel_bytes(*best));
  }
  best->mesh->voxels = attempts.back().betti;
  tell(attempts, limit, counts, what, *best);
  return std::move(*best);
}

}  // namespace isoloop
