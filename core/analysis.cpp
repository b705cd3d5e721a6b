#include "core/analysis.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include <tbb/parallel_invoke.h>

#include "core/certificate.h"
#include "core/closest.h"
#include "core/dual_pass.h"
#include "core/edge_index.h"
#include "core/errors.h"
#include "core/grid_complex.h"
#include "core/killing_border.h"
#include "core/pair_loops.h"
#include "core/shortest_basis.h"
#include "core/sides.h"
#include "core/straighten.h"

namespace isoloop {
namespace {

/// Times the stages and tells of each as it starts.
class StageClock {
 public:
  explicit StageClock(const Progress& progress) : progress_(progress) {}

  template <class Work>
  auto run(const char* stage, double share_done, double& seconds, const Work& work) {
    if (progress_) progress_(stage, share_done);
    const auto start = std::chrono::steady_clock::now();
    auto result = work();
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
  }

 private:
  const Progress& progress_;
};

/// Everything that depends on the sides of the voxels and the shape of M alone.
struct Cut {
  Sides sides;
  EdgeIndex edges;
  Surface surface;
};

Cut cut_volume(const AnyGridView& grid, const IsoLevel& level, const AnalysisOptions& options,
               bool with_graph) {
  Sides sides = classify(grid, level, options.boundary, options.max_bytes);
  EdgeIndex edges(sides);
  check_memory("surface", surface_bytes(sides.lattice.vertex_count(), edges.count()),
               options.max_bytes);
  Surface surface = extract_surface(grid, level, sides, edges, with_graph);
  return {std::move(sides), std::move(edges), std::move(surface)};
}

struct Passes {
  DualPass inside;
  DualPass outside;
};

/// `at_once`: both sides at a time, which takes the memory of two.
Passes run_passes(const Surface& surface, const GridComplex& inside, const GridComplex& outside,
                  bool at_once) {
  Passes passes;
  const auto solve = [](const GridComplex& complex, DualPass& pass, const char* name) {
    pass = dual_pass(complex);
    if (!labels_are_consistent(complex, pass))
      throw SelfCheckFailed(std::string("the labels ") + name +
                            " do not sum to zero round an edge");
  };
  const auto solve_inside = [&] { solve(inside, passes.inside, "inside"); };
  const auto solve_outside = [&] { solve(outside, passes.outside, "outside"); };
  if (at_once) {
    tbb::parallel_invoke(solve_inside, solve_outside);
  } else {
    solve_inside();
    solve_outside();
  }
  const auto in = static_cast<std::int64_t>(passes.inside.killing.size());
  const auto out = static_cast<std::int64_t>(passes.outside.killing.size());
  if (in + out != surface.betti1() || (surface.boundary == Boundary::closed && in != out))
    throw SelfCheckFailed("the surface has " + std::to_string(surface.betti1()) +
                          " independent loops, but " + std::to_string(in) +
                          " generators survive inside and " + std::to_string(out) + " outside");
  return passes;
}

/// Both engines ran under the same total order, so they must name the same killing pieces.
void check_engines_agree(const std::vector<SurfacePair>& pairs, const Passes& passes) {
  for (const Side side : {Side::inside, Side::outside}) {
    const DualPass& pass = side == Side::inside ? passes.inside : passes.outside;
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

/// One side's borders and their classes, which say what each loop closes.
struct BorderedSide {
  KillingBorders borders;
  Z2Basis classes;
};

BorderedSide border_of(const Surface& surface, const SurfaceClasses& classes,
                       const GridComplex& complex, const DualPass& pass) {
  BorderedSide side{killing_borders(complex, pass), {}};
  const Side seen_from = side_of(kind_on(surface.boundary, complex.side()));
  side.classes = border_classes(surface, classes, seen_from, side.borders);
  return side;
}

/// What the passes leave to the search for loops.
struct Solved {
  const Surface& surface;
  const GridComplex& inside;
  const GridComplex& outside;
  const Passes& passes;
  const std::vector<std::uint32_t>& closest;
};

SurfaceClasses classes_of(const Solved& solved) {
  if (solved.surface.boundary == Boundary::open) return surface_classes(solved.surface);
  return surface_classes(solved.surface, solved.inside, solved.passes.inside, solved.outside,
                         solved.passes.outside);
}

std::vector<Loop> loops_near_pieces(const Solved& solved, const SurfaceClasses& classes,
                                    const BorderedSide& in, const BorderedSide& out) {
  std::vector<Loop> loops =
      loops_of_side(solved.surface, classes,
                    {solved.inside, solved.passes.inside, in.borders, in.classes}, solved.closest);
  std::vector<Loop> of_outside = loops_of_side(
      solved.surface, classes, {solved.outside, solved.passes.outside, out.borders, out.classes},
      solved.closest);
  if (solved.surface.boundary == Boundary::open)
    return merged_by_size(std::move(loops), std::move(of_outside));
  std::move(of_outside.begin(), of_outside.end(), std::back_inserter(loops));
  return loops;
}

/// Members as in Analysis.
struct ProvedLoops {
  std::vector<Loop> loops;
  double least_handle_length = 0.0;
  double least_tunnel_length = 0.0;
};

/// Finds and certifies the loops, and makes them as short as the options say.
ProvedLoops prove_loops(const Solved& solved, const AnalysisOptions& options,
                        const std::vector<SurfacePair>& pairs) {
  const Surface& surface = solved.surface;
  const SurfaceClasses classes = classes_of(solved);
  const BorderedSide in = border_of(surface, classes, solved.inside, solved.passes.inside);
  const BorderedSide out = border_of(surface, classes, solved.outside, solved.passes.outside);
  ProvedLoops proved;
  std::vector<Loop>& loops = proved.loops;
  loops = options.engine == Engine::pair ? loops_of_pairs(surface, pairs)
                                         : loops_near_pieces(solved, classes, in, out);
  certify(surface, classes, loops);
  if (options.tighten == Tighten::none || surface.boundary == Boundary::open) return proved;
  const SideLoops handles{{loops.data(), loops.size() / 2}, in.classes};
  const SideLoops tunnels{{loops.data() + loops.size() / 2, loops.size() / 2}, out.classes};
  proved.least_handle_length = shorten_basis(surface, classes, handles, tunnels);
  proved.least_tunnel_length = shorten_basis(surface, classes, tunnels, handles);
  certify(surface, classes, loops);
  if (options.tighten == Tighten::curve) straighten_loops(surface, classes, loops);
  return proved;
}

std::uint64_t count_volume_triangles(const Cut& cut) {
  const EdgeSizes no_sizes;  // counting asks for none
  return fan_triangle_count(GridComplex(cut.sides, cut.edges, no_sizes, Side::inside)) +
         fan_triangle_count(GridComplex(cut.sides, cut.edges, no_sizes, Side::outside));
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

Analysis find_loops(const AnyGridView& grid, const IsoLevel& level,
                    const AnalysisOptions& options) {
  StageClock clock(options.progress);
  Analysis analysis;
  StageSeconds& seconds = analysis.seconds;
  Cut cut = clock.run("surface", 0.0, seconds.surface,
                      [&] { return cut_volume(grid, level, options, true); });
  const Surface& surface = cut.surface;
  analysis.betti = betti_numbers(surface);
  if (surface.betti1() > 0) {
    const std::uint64_t lattice = cut.sides.lattice.vertex_count();
    check_memory("closest", closest_bytes(lattice, surface.points.size()), options.max_bytes);
    const std::vector<std::uint32_t> closest = clock.run("closest", 0.05, seconds.closest, [&] {
      return closest_surface_vertices(cut.sides, cut.edges, surface);
    });
    check_memory("sizes", sizes_bytes(lattice, surface.points.size()), options.max_bytes);
    const EdgeSizes sizes = clock.run("sizes", 0.1, seconds.sizes, [&] {
      return geodesic_sizes(cut.sides, cut.edges, surface, closest, options.geodesic);
    });
    check_memory("pass", pass_bytes(lattice, surface.points.size(), 1), options.max_bytes);
    const bool at_once = pass_bytes(lattice, surface.points.size(), 2) <= options.max_bytes;
    const GridComplex inside(cut.sides, cut.edges, sizes, Side::inside);
    const GridComplex outside(cut.sides, cut.edges, sizes, Side::outside);
    const Passes passes = clock.run("pass", 0.5, seconds.pass,
                                    [&] { return run_passes(surface, inside, outside, at_once); });
    if (options.engine == Engine::pair)
      analysis.pairs = clock.run("pair", 0.7, seconds.pair, [&] {
        std::vector<SurfacePair> pairs = pair_simplices(surface, inside, outside, options.pair);
        if (orders_by_size(options.pair.refinement)) check_engines_agree(pairs, passes);
        return pairs;
      });
    const Solved solved{surface, inside, outside, passes, closest};
    ProvedLoops proved = clock.run("loops", 0.8, seconds.loops,
                                   [&] { return prove_loops(solved, options, analysis.pairs); });
    analysis.loops = std::move(proved.loops);
    analysis.least_handle_length = proved.least_handle_length;
    analysis.least_tunnel_length = proved.least_tunnel_length;
  }
  if (options.count_volume_triangles && !cut.sides.empty())
    analysis.volume_triangles = count_volume_triangles(cut);
  analysis.surface = std::move(cut.surface);
  return analysis;
}

}  // namespace isoloop
