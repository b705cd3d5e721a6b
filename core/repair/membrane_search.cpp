#include "core/repair/membrane_search.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <tuple>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/complex/grid_complex.h"
#include "core/repair/vertex_cut.h"

namespace isoloop {
namespace {

/// Vertices and cells of the rest that are seen: so many, and so many for each vertex of N.
constexpr std::size_t far_enough = 20'000;
constexpr std::size_t times_near = 50;

constexpr std::size_t most_turns = 3;  // groups of parts that are tried either way round

}  // namespace

/// The ends of the loop's grid edges on this side, or on the other.
template <HoldsVoxels C>
std::vector<std::uint32_t> MembraneFinder<C>::Search::ends(bool on_this_side) const {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t edge : query.edges) {
    const std::uint32_t low = edge / 3;
    const std::uint32_t high = low + finder.sides_.lattice.stride[edge % 3];
    const bool low_here = finder.sides_.is_on(finder.complex_.side(), low);
    vertices.push_back(low_here == on_this_side ? low : high);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Whether all walks through `vertex` within N would stay even.
template <HoldsVoxels C>
bool MembraneFinder<C>::Search::may_be_near(std::uint32_t vertex) {
  if (finder.is_on_border(vertex)) return false;
  std::array<std::pair<ParitySets::Place, bool>, 8> met{};
  std::size_t count = 0;
  bool even = true;
  for_each_cell(vertex, [&](const Incidence& at) {
    const std::uint32_t node = finder.node_of_cell_[at.cell];
    if (node == none) return;
    const ParitySets::Place place = parity_sets.find(node);
    const bool odd = (place.value ^ char{at.odd}) != 0;
    for (std::size_t i = 0; i < count; ++i)
      if (met[i].first.root == place.root && met[i].second != odd) even = false;
    met[count++] = {place, odd};
  });
  return even;
}

template <HoldsVoxels C>
void MembraneFinder<C>::Search::take(std::uint32_t vertex) {
  const std::uint32_t node = node_of(vertex, true);
  nodes[node].is_near = true;
  near.push_back(vertex);
  for_each_cell(vertex, [&](const Incidence& at) {
    const std::uint32_t cell = node_of(at.cell, false);
    nodes[cell].is_near = true;
    parity_sets.join(node, cell, char{at.odd});
  });
}

/// N, and where it meets the rest; false if there is none.
template <HoldsVoxels C>
bool MembraneFinder<C>::Search::collect_near() {
  std::vector<std::uint32_t> front;
  std::vector<std::uint32_t> next;
  std::vector<std::uint32_t> left_out;
  std::vector<std::uint32_t>& seen = finder.seen_;
  const std::uint32_t round = ++finder.rounds_;
  for (const std::uint32_t vertex : ends(true))
    if (is_here(vertex)) {
      seen[vertex] = round;
      front.push_back(vertex);
    }
  for (std::uint32_t step = 0; step <= search.reach && !front.empty(); ++step) {
    next.clear();
    for (const std::uint32_t vertex : front) {
      if (!may_be_near(vertex)) {
        left_out.push_back(vertex);
        continue;
      }
      take(vertex);
      for_each_cell(vertex, [&](const Incidence& at) {
        for_each_corner(at, [&](std::uint32_t corner) {
          if (seen[corner] == round) return;
          seen[corner] = round;
          next.push_back(corner);
        });
      });
    }
    std::swap(front, next);
  }
  left_out.insert(left_out.end(), front.begin(), front.end());
  for (const std::uint32_t vertex : left_out)
    for_each_cell(vertex, [&](const Incidence& at) {
      if (is_near_cell(at.cell)) meetings.push_back({vertex, at.cell, at.odd});
    });
  return !near.empty() && !meetings.empty();
}

/// Joins `vertex` to the cells of the rest round it; false if that closes an odd walk.
template <HoldsVoxels C>
bool MembraneFinder<C>::Search::expand(std::uint32_t vertex, std::vector<std::uint32_t>& next) {
  const std::uint32_t node = node_of(vertex, true);
  bool even = true;
  for_each_cell(vertex, [&](const Incidence& at) {
    if (is_near_cell(at.cell)) return;
    const bool is_new = finder.node_of_cell_[at.cell] == none;
    even = parity_sets.join(node, node_of(at.cell, false), char{at.odd}) == 0 && even;
    if (!is_new) return;
    const auto push = [&](std::uint32_t corner) {
      if (finder.node_of_vertex_[corner] != none) return;
      node_of(corner, true);
      next.push_back(corner);
    };
    // What goes on beyond the box is not followed there: whatever else comes to it joins its cell.
    if (at.cube != none) for_each_corner(at, push);
  });
  return even;
}

/// Potentials on the rest, as far as it takes to join all its parts that meet N, or as far as
/// asked; false if that has an odd walk, or meets N from one side only.
template <HoldsVoxels C>
bool MembraneFinder<C>::Search::explore_rest() {
  std::vector<std::uint32_t> front;
  for (const Meeting& meeting : meetings)
    if (finder.node_of_vertex_[meeting.vertex] == none) {
      node_of(meeting.vertex, true);
      front.push_back(meeting.vertex);
    }
  std::vector<std::uint32_t> next;
  std::vector<std::uint32_t> going_on;  // vertices that led to those of the front
  std::vector<std::uint32_t> roots;
  // Of each part: its root, and whether it meets N from either side.
  const auto sides_met = [&] {
    std::vector<std::pair<std::uint32_t, unsigned>> met;
    for (const Meeting& meeting : meetings) {
      const ParitySets::Place at = parity_sets.find(finder.node_of_vertex_[meeting.vertex]);
      met.emplace_back(at.root, is_second(meeting) ? 2U : 1U);
    }
    std::sort(met.begin(), met.end());
    std::vector<std::pair<std::uint32_t, unsigned>> merged;
    for (const auto& [root, side] : met) {
      if (merged.empty() || merged.back().first != root) merged.emplace_back(root, 0U);
      merged.back().second |= side;
    }
    return merged;
  };
  const std::size_t most = far_enough + times_near * near.size();
  while (!front.empty()) {
    next.clear();
    going_on.clear();
    for (const std::uint32_t vertex : front) {
      const std::size_t before = next.size();
      if (!expand(vertex, next)) return false;
      if (next.size() > before) going_on.push_back(vertex);
    }
    std::swap(front, next);
    // A vertex of the front is not joined to the cell that led to it before it is expanded.
    roots.clear();
    for (const std::uint32_t vertex : going_on)
      roots.push_back(parity_sets.find(finder.node_of_vertex_[vertex]).root);
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    const auto met = sides_met();
    const bool both =
        std::any_of(met.begin(), met.end(), [](const auto& part) { return part.second == 3U; });
    if ((both && roots.size() <= 1) || (search.is_near && nodes.size() > most)) break;
  }
  for (const auto& [root, sides] : sides_met())
    if (sides == 3U) parts.push_back({root, 0, false});
  return !parts.empty();
}

/// On which of the two sides of its part of the rest the cell lies.
template <HoldsVoxels C>
bool MembraneFinder<C>::Search::is_second(const Meeting& meeting) {
  return (parity_sets.find(finder.node_of_vertex_[meeting.vertex]).value ^
          parity_sets.find(finder.node_of_cell_[meeting.cell]).value ^ char{meeting.odd}) != 0;
}

/// Its place in `parts`, or their count if it meets N from one side only.
template <HoldsVoxels C>
std::uint32_t MembraneFinder<C>::Search::part_at(const Meeting& meeting) {
  const std::uint32_t root = parity_sets.find(finder.node_of_vertex_[meeting.vertex]).root;
  const auto at =
      std::lower_bound(parts.begin(), parts.end(), root,
                       [](const Part& part, std::uint32_t wanted) { return part.root < wanted; });
  return static_cast<std::uint32_t>((at != parts.end() && at->root == root ? at : parts.end()) -
                                    parts.begin());
}

/// Which of its two sides of the membrane a part calls the first is its own choice. Where N comes
/// round to itself hundreds of vertices are parts of their own, all along one seam. Two parts
/// beside one cell match if the cell is on the first side of both; those that share most cells are
/// matched first.
template <HoldsVoxels C>
void MembraneFinder<C>::Search::group_parts() {
  struct Sight {  // of a cell from a part
    std::uint32_t cell;
    std::uint32_t part;
    bool second;
  };
  std::vector<Sight> sights;
  for (const Meeting& meeting : meetings) {
    const std::uint32_t part = part_at(meeting);
    if (part < parts.size()) sights.push_back({meeting.cell, part, is_second(meeting)});
  }
  std::sort(sights.begin(), sights.end(), [](const Sight& a, const Sight& b) {
    return std::tie(a.cell, a.part, a.second) < std::tie(b.cell, b.part, b.second);
  });
  std::map<std::array<std::uint32_t, 2>, int> matches;  // cells seen alike less those that are not
  for (std::size_t i = 0; i < sights.size(); ++i)
    for (std::size_t j = i + 1; j < sights.size() && sights[j].cell == sights[i].cell; ++j)
      if (sights[i].part != sights[j].part)
        matches[{sights[i].part, sights[j].part}] += sights[i].second == sights[j].second ? 1 : -1;
  std::vector<std::pair<std::array<std::uint32_t, 2>, int>> order(matches.begin(), matches.end());
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return std::abs(a.second) > std::abs(b.second);
  });
  ParitySets matched;
  for (std::size_t part = 0; part < parts.size(); ++part) matched.add();
  for (const auto& [pair, weight] : order)
    if (weight != 0) matched.join(pair[0], pair[1], char{weight < 0});
  std::map<std::uint32_t, std::size_t> sizes;  // by group: sights
  for (std::uint32_t part = 0; part < parts.size(); ++part) {
    const ParitySets::Place at = matched.find(part);
    parts[part].group = at.root;
    parts[part].turned = at.value != 0;
  }
  for (const Sight& sight : sights) ++sizes[parts[sight.part].group];
  groups.clear();
  for (const auto& [group, size] : sizes) groups.push_back(group);
  std::stable_sort(groups.begin(), groups.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return sizes[a] > sizes[b]; });
}

