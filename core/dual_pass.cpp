#include "core/dual_pass.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <tbb/parallel_for.h>

#include "core/order.h"
#include "core/spanning_forest.h"

namespace isoloop {
namespace {

/// Generators that a relation has expressed by older ones. Generators are numbered in order of
/// birth, so the youngest of a set is its greatest.
class Elimination {
 public:
  GeneratorSet reduce(std::span<const std::uint32_t> set) const {
    GeneratorSet reduced(set.begin(), set.end());
    for (std::size_t i = reduced.size(); i-- > 0;) {
      if (reduced[i] >= expressed_by_.size() || !expressed_by_[reduced[i]]) continue;
      // The substitute holds older generators only: what lies above position i stays as it is.
      const std::uint32_t youngest = reduced[i];
      GeneratorSet substitute = *expressed_by_[youngest];
      substitute.push_back(youngest);
      reduced = sum_of(reduced, substitute);
      i = static_cast<std::size_t>(std::lower_bound(reduced.begin(), reduced.end(), youngest) -
                                   reduced.begin());
    }
    return reduced;
  }

  /// Imposes sum = 0.
  void relate(std::span<const std::uint32_t> sum) {
    GeneratorSet relation = reduce(sum);
    if (relation.empty()) return;
    const std::uint32_t youngest = relation.back();
    relation.pop_back();
    if (expressed_by_.size() <= youngest) expressed_by_.resize(youngest + 1);
    expressed_by_[youngest] = std::move(relation);
  }

  bool is_eliminated(std::uint32_t generator) const {
    return generator < expressed_by_.size() && expressed_by_[generator].has_value();
  }

 private:
  std::vector<std::optional<GeneratorSet>> expressed_by_;
};

/// Labels pieces; whenever all but one piece of a ring are labelled, the last one follows.
template <Complex C>
class Propagation {
 public:
  explicit Propagation(const C& complex)
      : labels(complex.piece_bound()),
        complex_(complex),
        is_known_(complex.piece_bound()),
        open_(complex.edge_bound()) {
    tbb::parallel_for(std::uint32_t{0}, complex.layer_count(), [&](std::uint32_t layer) {
      complex.for_each_edge(layer, [&](std::uint32_t edge) {
        open_[edge] = static_cast<std::uint8_t>(complex.ring(edge).count);
      });
    });
  }

  bool is_known(std::uint32_t piece) const { return is_known_[piece]; }

  void assign(std::uint32_t piece, std::uint32_t label) {
    is_known_.insert(piece);
    if (label != 0) labels.set(piece, label);
    // While all labels are 0, a ring that closes says nothing.
    const std::uint8_t least = pool.count() == 1 ? 1 : 0;
    for (const std::uint32_t edge : complex_.edges_of(piece)) {
      const std::uint8_t open = --open_[edge];
      if (open <= 1 && open >= least) todo_.push_back(edge);
    }
  }

  /// Draws every conclusion from the labels so far. Rings that close with a sum other than 0 are
  /// relations between the generators.
  void run() {
    while (!todo_.empty()) {
      const std::uint32_t edge = todo_.back();
      todo_.pop_back();
      std::uint32_t sum = 0;
      std::optional<std::uint32_t> last;
      for (const std::uint32_t piece : complex_.ring(edge)) {
        if (is_known(piece))
          sum = pool.sum(sum, labels[piece]);
        else
          last = piece;
      }
      if (last)
        assign(*last, sum);
      else if (sum != 0)
        elimination.relate(pool.generators(sum));
    }
  }

  LabelPool pool;
  SparseLabels labels;
  Elimination elimination;

 private:
  const C& complex_;
  BitSet is_known_;
  std::vector<std::uint8_t> open_;  // by edge: pieces of its ring without a label
  std::vector<std::uint32_t> todo_;
};

/// Replaces eliminated generators in all labels and renumbers the rest in order of killing.
template <Complex C>
DualPass finish(const C& complex, Propagation<C>& state, const std::vector<std::uint32_t>& born) {
  DualPass pass;
  std::vector<std::uint32_t> number(born.size());
  for (std::size_t i = born.size(); i-- > 0;) {
    const auto generator = static_cast<std::uint32_t>(i);
    if (state.elimination.is_eliminated(generator)) continue;
    number[i] = static_cast<std::uint32_t>(pass.killing.size());
    pass.killing.push_back({born[i], complex.size(born[i])});
  }
  std::vector<std::uint32_t> final_label(state.pool.count());
  for (std::uint32_t label = 0; label < state.pool.count(); ++label) {
    GeneratorSet set = state.elimination.reduce(state.pool.generators(label));
    for (std::uint32_t& generator : set) generator = number[generator];
    std::reverse(set.begin(), set.end());  // the oldest kills last
    final_label[label] = pass.pool.intern(set);
  }
  pass.labels = std::move(state.labels);
  pass.labels.relabel(final_label);
  return pass;
}

/// Calls visit(piece) for every piece without a label, ascending. Pieces may get theirs meanwhile.
template <Complex C, class Visit>
void for_each_unknown(const C& complex, const Propagation<C>& state, const Visit& visit) {
  for (std::uint32_t layer = 0; layer < complex.layer_count(); ++layer)
    complex.for_each_piece(layer, [&](std::uint32_t piece) {
      if (!state.is_known(piece)) visit(piece);
    });
}

template <Complex C>
DualPass run_dual_pass(const C& complex) {
  const BitSet forest = largest_forest(complex);
  Propagation<C> state(complex);
  for_each_unknown(complex, state, [&](std::uint32_t piece) {
    if (!forest[piece]) return;
    state.assign(piece, 0);
    state.run();
  });
  std::vector<std::uint32_t> rest;
  for_each_unknown(complex, state, [&](std::uint32_t piece) { rest.push_back(piece); });
  sort_from_largest(complex, rest);
  std::vector<std::uint32_t> born;
  for (const std::uint32_t piece : rest) {
    if (state.is_known(piece)) continue;
    const auto generator = static_cast<std::uint32_t>(born.size());
    born.push_back(piece);
    state.assign(piece, state.pool.intern({&generator, 1}));
    state.run();
  }
  return finish(complex, state, born);
}

}  // namespace

DualPass dual_pass(const GridComplex& complex) { return run_dual_pass(complex); }

bool labels_are_consistent(const GridComplex& complex, const DualPass& pass) {
  LabelPool pool = pass.pool;
  bool consistent = true;
  pass.labels.for_each([&](std::uint32_t piece, std::uint32_t) {
    for (const std::uint32_t edge : complex.edges_of(piece)) {
      std::uint32_t sum = 0;
      for (const std::uint32_t neighbor : complex.ring(edge))
        sum = pool.sum(sum, pass.labels[neighbor]);
      consistent = consistent && sum == 0;
    }
  });
  for (std::uint32_t i = 0; i < pass.killing.size(); ++i) {
    const auto own = pool.generators(pass.labels[pass.killing[i].piece]);
    consistent = consistent && own.size() == 1 && own[0] == i;
  }
  return consistent;
}

}  // namespace isoloop
