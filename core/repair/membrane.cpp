#include "core/repair/membrane.h"

#include <algorithm>

#include "core/complex/grid_complex.h"
#include "core/repair/membrane_search.h"

namespace isoloop {
namespace {

CompressedRows labels_by_generator(const DualPass& pass) {
  return collected_rows(static_cast<std::uint32_t>(pass.killing.size()), [&](const auto& visit) {
    for (std::uint32_t label = 0; label < pass.pool.count(); ++label)
      for (const std::uint32_t generator : pass.pool.generators(label)) visit(generator, label);
  });
}

CompressedRows pieces_by_label(const DualPass& pass) {
  return collected_rows(pass.pool.count(), [&](const auto& visit) {
    pass.labels.for_each([&](std::uint32_t piece, std::uint32_t label) { visit(label, piece); });
  });
}

}  // namespace

template <HoldsVoxels C>
MembraneFinder<C>::MembraneFinder(const VoxelSides& sides, const C& complex, const DualPass& pass)
    : sides_(sides),
      complex_(complex),
      pass_(pass),
      labels_with_(labels_by_generator(pass)),
      pieces_with_(pieces_by_label(pass)),
      is_odd_label_(pass.pool.count()),
      near_odd_(sides.lattice.vertex_count()),
      seen_(sides.lattice.vertex_count()),
      node_of_vertex_(sides.lattice.vertex_count(), none),
      node_of_cell_(complex.cell_bound(), none) {}

template <HoldsVoxels C>
void MembraneFinder<C>::mark_odd_pieces(std::span<const std::uint32_t> crossing) {
  const GeneratorSet asked(crossing.begin(), crossing.end());
  if (asked == crossing_) return;
  crossing_ = asked;
  for (const std::uint32_t vertex : odd_corners_) near_odd_[vertex] = false;
  odd_corners_.clear();
  for (const std::uint32_t label : odd_labels_) is_odd_label_[label] = false;
  odd_labels_.clear();
  for (const std::uint32_t generator : crossing)
    for (const std::uint32_t label : labels_with_[generator]) {
      is_odd_label_[label] = !is_odd_label_[label];
      odd_labels_.push_back(label);
    }
  std::sort(odd_labels_.begin(), odd_labels_.end());
  odd_labels_.erase(std::unique(odd_labels_.begin(), odd_labels_.end()), odd_labels_.end());
  std::erase_if(odd_labels_, [&](std::uint32_t label) { return !is_odd_label_[label]; });
  for (const std::uint32_t label : odd_labels_)
    for (const std::uint32_t piece : pieces_with_[label])
      for (const std::uint32_t corner : complex_.corners(piece)) {
        if (near_odd_[corner]) continue;
        near_odd_[corner] = true;
        odd_corners_.push_back(corner);
      }
  std::sort(odd_corners_.begin(), odd_corners_.end());
}

template <HoldsVoxels C>
std::optional<bool> MembraneFinder<C>::thin(
    const MembraneQuery& query, const MembraneOptions& search,
    const std::function<bool(const std::vector<std::uint32_t>&)>& use) {
  mark_odd_pieces(query.crossing);
  Search state(*this, query, search);
  if (!state.collect_near() || !state.explore_rest()) return std::nullopt;
  state.group_parts();
  for (const bool from_far_side : {false, true}) {
    const auto set = state.best_cut(from_far_side);
    if (set && use(*set)) return true;
  }
  return false;
}

/// What `start` reaches without meeting vertices seen in round `first_round`; empty if that is more
/// than `most` vertices, leads out of the box, or meets what a round since then did not finish.
template <HoldsVoxels C>
std::vector<std::uint32_t> MembraneFinder<C>::part_beside(const MembraneQuery& query,
                                                          std::uint32_t start,
                                                          std::uint32_t first_round,
                                                          std::size_t most) {
  const MembraneOptions anywhere{};
  const Search side(*this, query, anywhere);
  const std::uint32_t round = ++rounds_;
  std::vector<std::uint32_t> part{start};
  seen_[start] = round;
  bool is_whole = true;
  for (std::size_t i = 0; i < part.size() && is_whole; ++i)
    side.for_each_cell(part[i], [&](const typename Search::Incidence& at) {
      if (at.cube == none) {
        is_whole = false;
        return;
      }
      side.for_each_corner(at, [&](std::uint32_t corner) {
        if (seen_[corner] > first_round && seen_[corner] < round) is_whole = false;
        if (seen_[corner] >= first_round) return;
        seen_[corner] = round;
        part.push_back(corner);
        is_whole = is_whole && part.size() <= most;
      });
    });
  if (!is_whole) part.clear();
  return part;
}

template <HoldsVoxels C>
std::vector<std::uint32_t> MembraneFinder<C>::with_severed(const MembraneQuery& query,
                                                           const std::vector<std::uint32_t>& set,
                                                           std::size_t most) {
  const std::uint32_t first_round = ++rounds_;
  for (const std::uint32_t vertex : set) seen_[vertex] = first_round;
  const MembraneOptions anywhere{};
  const Search side(*this, query, anywhere);
  std::vector<std::vector<std::uint32_t>> parts;
  bool has_larger = false;
  for (const std::uint32_t vertex : set)
    side.for_each_cell(vertex, [&](const typename Search::Incidence& at) {
      if (at.cube == none) return;
      side.for_each_corner(at, [&](std::uint32_t corner) {
        if (seen_[corner] >= first_round) return;
        parts.push_back(part_beside(query, corner, first_round, most));
        has_larger = has_larger || parts.back().empty();
      });
    });
  const auto smaller = [](const auto& a, const auto& b) { return a.size() < b.size(); };
  if (!has_larger && !parts.empty())
    parts.erase(std::max_element(parts.begin(), parts.end(), smaller));
  std::vector<std::uint32_t> all = set;
  for (const auto& part : parts)
    if (std::none_of(part.begin(), part.end(), [&](auto vertex) { return query.fixed[vertex]; }))
      all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end());
  return all;
}

template <HoldsVoxels C>
std::vector<std::uint32_t> MembraneFinder<C>::spanned(const MembraneQuery& query) {
  mark_odd_pieces(query.crossing);
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t vertex : odd_corners_)
    if (!query.gone[vertex] && !query.fixed[vertex]) vertices.push_back(vertex);
  return vertices;
}

template class MembraneFinder<GridComplex>;

}  // namespace isoloop
