#include "core/analysis/workings.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>

#include "core/analysis/room.h"
#include "core/base/errors.h"
#include "core/base/run_both.h"
#include "core/base/stage.h"
#include "core/base/threads.h"
#include "core/complex/grid_complex.h"
#include "core/complex/grid_sizes.h"
#include "core/complex/octree_sizes.h"
#include "core/cube/voxel_sides.h"
#include "core/engines/dual_pass.h"
#include "core/loops/certificate.h"
#include "core/loops/killing_border.h"
#include "core/loops/pair_loops.h"
#include "core/octree/leaves.h"
#include "core/sizes/closest.h"
#include "core/surface/edge_index.h"
#include "core/tighten/shortest_basis.h"
#include "core/tighten/straighten.h"

namespace isoloop {
namespace {

/// Times the stages, tells of each as it starts, and names it where it finds no memory.
class StageClock {
 public:
  explicit StageClock(const Progress& progress) : progress_(progress) {}

  template <class Work>
  auto run(const char* stage, double share_done, double& seconds, const Work& work) {
    if (progress_) progress_(stage, share_done);
    const auto start = std::chrono::steady_clock::now();
    auto result = in_stage(stage, work);
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
  }

 private:
  const Progress& progress_;
};

/// What depends on the sides of the voxels alone, and M.
struct Cut {
  std::unique_ptr<const VoxelSides> sides;
  std::unique_ptr<const EdgeIndex> edges;
  Surface surface;
};

Cut cut_volume(const AnyGridView& grid, const IsoLevel& level, const AnalysisOptions& options,
               bool with_graph) {
  Cut cut;
  cut.sides =
      std::make_unique<VoxelSides>(classify(grid, level, options.boundary, options.max_bytes));
  cut.edges = std::make_unique<EdgeIndex>(*cut.sides);
  const std::uint64_t lattice = cut.sides->lattice.vertex_count();
  check_memory("surface",
               with_graph ? surface_bytes(lattice, cut.edges->count())
                          : bare_surface_bytes(lattice, cut.edges->count()),
               options.max_bytes);
  cut.surface = extract_surface(grid, level, *cut.sides, *cut.edges, with_graph);
  return cut;
}

/// Sizes of the edges of the complex at hand.
using AnySizes = std::variant<EdgeSizes, OctreeEdgeSizes>;

std::uint64_t bytes_of(const EdgeSizes& sizes) { return sizes.by_edge.bytes(); }
std::uint64_t bytes_of(const OctreeEdgeSizes& sizes) { return sizes.bytes(); }

/// A side's complex and the sizes of its pieces and edges.
const GridComplex& complex_of(const WorkedSide& side, const EdgeSizes&) { return *side.complex; }
const OctreeComplex& complex_of(const WorkedSide& side, const OctreeEdgeSizes&) {
  return *side.octree;
}
GridSizes sizes_on(const Workings& workings, const WorkedSide& side, const EdgeSizes& sizes) {
  return {*side.complex, *workings.edges, sizes};
}
OctreeSizes sizes_on(const Workings& workings, const WorkedSide& side,
                     const OctreeEdgeSizes& sizes) {
  return {*side.octree, *workings.edges, sizes};
}

/// Runs the dual pass on both sides; `at_once`: at a time, which takes the memory of two.
template <class Sizes>
void run_passes(const Surface& surface, const Sizes& sizes, Workings& workings, bool at_once) {
  const auto solve = [&](WorkedSide& side, const char* name) {
    const auto& complex = complex_of(side, sizes);
    side.pass = dual_pass(complex, sizes_on(workings, side, sizes));
    if (!labels_are_consistent(complex, side.pass))
      throw SelfCheckFailed(std::string("the labels ") + name +
                            " do not sum to zero round an edge");
  };
  const auto solve_inside = [&] { solve(workings.inside, "inside"); };
  const auto solve_outside = [&] { solve(workings.outside, "outside"); };
  if (at_once) {
    run_both(solve_inside, solve_outside);
  } else {
    solve_inside();
    solve_outside();
  }
  const auto in = static_cast<std::int64_t>(workings.inside.pass.killing.size());
  const auto out = static_cast<std::int64_t>(workings.outside.pass.killing.size());
  if (in + out != surface.betti1() || (surface.boundary == Boundary::closed && in != out))
    throw SelfCheckFailed("the surface has " + std::to_string(surface.betti1()) +
                          " independent loops, but " + std::to_string(in) +
                          " generators survive inside and " + std::to_string(out) + " outside");
}

/// Both engines ran under the same total order, so they must name the same killing pieces.
void check_engines_agree(const std::vector<SurfacePair>& pairs, const Workings& workings) {
  for (const Side side : {Side::inside, Side::outside}) {
    const DualPass& pass = workings.on(side).pass;
    std::vector<std::uint32_t> of_pair;
    for (const SurfacePair& pair : pairs)
      if (pair.side == side) of_pair.push_back(pair.piece);
    const auto same_piece = [](std::uint32_t piece, const KillingPiece& killing) {
      return piece == killing.piece;
    };
    if (!std::equal(of_pair.begin(), of_pair.end(), pass.killing.begin(), pass.killing.end(),
                    same_piece))
      throw SelfCheckFailed("PAIR and the dual pass find different killing pieces");
  }
}

/// A side with the borders of the surfaces that its labels span, and their classes.
WorkedSide with_borders(const Surface& surface, const SurfaceClasses& classes, WorkedSide side) {
  side.borders =
      on_complex(side, [&](const auto& complex) { return killing_borders(complex, side.pass); });
  const Side seen_from = side_of(kind_on(surface.boundary, side.complex->side()));
  side.border_classes = border_classes(surface, classes, seen_from, side.borders);
  return side;
}

/// Of K off M, on both sides.
std::uint64_t count_volume_triangles(const Workings& workings) {
  const auto count = [](const auto& complex) { return fan_triangle_count(complex); };
  return on_complex(workings.inside, count) + on_complex(workings.outside, count);
}

SearchedLoops found_on(const Workings& workings, const WorkedSide& side,
                       std::span<const std::uint32_t> closest, double shorten_below) {
  const std::vector<Curve> starts = on_complex(side, [&](const auto& complex) {
    return starts_near(complex, side.pass.killing,
                       [&](std::uint32_t corner) { return closest[workings.vertex_at(corner)]; });
  });
  return loops_of_side(workings.analysis.surface, workings.classes,
                       {side.complex->side(), side.pass.killing, starts, side.borders,
                        side.border_classes, shorten_below});
}

std::vector<Loop> joined(std::vector<Loop> handles, std::vector<Loop> tunnels) {
  std::move(tunnels.begin(), tunnels.end(), std::back_inserter(handles));
  return handles;
}

struct LoopsAsFound {
  std::vector<Loop> loops;
  double slowest_seconds = 0.0;  // see StageSeconds
};

LoopsAsFound found_loops(const Workings& workings, const AnalysisOptions& options,
                         std::span<const std::uint32_t> closest) {
  const Surface& surface = workings.analysis.surface;
  if (options.engine == Engine::pair) return {loops_of_pairs(surface, workings.analysis.pairs)};
  SearchedLoops inside =
      found_on(workings, workings.inside, closest, options.shorten_below.handles);
  SearchedLoops outside =
      found_on(workings, workings.outside, closest, options.shorten_below.tunnels);
  inside.seconds.insert(inside.seconds.end(), outside.seconds.begin(), outside.seconds.end());
  const bool open = surface.boundary == Boundary::open;
  return {open ? merged_by_size(std::move(inside.loops), std::move(outside.loops))
               : joined(std::move(inside.loops), std::move(outside.loops)),
          slowest_hundredth(std::move(inside.seconds))};
}

struct ProvedLoops {
  std::vector<Loop> loops;
  double least_handle_length = 0.0;  // see Analysis
  double least_tunnel_length = 0.0;
  double slowest_seconds = 0.0;  // see StageSeconds
};

/// The loops of both sides, certified and tightened as the options say.
ProvedLoops proved_loops(const Workings& workings, const AnalysisOptions& options,
                         std::span<const std::uint32_t> closest) {
  const Surface& surface = workings.analysis.surface;
  const SurfaceClasses& classes = workings.classes;
  LoopsAsFound found = found_loops(workings, options, closest);
  ProvedLoops proved;
  proved.slowest_seconds = found.slowest_seconds;
  proved.loops = certified(surface, classes, std::move(found.loops));
  if (options.tighten != Tighten::none && surface.boundary == Boundary::closed) {
    const SideLoops handles{loops_of_kind(proved.loops, LoopKind::handle),
                            workings.inside.border_classes};
    const SideLoops tunnels{loops_of_kind(proved.loops, LoopKind::tunnel),
                            workings.outside.border_classes};
    const ShortenBelow& limit = options.shorten_below;
    ShortenedBasis short_handles =
        shorten_basis(surface, classes, handles, tunnels, {.longest = limit.handles});
    ShortenedBasis short_tunnels =
        shorten_basis(surface, classes, tunnels, {short_handles.loops, handles.border_classes},
                      {.longest = limit.tunnels});
    proved.least_handle_length = short_handles.least_length;
    proved.least_tunnel_length = short_tunnels.least_length;
    proved.loops = certified(
        surface, classes, joined(std::move(short_handles.loops), std::move(short_tunnels.loops)));
    if (options.tighten == Tighten::curve)
      proved.loops = straightened(surface, classes, std::move(proved.loops));
  }
  check_measures(proved.loops);
  return proved;
}

/// M, with the sides and cut edges that it is read off, and its counts.
Workings cut_workings(StageClock& clock, const AnyGridView& grid, const IsoLevel& level,
                      const AnalysisOptions& options) {
  Workings workings;
  Analysis& analysis = workings.analysis;
  analysis.surface = clock.run("surface", 0.0, analysis.seconds.surface, [&] {
    Cut cut = cut_volume(grid, level, options, true);
    workings.sides = std::move(cut.sides);
    workings.edges = std::move(cut.edges);
    return std::move(cut.surface);
  });
  analysis.betti = betti_numbers(analysis.surface);
  return workings;
}

/// An octree pays where it has less than one in so many of the grid's cells: each takes longer
/// than one of the grid does (docs/octree.md).
constexpr std::uint64_t paying_share = 5;

/// Makes the complexes that the options ask for.
void choose_complex(const AnalysisOptions& options, Workings& workings) {
  const VoxelSides& sides = *workings.sides;
  for (WorkedSide* side : {&workings.inside, &workings.outside})
    side->complex = std::make_unique<GridComplex>(
        sides, *workings.edges, side == &workings.inside ? Side::inside : Side::outside);
  workings.analysis.complex = ComplexKind::grid;
  if (options.complex == ComplexKind::grid) return;
  const Leaves leaves = graded_leaves(sides, workings.analysis.surface.spacing, options.grading);
  const auto& [nx, ny, nz] = leaves.cubes;
  if (options.complex == ComplexKind::automatic &&
      paying_share * leaf_count(leaves) >= std::uint64_t{nx} * ny * nz)
    return;
  workings.octree = std::make_unique<const Octree>(sides, leaves);
  for (WorkedSide* side : {&workings.inside, &workings.outside})
    side->octree = std::make_unique<OctreeComplex>(*workings.octree, *side->complex);
  workings.analysis.complex = ComplexKind::octree;
}

/// The vertices of M closest to those of the complex.
UnsetVector<std::uint32_t> closest_to_vertices(const Workings& workings) {
  const Surface& surface = workings.analysis.surface;
  return workings.octree ? closest_surface_vertices(*workings.octree, surface)
                         : closest_surface_vertices(*workings.sides, *workings.edges, surface);
}

AnySizes edge_sizes(const Workings& workings, std::span<const std::uint32_t> closest,
                    GeodesicMode mode) {
  const Surface& surface = workings.analysis.surface;
  if (workings.octree)
    return octree_edge_sizes(*workings.octree, *workings.edges, surface, closest, mode);
  return geodesic_sizes(*workings.sides, *workings.edges, surface, closest, mode);
}

/// The passes of both sides, and the pairs if they are asked for.
template <class Sizes>
void run_engines(StageClock& clock, const Sizes& sizes, const Room::Passes& passes,
                 const AnalysisOptions& options, Workings& workings) {
  Analysis& analysis = workings.analysis;
  clock.run("pass", 0.5, analysis.seconds.pass, [&] {
    with_threads(passes.threads,
                 [&] { run_passes(analysis.surface, sizes, workings, passes.both_sides_at_once); });
    return true;
  });
  if (options.engine != Engine::pair) return;
  analysis.pairs = clock.run("pair", 0.7, analysis.seconds.pair, [&] {
    std::vector<SurfacePair> pairs = pair_simplices(
        analysis.surface,
        SizedSide{complex_of(workings.inside, sizes), sizes_on(workings, workings.inside, sizes)},
        SizedSide{complex_of(workings.outside, sizes), sizes_on(workings, workings.outside, sizes)},
        options.pair);
    if (orders_by_size(options.pair.refinement)) check_engines_agree(pairs, workings);
    return pairs;
  });
}

/// The classes of M's edges, from the labels of both sides.
SurfaceClasses classes_of(const Surface& surface, const Workings& workings) {
  const auto& [inside, outside] = std::tie(workings.inside, workings.outside);
  if (surface.boundary == Boundary::open) return surface_classes(surface);
  return workings.octree
             ? surface_classes(surface, *inside.octree, inside.pass, *outside.octree, outside.pass)
             : surface_classes(surface, *inside.complex, inside.pass, *outside.complex,
                               outside.pass);
}

/// The classes, the borders and from them the loops; `searches`: threads at a time.
void prove_loops(StageClock& clock, std::span<const std::uint32_t> closest, int searches,
                 const AnalysisOptions& options, Workings& workings) {
  Analysis& analysis = workings.analysis;
  const Surface& surface = analysis.surface;
  WorkedSide& inside = workings.inside;
  WorkedSide& outside = workings.outside;
  ProvedLoops proved = clock.run("loops", 0.8, analysis.seconds.loops, [&] {
    workings.classes = classes_of(surface, workings);
    inside = with_borders(surface, workings.classes, std::move(inside));
    outside = with_borders(surface, workings.classes, std::move(outside));
    return with_threads(searches, [&] { return proved_loops(workings, options, closest); });
  });
  analysis.seconds.slowest_loops = proved.slowest_seconds;
  analysis.loops = std::move(proved.loops);
  analysis.least_handle_length = proved.least_handle_length;
  analysis.least_tunnel_length = proved.least_tunnel_length;
}

}  // namespace

Analysis count_topology(const AnyGridView& grid, const IsoLevel& level,
                        const AnalysisOptions& options) {
  StageClock clock(options.progress);
  Analysis analysis;
  analysis.surface = clock.run("surface", 0.0, analysis.seconds.surface,
                               [&] { return cut_volume(grid, level, options, false).surface; });
  analysis.betti = betti_numbers(analysis.surface);
  return analysis;
}

Analysis analyze(const AnyGridView& grid, const IsoLevel& level, const AnalysisOptions& options) {
  return work_out_loops(grid, level, options).analysis;
}

Workings work_out_loops(const AnyGridView& grid, const IsoLevel& level,
                        const AnalysisOptions& options) {
  StageClock clock(options.progress);
  Workings workings = cut_workings(clock, grid, level, options);
  const Surface& surface = workings.analysis.surface;
  if (surface.betti1() != 0 || (options.count_volume_triangles && !workings.sides->empty()))
    choose_complex(options, workings);
  if (options.count_volume_triangles && !workings.sides->empty())
    workings.analysis.volume_triangles = count_volume_triangles(workings);
  if (surface.betti1() == 0) return workings;
  StageSeconds& seconds = workings.analysis.seconds;
  const Room room(workings, options.max_bytes);
  room.check_closest();
  const UnsetVector<std::uint32_t> closest =
      clock.run("closest", 0.05, seconds.closest, [&] { return closest_to_vertices(workings); });
  const int size_searches = room.size_searches();
  auto sizes = clock.run("sizes", 0.1, seconds.sizes, [&] {
    return with_threads(size_searches, [&] {
      return std::make_unique<AnySizes>(edge_sizes(workings, closest, options.geodesic));
    });
  });
  const Room::Passes passes =
      room.passes(std::visit([](const auto& of_edges) { return bytes_of(of_edges); }, *sizes));
  const int loop_searches = room.loop_searches();  // refused before the pass, which takes longest
  std::visit([&](const auto& of_edges) { run_engines(clock, of_edges, passes, options, workings); },
             *sizes);
  sizes.reset();
  prove_loops(clock, closest, loop_searches, options, workings);
  return workings;
}

}  // namespace isoloop
