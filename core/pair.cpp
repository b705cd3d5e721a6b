#include "core/pair.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

#include <boost/sort/spreadsort/integer_sort.hpp>
#include <tbb/parallel_invoke.h>

#include "core/bit_column.h"
#include "core/disjoint_sets.h"
#include "core/errors.h"
#include "core/label.h"
#include "core/order.h"
#include "core/surface_order.h"

namespace isoloop {
namespace {

/// The pieces whose triangles may kill a cycle, oldest first. A piece that closes off a part of
/// the side gives birth to a void: its column reduces to 0 (clearing). By duality those are the
/// pieces that join two components of cells when the filtration is read backwards.
std::vector<std::uint32_t> killing_candidates(const GridComplex& complex, Refinement refinement) {
  std::vector<std::uint32_t> pieces;
  if (orders_by_size(refinement)) {
    pieces = pieces_from_largest(complex);
  } else {
    pieces = complex.pieces();
    std::reverse(pieces.begin(), pieces.end());
  }
  DisjointSets cells(complex.cell_bound());
  std::size_t kept = 0;
  for (const std::uint32_t piece : pieces) {
    const auto [a, b] = complex.cells(piece);
    if (!cells.unite(a, b)) pieces[kept++] = piece;
  }
  pieces.resize(kept);
  std::reverse(pieces.begin(), pieces.end());
  return pieces;
}

struct SideRows {
  std::vector<std::uint32_t> of_edge;  // by interior edge
  std::uint32_t bound = 0;             // of all rows, those of M included
};

/// Rows of the edges off M: those of M are older, `first` in number.
SideRows rows_off_surface(const GridComplex& complex, Refinement refinement, std::uint32_t first) {
  std::vector<std::uint32_t> edges = complex.edges();
  if (edges.size() > std::numeric_limits<std::uint32_t>::max() - first)
    throw LimitExceeded("the volume has too many edges for 32-bit rows: crop it");
  if (orders_by_size(refinement)) {
    std::vector<std::uint64_t> keys(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
      keys[i] =
          std::uint64_t{std::bit_cast<std::uint32_t>(complex.edge_size(edges[i]))} << 32 | edges[i];
    boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < edges.size(); ++i) edges[i] = static_cast<std::uint32_t>(keys[i]);
  }
  SideRows rows{std::vector<std::uint32_t>(complex.edge_bound()), first};
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

struct Killing {
  std::uint32_t piece = 0;
  std::vector<std::uint32_t> cycle;  // rows
  GeneratorSet unpaired;             // of the cycle at the end of the reduction: rows of M's
                                     // edges that stay unpaired after M, ascending
};

class SidePairing {
 public:
  SidePairing(const Surface& surface, const SurfaceOrder& order, const GridComplex& complex,
              Refinement refinement)
      : surface_(surface),
        order_(order),
        complex_(complex),
        refinement_(refinement),
        rows_(rows_off_surface(complex, refinement, order.row_count())),
        column_(rows_.bound),
        columns_(rows_.bound) {}

  std::vector<Killing> run(std::size_t genus) {
    std::vector<Killing> found;
    for (const std::uint32_t piece : killing_candidates(complex_, refinement_)) {
      if (found.size() == genus) break;
      if (pair_off_surface(piece)) continue;
      found.push_back(pair_on_surface(piece));
    }
    return found;
  }

 private:
  void load_border(std::uint32_t piece) {
    border_.clear();
    for (const std::uint32_t edge : complex_.edges_of(piece))
      border_.push_back(rows_.of_edge[edge]);
    for (const auto& segment : complex_.segments(piece))
      border_.push_back(row_between(surface_, order_, segment[0], segment[1]));
  }

  std::uint32_t youngest() const {
    if (column_.empty())
      throw SelfCheckFailed("PAIR's columns and the voids contradict each other");
    return column_.youngest();
  }

  void add_column(std::uint32_t row) {
    if (row >= order_.killed && row < order_.row_count()) {
      for (const std::uint32_t r : order_.killed_cycles[row - order_.killed]) column_.flip(r);
    } else {
      columns_.for_each_row(row, [&](std::uint32_t r) { column_.flip(r); });
    }
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
      const std::uint32_t row = youngest();
      if (row < order_.row_count()) return false;
      if (!columns_.has(row)) {
        border_.clear();
        column_.drain(border_);
        columns_.add(row, border_);
        return true;
      }
      add_column(row);
    }
  }

  /// Reduces the cycle on M in column_, down to an edge that is unpaired still.
  Killing pair_on_surface(std::uint32_t piece) {
    Killing killing{piece, {}, {}};
    if (takes_first_cycle(refinement_)) {
      column_.drain(killing.cycle);
      for (const std::uint32_t row : killing.cycle) column_.flip(row);
    }
    while (youngest() >= order_.killed || columns_.has(youngest())) add_column(youngest());
    border_.clear();
    column_.drain(border_);
    columns_.add(border_.front(), border_);
    if (!takes_first_cycle(refinement_)) killing.cycle = border_;
    for (auto row = border_.rbegin(); row != border_.rend(); ++row)
      if (*row >= order_.tree) killing.unpaired.push_back(*row);
    return killing;
  }

  const Surface& surface_;
  const SurfaceOrder& order_;
  const GridComplex& complex_;
  Refinement refinement_;
  SideRows rows_;
  BitColumn column_;
  ReducedColumns columns_;
  std::vector<std::uint32_t> border_;
};

/// The edges that pair in the filtration M, inside, outside: the cycles of the outside are reduced
/// by those of the inside too, so that no edge is taken twice.
class EdgePairing {
 public:
  std::uint32_t take(GeneratorSet rows) {
    while (!rows.empty()) {
      const auto taken = by_youngest_.find(rows.back());
      if (taken == by_youngest_.end()) break;
      rows = sum_of(rows, taken->second);
    }
    if (rows.empty()) throw SelfCheckFailed("a cycle that PAIR found bounds on both sides");
    const std::uint32_t youngest = rows.back();
    by_youngest_.emplace(youngest, std::move(rows));
    return youngest;
  }

