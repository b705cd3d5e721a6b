#include "core/engines/pair.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include "core/base/disjoint_sets.h"
#include "core/base/errors.h"
#include "core/base/run_both.h"
#include "core/complex/flat_complex.h"
#include "core/complex/grid_complex.h"
#include "core/complex/grid_sizes.h"
#include "core/complex/octree_complex.h"
#include "core/complex/octree_sizes.h"
#include "core/complex/order.h"
#include "core/surface/surface_order.h"
#include "core/z2/bit_column.h"
#include "core/z2/label.h"
#include "core/z2/z2_basis.h"

namespace isoloop {
namespace {

/// The pieces whose triangles may kill a cycle, oldest first. A piece that closes off a part of
/// the side gives birth to a void: its column reduces to 0 (clearing). By duality those are the
/// pieces that join two components of cells when the filtration is read backwards.
template <PairComplex C, Sizes S>
std::vector<std::uint32_t> killing_candidates(const SizedSide<C, S>& side, Refinement refinement) {
  std::vector<std::uint32_t> pieces = all_pieces(side.complex);
  if (orders_by_size(refinement)) {
    pieces = from_largest(side.sizes, std::move(pieces));
  } else {
    std::reverse(pieces.begin(), pieces.end());
  }
  DisjointSets cells(side.complex.cell_bound());
  std::size_t kept = 0;
  for (const std::uint32_t piece : pieces) {
    const auto [a, b] = side.complex.cells(piece);
    if (!cells.unite(a, b)) pieces[kept++] = piece;
  }
  pieces.resize(kept);
  std::reverse(pieces.begin(), pieces.end());
  return pieces;
}

std::uint32_t youngest_of(const BitColumn& column) {
  if (column.empty()) throw SelfCheckFailed("PAIR's columns and the voids contradict each other");
  return column.youngest();
}

struct SideRows {
  std::vector<std::uint32_t> of_edge;  // by interior edge
  std::uint32_t bound = 0;             // of all rows, those of M included
};

/// Rows of the edges off M: those of M are older, `first` in number.
template <PairComplex C, Sizes S>
SideRows rows_off_surface(const SizedSide<C, S>& side, Refinement refinement, std::uint32_t first) {
  std::vector<std::uint32_t> edges = all_edges(side.complex);
  if (edges.size() > std::numeric_limits<std::uint32_t>::max() - first)
    throw LimitExceeded(
        {.text = "the volume has too many edges for 32-bit rows", .advice = {Advice::take_part}});
  if (orders_by_size(refinement)) {
    std::vector<std::uint64_t> keys(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
      keys[i] = order_key(side.sizes.of_edge(edges[i]), edges[i]);
    boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < edges.size(); ++i) edges[i] = static_cast<std::uint32_t>(keys[i]);
  }
  SideRows rows{std::vector<std::uint32_t>(side.complex.edge_bound()), first};
  for (const std::uint32_t edge : edges) rows.of_edge[edge] = rows.bound++;
  return rows;
}

/// Reduced columns, one behind the other, found by their youngest row.
class ReducedColumns {
 public:
  explicit ReducedColumns(std::uint32_t bound) : places_(bound) {}

  bool has(std::uint32_t row) const { return places_[row].count != 0; }

  template <class Visit>
  void for_each_row(std::uint32_t youngest, const Visit& visit) const {
    const Place& place = places_[youngest];
    const std::uint32_t* row = rows_.data() + place.first;
    for (const std::uint32_t* end = row + place.count; row != end; ++row) visit(*row);
  }

  void add(std::uint32_t youngest, std::span<const std::uint32_t> rows) {
    places_[youngest] = {rows_.size(), static_cast<std::uint32_t>(rows.size())};
    rows_.insert(rows_.end(), rows.begin(), rows.end());
  }

 private:
  struct Place {
    std::size_t first = 0;
    std::uint32_t count = 0;  // 0: no column
  };
  std::vector<Place> places_;  // by youngest row
  std::vector<std::uint32_t> rows_;
};

/// A piece that kills, and the first cycle on M that its reduction comes to.
struct FirstCycle {
  Side side = Side::inside;
  std::uint32_t piece = 0;
  float size = 0.0F;  // of the piece
  std::vector<std::uint32_t> rows;
};

/// The reduction as far as edges off M go, which knows nothing of the other side.
template <PairComplex C, Sizes S>
class SidePairing {
 public:
  SidePairing(const Surface& surface, const SurfaceOrder& order, const SizedSide<C, S>& side,
              Refinement refinement)
      : surface_(surface),
        order_(order),
        side_(side),
        refinement_(refinement),
        rows_(rows_off_surface(side, refinement, order.row_count())),
        column_(rows_.bound),
        columns_(rows_.bound) {}

  /// Stops at `at_most` cycles, and where none is `missing` on either side; counts `missing` down.
  std::vector<FirstCycle> run(std::int64_t at_most, std::atomic<std::int64_t>& missing) {
    std::vector<FirstCycle> found;
    for (const std::uint32_t piece : killing_candidates(side_, refinement_)) {
      if (static_cast<std::int64_t>(found.size()) == at_most || missing <= 0) break;
      if (pair_off_surface(piece)) continue;
      found.push_back({Side::inside, piece, side_.sizes.of_piece(piece), {}});
      column_.drain(found.back().rows);
      --missing;
    }
    return found;
  }

