#include "core/loops/certificate.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <tbb/parallel_for.h>

#include "core/base/errors.h"
#include "core/complex/grid_complex.h"
#include "core/complex/octree_complex.h"
#include "core/surface/surface_order.h"

namespace isoloop {
namespace {

constexpr auto no_turn = static_cast<std::uint32_t>(-1);

/// For a vertex of M: the class picked up on the way from the first cube round its grid edge to
/// each of the four, up to its wall if it has one, on both sides at once.
struct Turn {
  std::array<std::uint32_t, 4> cubes{};
  std::array<std::uint32_t, 4> labels{};

  std::uint32_t into(std::uint32_t cube) const {
    return labels[static_cast<std::size_t>(std::find(cubes.begin(), cubes.end(), cube) -
                                           cubes.begin())];
  }
};

template <BesideSurface C>
bool any_label(const C& complex, const DualPass& pass, std::uint32_t grid_edge) {
  const CutRing ring = complex.cut_ring(grid_edge);
  const auto has_label = [&](std::uint32_t piece) {
    return piece != no_piece && pass.labels[piece] != 0;
  };
  return std::any_of(ring.pieces.begin(), ring.pieces.end(), has_label) ||
         std::any_of(ring.walls.begin(), ring.walls.end(), has_label);
}

/// The labels of one side's pieces as numbers in the common pool.
class ImportedLabels {
 public:
  /// The generators' numbers are shifted by `shift`.
  ImportedLabels(const DualPass& pass, std::uint32_t shift, LabelPool& to)
      : pass_(pass), number_(pass.pool.count()) {
    for (std::uint32_t label = 0; label < pass.pool.count(); ++label) {
      const auto generators = pass.pool.generators(label);
      GeneratorSet shifted(generators.begin(), generators.end());
      for (std::uint32_t& generator : shifted) generator += shift;
      number_[label] = to.intern(shifted);
    }
  }

  std::uint32_t of(std::uint32_t piece) const {
    return piece == no_piece ? 0 : number_[pass_.labels[piece]];
  }

 private:
  const DualPass& pass_;
  std::vector<std::uint32_t> number_;  // by label of the pass
};

/// A side and its labels.
template <BesideSurface C>
struct LabelledSide {
  const C& complex;
  const DualPass& pass;
  ImportedLabels labels;
};

class Turns {
 public:
  template <BesideSurface C>
  Turns(const Surface& surface, const std::array<LabelledSide<C>, 2>& sides, LabelPool& pool)
      : number_(surface.points.size(), no_turn) {
    tbb::parallel_for(std::size_t{0}, surface.grid_edges.size(), [&](std::size_t v) {
      const std::uint32_t edge = surface.grid_edges[v];
      if (any_label(sides[0].complex, sides[0].pass, edge) ||
          any_label(sides[1].complex, sides[1].pass, edge))
        number_[v] = 0;
    });
    for (std::size_t v = 0; v < number_.size(); ++v) {
      if (number_[v] == no_turn) continue;
      number_[v] = static_cast<std::uint32_t>(turns_.size());
      Turn turn;
      for (const LabelledSide<C>& side : sides) {
        const auto ring = side.complex.cut_ring(surface.grid_edges[v]);
        turn.cubes = ring.cubes;
        std::uint32_t passed = 0;
        for (std::size_t i = 1; i < 4; ++i) {
          passed = pool.sum(
              passed, pool.sum(side.labels.of(ring.walls[i - 1]), side.labels.of(ring.pieces[i])));
          turn.labels[i] = pool.sum(turn.labels[i], passed);
        }
      }
      turns_.push_back(turn);
    }
  }

  std::uint32_t into(std::uint32_t vertex, std::uint32_t cube) const {
    return number_[vertex] == no_turn ? 0 : turns_[number_[vertex]].into(cube);
  }