/// Connected parts of the other side beside N that do not touch the loop: for each the vertices of
/// N that share a cube with it.
template <HoldsVoxels C>
std::vector<std::vector<std::uint32_t>> MembraneFinder<C>::Search::islands() const {
  const Lattice& lattice = finder.sides_.lattice;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> beside;  // other side's vertex, of N
  for (const std::uint32_t vertex : near) {
    const auto p = lattice.position(vertex);
    for (unsigned n = 0; n < 27; ++n) {
      const std::uint32_t neighbor =
          lattice.vertex(p[0] + n % 3 - 1, p[1] + n / 3 % 3 - 1, p[2] + n / 9 - 1);
      if (!is_here(neighbor)) beside.emplace_back(neighbor, vertex);
    }
  }
  std::sort(beside.begin(), beside.end());
  std::vector<std::uint32_t> there;
  for (const auto& [other, vertex] : beside)
    if (there.empty() || there.back() != other) there.push_back(other);
  const auto place = [&](std::uint32_t other) {
    const auto at = std::lower_bound(there.begin(), there.end(), other);
    return at != there.end() && *at == other ? static_cast<std::uint32_t>(at - there.begin())
                                             : static_cast<std::uint32_t>(there.size());
  };
  const auto count = static_cast<std::uint32_t>(there.size());
  DisjointSets joined(count + 1);
  for (std::uint32_t i = 0; i < count; ++i)
    for (const std::uint32_t stride : lattice.stride) {
      const std::uint32_t j = place(there[i] + stride);
      if (j < count) joined.unite(i, j);
    }
  std::vector<bool> touched(count + 1);
  for (const std::uint32_t vertex : ends(false)) touched[joined.find(place(vertex))] = true;
  std::vector<std::vector<std::uint32_t>> all(count);
  for (const auto& [other, vertex] : beside) {
    const std::uint32_t root = joined.find(place(other));
    if (!touched[root]) all[root].push_back(vertex);
  }
  std::erase_if(all, [](const auto& island) { return island.empty(); });
  return all;
}