 private:
  void load_border(std::uint32_t piece) {
    border_.clear();
    for (const std::uint32_t edge : side_.complex.edges_of(piece))
      border_.push_back(rows_.of_edge[edge]);
    for (const auto& segment : side_.complex.segments(piece))
      border_.push_back(row_between(surface_, order_, segment[0], segment[1]));
  }

  /// Pairs the piece with an edge off M, or leaves in column_ the first cycle on M: false.
  bool pair_off_surface(std::uint32_t piece) {
    load_border(piece);
    const std::uint32_t first = *std::max_element(border_.begin(), border_.end());
    if (!columns_.has(first)) {
      columns_.add(first, border_);
      return true;
    }
    for (const std::uint32_t row : border_) column_.flip(row);
    for (;;) {
      const std::uint32_t row = youngest_of(column_);
      if (row < order_.row_count()) return false;
      if (!columns_.has(row)) {
        border_.clear();
        column_.drain(border_);
        columns_.add(row, border_);
        return true;
      }
      columns_.for_each_row(row, [&](std::uint32_t r) { column_.flip(r); });
    }
  }

  const Surface& surface_;
  const SurfaceOrder& order_;
  const SizedSide<C, S>& side_;
  Refinement refinement_;
  SideRows rows_;
  BitColumn column_;
  ReducedColumns columns_;
  std::vector<std::uint32_t> border_;
};

struct Killing {
  Side side = Side::inside;
  std::uint32_t piece = 0;
  float size = 0.0F;                 // of the piece
  std::vector<std::uint32_t> cycle;  // rows
  GeneratorSet unpaired;             // of the cycle at the end of the reduction: rows of M's
                                     // edges that stay unpaired after M, ascending
};

/// The rest of the reduction, among edges of M alone.
class CyclePairing {
 public:
  CyclePairing(const Surface& surface, const SurfaceOrder& order, Refinement refinement)
      : surface_(surface),
        order_(order),
        refinement_(refinement),
        column_(order.row_count()),
        columns_(order.row_count()) {}

  /// Reduces a cycle down to an edge that is unpaired still.
  Killing reduce(const FirstCycle& first) {
    Killing killing{first.side, first.piece, first.size, {}, {}};
    load(first.rows);
    double length = 0.0;
    for (const std::uint32_t row : first.rows) length += length_of_row(row);
    double shortest = length;
    added_.clear();
    std::size_t added_to_shortest = 0;
    for (std::uint32_t row = youngest_of(column_); row >= order_.killed || columns_.has(row);
         row = youngest_of(column_)) {
      added_.push_back(row);
      for_each_row_of(row, [&](std::uint32_t r) {
        column_.flip(r);
        length += column_.holds(r) ? length_of_row(r) : -length_of_row(r);
      });
      if (!is_shorter(length, shortest)) continue;
      shortest = length;
      added_to_shortest = added_.size();
    }
    std::vector<std::uint32_t> last;
    column_.drain(last);
    for (auto row = last.rbegin(); row != last.rend(); ++row)
      if (*row >= order_.tree) killing.unpaired.push_back(*row);
    if (takes_shortest_cycle(refinement_)) {
      load(first.rows);  // and go there again
      for (std::size_t i = 0; i < added_to_shortest; ++i)
        for_each_row_of(added_[i], [&](std::uint32_t r) { column_.flip(r); });
      column_.drain(killing.cycle);
    } else {
      killing.cycle = last;
    }
    columns_.add(last.front(), last);
    return killing;
  }

 private:
  void load(std::span<const std::uint32_t> rows) {
    for (const std::uint32_t row : rows) column_.flip(row);
  }

  double length_of_row(std::uint32_t row) const {
    const auto& [a, b] = order_.edges[row];
    return distance(scaled_point(surface_, a), scaled_point(surface_, b));
  }

  /// Of the reduced column whose youngest row is `row`.
  template <class Visit>
  void for_each_row_of(std::uint32_t row, const Visit& visit) const {
    if (row >= order_.killed) {
      for (const std::uint32_t r : order_.killed_cycles[row - order_.killed]) visit(r);
    } else {
      columns_.for_each_row(row, visit);
    }
  }

