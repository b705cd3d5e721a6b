#include "core/engines/dual_pass.h"

#include <algorithm>
#include <atomic>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/complex/flat_complex.h"
#include "core/complex/grid_complex.h"
#include "core/complex/grid_sizes.h"
#include "core/complex/octree_complex.h"
#include "core/complex/octree_sizes.h"
#include "core/complex/order.h"
#include "core/engines/counted_rings.h"
#include "core/engines/spanning_forest.h"
#include "core/engines/zero_labels.h"
#include "core/z2/z2_basis.h"

namespace isoloop {
namespace {

/// What is there round an edge: the sum of the labels that are known, an unknown piece, and how
/// many are unknown.
struct RingState {
  std::uint32_t sum = 0;
  std::uint32_t last = 0;
  std::uint32_t unknown = 0;
};

/// Which pieces have labels, and what is there round an edge, by walking its ring.
class WalkedRings {
 public:
  WalkedRings(const GridComplex& complex, const BitSet& forest)
      : complex_(complex), known_(zero_labels(complex, forest)) {}

  const BitSet& known() const { return known_; }

  void set_known(std::uint32_t piece, std::uint32_t /*label*/, LabelPool& /*pool*/) {
    known_.insert(piece);
  }

  RingState at(std::uint32_t edge, const SparseLabels& labels, LabelPool& pool) const {
    RingState state;
    for (const std::uint32_t piece : complex_.ring(edge)) {
      if (known_[piece]) {
        state.sum = pool.sum(state.sum, labels[piece]);
      } else {
        state.last = piece;
        ++state.unknown;
      }
    }
    return state;
  }

 private:
  const GridComplex& complex_;
  BitSet known_;
};

/// The same by counting, with a sum kept for each edge that has one.
template <Complex C>
class SummedRings {
 public:
  SummedRings(const C& complex, BitSet forest)
      : complex_(complex), rings_(complex, std::move(forest)), sums_(complex.edge_bound()) {}

  const BitSet& known() const { return rings_.known(); }

  void set_known(std::uint32_t piece, std::uint32_t label, LabelPool& pool) {
    rings_.set_known(piece);
    if (label == 0) return;
    for (const std::uint32_t edge : complex_.edges_of(piece))
      sums_.set(edge, pool.sum(sums_[edge], label));
  }

  RingState at(std::uint32_t edge, const SparseLabels& /*labels*/, LabelPool& /*pool*/) const {
    return {sums_[edge], rings_.unknown_at(edge), rings_.unknown_round(edge)};
  }

 private:
  const C& complex_;
  CountedRings<C> rings_;
  SparseLabels sums_;  // of the labels that are known, by edge
};

/// A grid has bit planes for its zero labels, and rings that are found faster than counted.
template <Complex C>
using Rings = std::conditional_t<std::is_same_v<C, GridComplex>, WalkedRings, SummedRings<C>>;

/// Labels pieces; whenever all but one piece of a ring are labelled, the last one follows.
template <Complex C>
class Propagation {
 public:
  /// Pieces in `forest`, and all that follow, have label 0.
  Propagation(const C& complex, BitSet forest)
      : labels(complex.piece_bound()), complex_(complex), rings_(complex, std::move(forest)) {}

  const BitSet& known() const { return rings_.known(); }

  void assign(std::uint32_t piece, std::uint32_t label) {
    if (label != 0) labels.set(piece, label);
    rings_.set_known(piece, label, pool);
    for (const std::uint32_t edge : complex_.edges_of(piece)) todo_.push_back(edge);
  }

  /// Draws every conclusion from the labels so far. Rings that close with a sum other than 0 are
  /// relations between the generators.
  void run() {
    while (!todo_.empty()) {
      const std::uint32_t edge = todo_.back();
      todo_.pop_back();
      const RingState ring = rings_.at(edge, labels, pool);
      if (ring.unknown == 1)
        assign(ring.last, ring.sum);
      else if (ring.unknown == 0 && ring.sum != 0)
        relations.add(pool.generators(ring.sum));
    }
  }

  LabelPool pool;
  SparseLabels labels;
  /// Generators are numbered in order of birth, so that each relation expresses its pivot, the
  /// youngest of its own, by older ones.
  Z2Basis relations;