/// `turned`: bit i swaps the sides of group i + 1 of the rest's parts.
template <HoldsVoxels C>
std::optional<std::vector<std::uint32_t>> MembraneFinder<C>::Search::cut(unsigned turned,
                                                                         bool from_far_side) {
  CutNetwork network;
  std::vector<std::uint32_t> vertex_of(2, none);  // by node of the network
  std::vector<std::uint32_t> number(nodes.size(), none);
  std::vector<bool> keep(nodes.size());
  const auto node = [&](std::uint32_t vertex, bool cuttable) {
    vertex_of.push_back(vertex);
    return network.add_node(cuttable);
  };
  std::vector<std::vector<std::uint32_t>> clear;
  if (search.clear_islands) clear = islands();
  for (const auto& island : clear)
    for (const std::uint32_t vertex : island) keep[finder.node_of_vertex_[vertex]] = true;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (nodes[n].is_near && !nodes[n].is_vertex) number[n] = node(none, false);
  for (const std::uint32_t vertex : near) {
    const std::uint32_t at = finder.node_of_vertex_[vertex];
    number[at] = node(vertex, !keep[at] && !query.fixed[vertex]);
    for_each_cell(vertex, [&](const Incidence& incidence) {
      network.join(number[at], number[finder.node_of_cell_[incidence.cell]]);
    });
  }
  for (const auto& island : clear) {
    const std::uint32_t at = node(none, false);
    for (const std::uint32_t vertex : island)
      network.join(at, number[finder.node_of_vertex_[vertex]]);
  }
  // A vertex of the rest stands on one side of the membrane, or, where N comes round to it from
  // both, on each.
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> copies;  // vertex and what is behind it
  for (const Meeting& meeting : meetings) {
    const std::uint32_t cell_node = finder.node_of_cell_[meeting.cell];
    const std::uint32_t part = part_at(meeting);
    std::uint32_t behind = CutNetwork::source;
    if (part == parts.size()) {
      std::uint32_t& place = number[parity_sets.find(finder.node_of_vertex_[meeting.vertex]).root];
      if (place == none) place = node(none, false);
      behind = place;
    } else {
      const auto group = std::find(groups.begin(), groups.end(), parts[part].group);
      const auto rank = static_cast<std::size_t>(group - groups.begin());
      const bool is_turned = rank > 0 && rank <= most_turns && (turned >> (rank - 1) & 1U) != 0;
      if (is_second(meeting) ^ parts[part].turned ^ is_turned ^ from_far_side)
        behind = CutNetwork::sink;
    }
    const auto [copy, is_new] = copies.try_emplace({meeting.vertex, behind}, none);
    if (is_new) {
      copy->second = node(meeting.vertex,
                          !query.fixed[meeting.vertex] && !finder.is_on_border(meeting.vertex));
      network.join(behind, copy->second);
    }
    network.join(copy->second, number[cell_node]);
  }
  auto found = network.least_cut();
  if (!found || found->empty()) return std::nullopt;
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t n : *found) vertices.push_back(vertex_of[n]);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

template <HoldsVoxels C>
std::optional<std::vector<std::uint32_t>> MembraneFinder<C>::Search::best_cut(bool from_far_side) {
  const std::size_t turns = std::min(groups.size() - 1, most_turns);
  std::optional<std::vector<std::uint32_t>> best;
  for (unsigned turned = 0; turned < 1U << turns; ++turned) {
    auto found = cut(turned, from_far_side);
    if (found && (!best || found->size() < best->size())) best = std::move(found);
  }
  return best;
}

template struct MembraneFinder<GridComplex>::Search;

}  // namespace isoloop