 private:
  std::vector<std::uint32_t> number_;  // by vertex of M: its place in turns_, or no_turn
  std::vector<Turn> turns_;
};

/// A triangle's corner beyond a wall is one turn farther: adds the wall's label to both edges
/// there.
template <BesideSurface C>
void pass_walls(const Surface& surface, const LabelledSide<C>& side, SurfaceClasses& classes) {
  const auto& cubes = surface.triangle_cubes;
  for (const BeyondWall& beyond : side.complex.beyond_walls()) {
    const std::uint32_t label = side.labels.of(beyond.piece);
    if (label == 0) continue;
    const auto first = std::lower_bound(cubes.begin(), cubes.end(), beyond.cube) - cubes.begin();
    const auto& corners = surface.triangles[static_cast<std::size_t>(first) + beyond.triangle];
    for (const std::uint32_t i : {0U, 2U}) {
      const std::uint32_t from = corners[(beyond.corner + i) % 3];
      const std::uint32_t to = corners[(beyond.corner + i + 1) % 3];
      std::uint32_t& sum = classes.of_edge[edge_between(surface.graph, from, to)];
      sum = classes.pool.sum(sum, label);
    }
  }
}

}  // namespace

template <BesideSurface C>
SurfaceClasses surface_classes(const Surface& surface, const C& inside, const DualPass& inside_pass,
                               const C& outside, const DualPass& outside_pass) {
  SurfaceClasses classes;
  classes.inside_rank = static_cast<std::uint32_t>(inside_pass.killing.size());
  classes.outside_rank = static_cast<std::uint32_t>(outside_pass.killing.size());
  classes.of_edge.resize(surface.graph.lengths.size());
  const std::array<LabelledSide<C>, 2> sides{
      LabelledSide<C>{inside, inside_pass, ImportedLabels(inside_pass, 0, classes.pool)},
      LabelledSide<C>{outside, outside_pass,
                      ImportedLabels(outside_pass, classes.inside_rank, classes.pool)}};
  const Turns turns(surface, sides, classes.pool);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& corners = surface.triangles[t];
    std::array<std::uint32_t, 3> into{};
    for (int i = 0; i < 3; ++i) into[i] = turns.into(corners[i], surface.triangle_cubes[t]);
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t label = classes.pool.sum(into[i], into[(i + 1) % 3]);
      if (label == 0) continue;
      classes.of_edge[edge_between(surface.graph, corners[i], corners[(i + 1) % 3])] = label;
    }
  }
  for (const LabelledSide<C>& side : sides) pass_walls(surface, side, classes);
  return classes;
}

template SurfaceClasses surface_classes(const Surface&, const GridComplex&, const DualPass&,
                                        const GridComplex&, const DualPass&);
template SurfaceClasses surface_classes(const Surface&, const OctreeComplex&, const DualPass&,
                                        const OctreeComplex&, const DualPass&);

SurfaceClasses surface_classes(const Surface& surface) {
  const SurfaceOrder order = order_surface(surface);
  SurfaceClasses classes;
  classes.outside_rank = order.killed - order.tree;
  std::vector<std::uint32_t> of_row(order.row_count());
  for (std::uint32_t generator = 0; generator < classes.outside_rank; ++generator)
    of_row[order.tree + generator] = classes.pool.intern({&generator, 1});
  // A triangle's border has class 0; of its edges the youngest is last to get its value.
  for (std::uint32_t row = order.killed; row < order.row_count(); ++row)
    for (const std::uint32_t edge : order.killed_cycles[row - order.killed])
      if (edge != row) of_row[row] = classes.pool.sum(of_row[row], of_row[edge]);
  for (const std::uint32_t row : order.row_of_edge) classes.of_edge.push_back(of_row[row]);
  return classes;
}

GeneratorSet class_of(const Surface& surface, const SurfaceClasses& classes,
                      std::span<const Curve> curves) {
  GeneratorSet sum;
  for (const Curve& curve : curves)
    for_each_edge(curve, [&](std::uint32_t u, std::uint32_t v) {
      const std::uint32_t edge = edge_between(surface.graph, u, v);
      if (edge == no_edge)
        throw SelfCheckFailed("a loop leaves the surface between vertices " + std::to_string(u) +
                              " and " + std::to_string(v));
      if (classes.of_edge[edge] != 0)
        sum = sum_of(sum, classes.pool.generators(classes.of_edge[edge]));
    });
  return sum;
}

SplitClass split_class(const SurfaceClasses& classes, Side side,
                       std::span<const std::uint32_t> set) {
  const auto border = std::lower_bound(set.begin(), set.end(), classes.inside_rank);
  SplitClass parts{{set.begin(), border}, {border, set.end()}};
  for (std::uint32_t& generator : parts.other) generator -= classes.inside_rank;
  if (side == Side::outside) std::swap(parts.own, parts.other);
  return parts;
}

}  // namespace isoloop