  const Surface& surface_;
  const SurfaceOrder& order_;
  Refinement refinement_;
  BitColumn column_;
  std::vector<std::uint32_t> added_;  // columns, by their youngest row, while a cycle is reduced
  ReducedColumns columns_;
};

using FirstCycles = std::array<std::vector<FirstCycle>, 2>;  // inside, outside

template <PairComplex C, Sizes S>
FirstCycles find_first_cycles(const Surface& surface, const SurfaceOrder& order,
                              const SizedSide<C, S>& inside, const SizedSide<C, S>& outside,
                              Refinement refinement) {
  // How many classes die on each side is known where M is closed; together they are all of H1(M).
  const std::int64_t at_most =
      surface.boundary == Boundary::closed ? surface.genus() : surface.betti1();
  std::atomic<std::int64_t> missing = surface.betti1();
  FirstCycles found;
  const auto run = [&](Side at, const SizedSide<C, S>& side, std::vector<FirstCycle>& cycles) {
    cycles = SidePairing(surface, order, side, refinement).run(at_most, missing);
    for (FirstCycle& cycle : cycles) cycle.side = at;
  };
  run_both([&] { run(Side::inside, inside, found[0]); },
           [&] { run(Side::outside, outside, found[1]); });
  if (missing != 0)
    throw SelfCheckFailed("of " + std::to_string(surface.betti1()) +
                          " independent loops on the surface PAIR left " +
                          std::to_string(missing.load()) + " unpaired");
  return found;
}

/// Where the sides are told apart, each is reduced for itself; else both in the one order.
std::vector<Killing> reduce_cycles(const Surface& surface, const SurfaceOrder& order,
                                   FirstCycles found, Refinement refinement) {
  if (surface.boundary == Boundary::open) {
    std::vector<FirstCycle> merged;
    const auto key = [&](const FirstCycle& cycle) {
      return std::pair(orders_by_size(refinement) ? cycle.size : 0.0F, cycle.piece);
    };
    std::merge(found[0].begin(), found[0].end(), found[1].begin(), found[1].end(),
               std::back_inserter(merged),
               [&](const FirstCycle& a, const FirstCycle& b) { return key(a) < key(b); });
    found = {std::move(merged), {}};
  }
  std::vector<Killing> killings;
  for (const std::vector<FirstCycle>& cycles : found) {
    CyclePairing pairing(surface, order, refinement);
    for (const FirstCycle& cycle : cycles) killings.push_back(pairing.reduce(cycle));
  }
  return killings;
}

}  // namespace

bool is_shorter(double length, double other) { return length < other * (1.0 - 1e-9); }

bool takes_shortest_cycle(Refinement refinement) {
  return refinement == Refinement::first || refinement == Refinement::both;
}

bool orders_by_size(Refinement refinement) {
  return refinement == Refinement::second || refinement == Refinement::both;
}

template <PairComplex C, Sizes S>
std::vector<SurfacePair> pair_simplices(const Surface& surface, const SizedSide<C, S>& inside,
                                        const SizedSide<C, S>& outside,
                                        const PairOptions& options) {
  const SurfaceOrder order = order_surface(surface);
  FirstCycles found = find_first_cycles(surface, order, inside, outside, options.refinement);
  // The edges that pair in the one filtration of both sides: the cycles that come later are reduced
  // by all before them, whatever their side, so that no edge is taken twice.
  Z2Basis unpaired;
  std::vector<SurfacePair> pairs;
  for (const Killing& killing :
       reduce_cycles(surface, order, std::move(found), options.refinement)) {
    SurfacePair& pair = pairs.emplace_back();
    const auto edge = unpaired.add(killing.unpaired);
    if (!edge) throw SelfCheckFailed("a cycle that PAIR found bounds on both sides");
    pair.edge = order.edges[*edge];
    pair.side = killing.side;
    pair.piece = killing.piece;
    pair.size = killing.size;
    for (const std::uint32_t row : killing.cycle) pair.cycle.push_back(order.edges[row]);
  }
  return pairs;
}

template <PairComplex C>
std::uint64_t fan_triangle_count(const C& complex) {
  std::uint64_t triangles = 0;
  for (const std::uint32_t piece : all_pieces(complex)) {
    const auto edges = complex.edges_of(piece);
    const auto segments = complex.segments(piece);
    triangles += static_cast<std::uint64_t>((edges.end() - edges.begin()) +
                                            (segments.end() - segments.begin()) - 2);
  }
  return triangles;
}

template std::vector<SurfacePair> pair_simplices(const Surface&,
                                                 const SizedSide<GridComplex, GridSizes>&,
                                                 const SizedSide<GridComplex, GridSizes>&,
                                                 const PairOptions&);
template std::vector<SurfacePair> pair_simplices(const Surface&,
                                                 const SizedSide<FlatComplex, FlatSizes>&,
                                                 const SizedSide<FlatComplex, FlatSizes>&,
                                                 const PairOptions&);
template std::vector<SurfacePair> pair_simplices(const Surface&,
                                                 const SizedSide<GridComplex, FlatSizes>&,
                                                 const SizedSide<GridComplex, FlatSizes>&,
                                                 const PairOptions&);
template std::vector<SurfacePair> pair_simplices(const Surface&,
                                                 const SizedSide<OctreeComplex, OctreeSizes>&,
                                                 const SizedSide<OctreeComplex, OctreeSizes>&,
                                                 const PairOptions&);
template std::vector<SurfacePair> pair_simplices(const Surface&,
                                                 const SizedSide<OctreeComplex, FlatSizes>&,
                                                 const SizedSide<OctreeComplex, FlatSizes>&,
                                                 const PairOptions&);
template std::uint64_t fan_triangle_count(const GridComplex&);
template std::uint64_t fan_triangle_count(const OctreeComplex&);
template std::uint64_t fan_triangle_count(const FlatComplex&);

}  // namespace isoloop
