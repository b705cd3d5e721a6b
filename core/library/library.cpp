#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/base/errors.h"
#include "core/base/stage.h"
#include "core/base/threads.h"
#include "core/loops/features.h"
#include "core/octree/leaves.h"
#include "core/repair/repair.h"
#include "core/scan/proposal.h"
#include "isoloop/count.h"
#include "isoloop/loops.h"
#include "isoloop/repair.h"
#include "isoloop/scan.h"

namespace isoloop {
namespace {

constexpr const char* mismatch = "a grid must have as many values as its dims say, at least 1";

/// What the rooms take for granted, and a caller may get wrong.
void check_grid(const AnyGridView& grid) {
  std::visit(
      [](const auto& view) {
        std::size_t left = view.values.size();
        for (const std::int64_t dim : view.dims) {
          const auto n = static_cast<std::size_t>(dim);
          if (dim < 1 || left % n != 0) throw InvalidArgument(mismatch);
          left /= n;
        }
        if (left != 1) throw InvalidArgument(mismatch);
      },
      grid);
}

Counts counts_of(const Analysis& analysis) {
  const Surface& surface = analysis.surface;
  return {.betti = analysis.betti,
          .vertices = static_cast<std::int64_t>(surface.points.size()),
          .triangles = static_cast<std::int64_t>(surface.triangles.size()),
          .euler = surface.euler(),
          .genus = surface.genus(),
          .components = surface.components};
}

FoundLoops found(Analysis analysis, std::vector<Feature> features) {
  FoundLoops found;
  found.counts = counts_of(analysis);
  found.surface = static_cast<SurfaceMesh&&>(analysis.surface);
  found.loops = std::move(analysis.loops);
  found.features = std::move(features);
  found.complex = analysis.complex;
  found.least_handle_length = analysis.least_handle_length;
  found.least_tunnel_length = analysis.least_tunnel_length;
  return found;
}

}  // namespace

Counts count(const AnyGridView& grid, const IsoLevel& level, const CountOptions& options) {
  check_grid(grid);
  return on_threads(options.threads, [&] {
    return counts_of(count_topology(grid, level,
                                    {.boundary = options.boundary,
                                     .progress = options.progress,
                                     .max_bytes = options.max_bytes}));
  });
}

FoundLoops find_loops(const AnyGridView& grid, const IsoLevel& level, const LoopOptions& options) {
  check_grid(grid);
  if (options.feature_ratio && options.boundary == Boundary::open)
    throw InvalidArgument("features ask for a closed boundary");
  if (options.grading < 0 || options.grading > max_grading)
    throw InvalidArgument("the grading of an octree is 0, 1 or 2");
  return on_threads(options.threads, [&] {
    Analysis analysis = analyze(grid, level,
                                AnalysisOptions{.boundary = options.boundary,
                                                .geodesic = options.geodesic,
                                                .complex = options.complex,
                                                .grading = options.grading,
                                                .tighten = options.tighten,
                                                .progress = options.progress,
                                                .max_bytes = options.max_bytes});
    std::vector<Feature> features;
    if (options.feature_ratio)
      features = in_stage("features", [&] {
        return features_of(analysis.surface, analysis.loops,
                           {.ratio = *options.feature_ratio, .max_bytes = options.max_bytes});
      });
    return found(std::move(analysis), std::move(features));
  });
}

Scan scan(const AnyGridView& grid, std::span<const double> iso_values, const ScanOptions& options) {
  check_grid(grid);
  return on_threads(options.threads, [&] {
    return in_stage("scan", [&] { return scan_and_propose(grid, iso_values, options); });
  });
}

RepairResult repair(const AnyGridView& grid, const IsoLevel& level, const RepairRequest& request,
                    const RepairOptions& options) {
  check_grid(grid);
  return on_threads(options.threads, [&] {
    Repair repair = in_stage("repair", [&] {
      return repair_loops(grid, level, request,
                          {.geodesic = options.geodesic,
                           .progress = options.progress,
                           .max_bytes = options.max_bytes});
    });
    RepairResult result;
    result.before = counts_of(repair.before);
    result.after = counts_of(repair.after);
    static_cast<RepairChanges&>(result) = static_cast<RepairChanges&&>(repair);
    return result;
  });
}

}  // namespace isoloop