 private:
  std::unordered_map<std::uint32_t, GeneratorSet> by_youngest_;
};

}  // namespace

bool takes_first_cycle(Refinement refinement) {
  return refinement == Refinement::first || refinement == Refinement::both;
}

bool orders_by_size(Refinement refinement) {
  return refinement == Refinement::second || refinement == Refinement::both;
}

std::vector<SurfacePair> pair_simplices(const Surface& surface, const GridComplex& inside,
                                        const GridComplex& outside, const PairOptions& options) {
  const SurfaceOrder order = order_surface(surface);
  const auto genus = static_cast<std::size_t>(surface.genus());
  std::vector<Killing> of_inside;
  std::vector<Killing> of_outside;
  tbb::parallel_invoke(
      [&] { of_inside = SidePairing(surface, order, inside, options.refinement).run(genus); },
      [&] { of_outside = SidePairing(surface, order, outside, options.refinement).run(genus); });
  EdgePairing edges;
  std::vector<SurfacePair> pairs;
  const auto append = [&](const GridComplex& complex, const std::vector<Killing>& killings) {
    if (killings.size() != genus)
      throw SelfCheckFailed("the surface has genus " + std::to_string(genus) + ", but PAIR found " +
                            std::to_string(killings.size()) + " pairs on one side");
    for (const Killing& killing : killings) {
      SurfacePair& pair = pairs.emplace_back();
      pair.edge = order.edges[edges.take(killing.unpaired)];
      pair.side = complex.side();
      pair.piece = killing.piece;
      pair.size = complex.size(killing.piece);
      for (const std::uint32_t row : killing.cycle) pair.cycle.push_back(order.edges[row]);
    }
  };
  append(inside, of_inside);
  append(outside, of_outside);
  return pairs;
}

std::uint64_t fan_triangle_count(const GridComplex& complex) {
  const std::vector<std::uint32_t> pieces = complex.pieces();
  return std::accumulate(
      pieces.begin(), pieces.end(), std::uint64_t{0}, [&](std::uint64_t sum, std::uint32_t piece) {
        return sum + complex.edges_of(piece).count + complex.segments(piece).count - 2;
      });
}

}  // namespace isoloop