 private:
  const C& complex_;
  Rings<C> rings_;
  std::vector<std::uint32_t> todo_;
};

/// Replaces eliminated generators in all labels and renumbers the rest in order of killing.
template <Complex C, PieceSizes S>
DualPass finish(const S& sizes, Propagation<C>& state, const std::vector<std::uint32_t>& born) {
  DualPass pass;
  std::vector<std::uint32_t> number(born.size());
  for (std::size_t i = born.size(); i-- > 0;) {
    const auto generator = static_cast<std::uint32_t>(i);
    if (state.relations.is_pivot(generator)) continue;
    number[i] = static_cast<std::uint32_t>(pass.killing.size());
    pass.killing.push_back({born[i], sizes.of_piece(born[i])});
  }
  std::vector<std::uint32_t> final_label(state.pool.count());
  for (std::uint32_t label = 0; label < state.pool.count(); ++label) {
    GeneratorSet set = state.relations.remainder(state.pool.generators(label));
    for (std::uint32_t& generator : set) generator = number[generator];
    std::reverse(set.begin(), set.end());  // the oldest kills last
    final_label[label] = pass.pool.intern(set);
  }
  pass.labels = std::move(state.labels);
  pass.labels.relabel(final_label);
  return pass;
}

/// Whether each generator is in an even number of the labels round the edge.
template <Complex C>
bool sums_to_zero(const C& complex, std::uint32_t edge, const DualPass& pass) {
  std::uint32_t one = 0;
  std::vector<std::uint32_t> generators;  // of all labels but for equal ones that follow each other
  const auto add = [&](std::uint32_t label) {
    const auto set = pass.pool.generators(label);
    generators.insert(generators.end(), set.begin(), set.end());
  };
  for (const std::uint32_t piece : complex.ring(edge)) {
    const std::uint32_t label = pass.labels[piece];
    if (label == 0) continue;
    if (label == one) {
      one = 0;
      continue;
    }
    if (one != 0) add(one);
    one = label;
  }
  if (one == 0 && generators.empty()) return true;
  add(one);
  std::sort(generators.begin(), generators.end());
  for (std::size_t i = 0; i < generators.size(); i += 2)
    if (i + 1 == generators.size() || generators[i] != generators[i + 1]) return false;
  return true;
}

}  // namespace

template <Complex C, PieceSizes S>
DualPass dual_pass(const C& complex, const S& sizes) {
  Propagation<C> state(complex, largest_forest(complex, sizes));
  std::vector<std::uint32_t> born;
  std::vector<std::uint32_t> largest;
  do {
    largest = largest_missing(sizes, complex.piece_bound(), state.known());
    for (const std::uint32_t piece : largest) {
      if (state.known()[piece]) continue;
      const auto generator = static_cast<std::uint32_t>(born.size());
      born.push_back(piece);
      state.assign(piece, state.pool.intern({&generator, 1}));
      state.run();
    }
  } while (!largest.empty());
  return finish(sizes, state, born);
}

template <Complex C>
bool labels_are_consistent(const C& complex, const DualPass& pass) {
  std::atomic<bool> consistent = true;
  pass.labels.for_each_shared([&](std::uint32_t piece, std::uint32_t) {
    for (const std::uint32_t edge : complex.edges_of(piece))
      if (!sums_to_zero(complex, edge, pass)) consistent = false;
  });
  for (std::uint32_t i = 0; i < pass.killing.size(); ++i) {
    const auto own = pass.pool.generators(pass.labels[pass.killing[i].piece]);
    if (own.size() != 1 || own[0] != i) consistent = false;
  }
  return consistent;
}

template DualPass dual_pass(const GridComplex&, const GridSizes&);
template DualPass dual_pass(const GridComplex&, const FlatSizes&);
template DualPass dual_pass(const FlatComplex&, const FlatSizes&);
template DualPass dual_pass(const OctreeComplex&, const OctreeSizes&);
template DualPass dual_pass(const OctreeComplex&, const FlatSizes&);
template bool labels_are_consistent(const GridComplex&, const DualPass&);
template bool labels_are_consistent(const FlatComplex&, const DualPass&);
template bool labels_are_consistent(const OctreeComplex&, const DualPass&);

}  // namespace isoloop
