#include "core/membrane.h"

#include <algorithm>

#include "core/membrane_search.h"

namespace isoloop {

MembraneFinder::MembraneFinder(const Sides& sides, const GridComplex& complex, const DualPass& pass)
    : sides_(sides),
      complex_(complex),
      pass_(pass),
      near_odd_(sides.lattice.vertex_count()),
      seen_(sides.lattice.vertex_count()),
      node_of_vertex_(sides.lattice.vertex_count(), none),
      node_of_cell_(complex.cell_bound(), none) {}

void MembraneFinder::mark_odd_pieces(std::span<const std::uint32_t> crossing) {
  const GeneratorSet asked(crossing.begin(), crossing.end());
  if (asked == crossing_) return;
  crossing_ = asked;
  for (const std::uint32_t vertex : odd_corners_) near_odd_[vertex] = false;
  odd_corners_.clear();
  odd_label_.assign(pass_.pool.count(), 0);
  for (std::uint32_t label = 0; label < pass_.pool.count(); ++label)
    for (const std::uint32_t generator : pass_.pool.generators(label))
      if (std::find(crossing.begin(), crossing.end(), generator) != crossing.end())
        odd_label_[label] ^= 1;
  pass_.labels.for_each([&](std::uint32_t piece, std::uint32_t label) {
    if (odd_label_[label] == 0) return;
    for (const std::uint32_t corner : complex_.corners(piece)) {
      if (near_odd_[corner]) continue;
      near_odd_[corner] = true;
      odd_corners_.push_back(corner);
    }
  });
  std::sort(odd_corners_.begin(), odd_corners_.end());
}

std::optional<std::vector<std::uint32_t>> MembraneFinder::thin(const MembraneQuery& query,
                                                               const MembraneSearch& search) {
  mark_odd_pieces(query.crossing);
  Search state(*this, query, search);
  if (!state.collect_near() || !state.explore_rest()) return std::nullopt;
  return state.best_cut();
}

std::vector<std::uint32_t> MembraneFinder::spanned(const MembraneQuery& query) {
  mark_odd_pieces(query.crossing);
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t vertex : odd_corners_)
    if (!query.gone[vertex] && !query.fixed[vertex]) vertices.push_back(vertex);
  return vertices;
}

}  // namespace isoloop
