#include "core/membrane.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/disjoint_sets.h"
#include "core/vertex_cut.h"

namespace isoloop {
namespace {

/// Union-find that knows whether a node and the root of its set differ by an odd class.
class Parities {
 public:
  struct Place {
    std::uint32_t root;
    bool odd;
  };

  std::uint32_t add() {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    odd_.push_back(0);
    return parent_.back();
  }

  Place find(std::uint32_t node) {
    bool odd = false;
    std::uint32_t root = node;
    for (; parent_[root] != root; root = parent_[root]) odd ^= odd_[root] != 0;
    bool rest = odd;
    while (parent_[node] != root && node != root) {  // hang all on the root
      const std::uint32_t next = parent_[node];
      const bool step = odd_[node] != 0;
      parent_[node] = root;
      odd_[node] = static_cast<char>(rest);
      rest ^= step;
      node = next;
    }
    return {root, odd};
  }

  /// Makes the class between a and b `odd`; false if it is the other one.
  bool unite(std::uint32_t a, std::uint32_t b, bool odd) {
    const Place at_a = find(a);
    const Place at_b = find(b);
    const bool between = at_a.odd ^ at_b.odd ^ odd;
    if (at_a.root == at_b.root) return !between;
    const auto [low, high] = std::minmax(at_a.root, at_b.root);
    parent_[high] = low;
    odd_[high] = static_cast<char>(between);
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<char> odd_;
};

}  // namespace

/// One search: its nodes are the vertices and cells that it meets.
struct MembraneFinder::Search {
  struct Incidence {
    std::uint32_t cube;
    std::uint32_t cell;
    bool odd;  // class of the step from the vertex' first cell to this one
  };
  struct Node {
    std::uint32_t number;  // of the vertex or cell
    bool is_vertex;
    bool is_near;
  };
  struct Meeting {  // a vertex of the rest beside a cell of N
    std::uint32_t vertex;
    std::uint32_t cell;
    bool odd;
  };

  Search(MembraneFinder& owner, const MembraneQuery& asked, const MembraneSearch& how)
      : finder(owner), query(asked), search(how) {}
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;
  ~Search() {
    for (const Node& node : nodes) {
      auto& place = node.is_vertex ? finder.node_of_vertex_ : finder.node_of_cell_;
      place[node.number] = none;
    }
  }

  bool is_here(std::uint32_t vertex) const {
    return finder.sides_.is_on(finder.complex_.side(), vertex) && !query.gone[vertex];
  }

  std::uint32_t node_of(std::uint32_t number, bool is_vertex) {
    auto& place = (is_vertex ? finder.node_of_vertex_ : finder.node_of_cell_)[number];
    if (place == none) {
      place = parities.add();
      nodes.push_back({number, is_vertex, false});
    }
    return place;
  }
  bool is_near_vertex(std::uint32_t vertex) const {
    const std::uint32_t node = finder.node_of_vertex_[vertex];
    return node != none && nodes[node].is_near;
  }
  bool is_near_cell(std::uint32_t cell) const {
    const std::uint32_t node = finder.node_of_cell_[cell];
    return node != none && nodes[node].is_near;
  }

  /// The cells round a vertex; they are reached from the first one by toggling axes.
  template <class Visit>
  void for_each_cell(std::uint32_t vertex, const Visit& visit) const {
    const Lattice& lattice = finder.sides_.lattice;
    const GridComplex& complex = finder.complex_;
    const auto& stride = lattice.stride;
    unsigned first = 0;       // axes along which the first cube lies before the vertex
    unsigned can_toggle = 7;  // axes along which there is a cube on either side
    const bool on_border = finder.is_on_border(vertex);
    if (on_border) {
      const auto p = lattice.position(vertex);
      for (unsigned a = 0; a < 3; ++a) {
        if (p[a] + 1 == lattice.dims[a]) first |= 1U << a;
        if (p[a] == 0 || p[a] + 1 == lattice.dims[a]) can_toggle &= ~(1U << a);
      }
    }
    const auto cube_of = [&](unsigned before) {
      std::uint32_t cube = vertex;
      for (unsigned a = 0; a < 3; ++a)
        if ((before >> a & 1U) != 0) cube -= stride[a];
      return cube;
    };
    const auto crosses = [&](unsigned before, unsigned axis) {
      const std::uint32_t corner = cube_of(before & ~(1U << axis));
      return finder.is_odd(complex.piece_at(3 * corner + axis, vertex));
    };
    const bool near_odd = finder.near_odd_[vertex];
    std::array<bool, 8> odd{};
    for (unsigned toggled = 0; toggled < 8; ++toggled) {
      if ((toggled & ~can_toggle) != 0) continue;
      const unsigned before = first ^ toggled;
      if (toggled != 0 && near_odd) {
        unsigned axis = 0;
        while ((toggled >> axis & 1U) == 0) ++axis;
        odd[toggled] = odd[toggled & (toggled - 1)] ^ crosses(before, axis);
      }
      const std::uint32_t cube = cube_of(before);
      visit(Incidence{cube, complex.cell_at(cube, vertex), odd[toggled]});
    }
    if (!on_border) return;
    for (unsigned a = 0; a < 3; ++a)
      if ((can_toggle >> a & 1U) == 0) {
        visit(Incidence{none, complex.cell_bound() - 1, near_odd && crosses(first, a)});
        return;
      }
  }

  /// The corners of the incidence's cell that are still on this side.
  template <class Visit>
  void for_each_corner(const Incidence& at, const Visit& visit) const {
    const Lattice& lattice = finder.sides_.lattice;
    for (unsigned c = 0; c < 8; ++c) {
      std::uint32_t corner = at.cube;
      for (unsigned a = 0; a < 3; ++a) corner += (c >> a & 1U) * lattice.stride[a];
      if (is_here(corner) && finder.complex_.cell_at(at.cube, corner) == at.cell) visit(corner);
    }
  }

  bool collect_near();
  bool may_be_near(std::uint32_t vertex);
  void take(std::uint32_t vertex);
  bool explore_rest();
  bool expand(std::uint32_t vertex, std::vector<std::uint32_t>& next);
  std::vector<std::uint32_t> ends(bool on_this_side) const;
  std::vector<std::vector<std::uint32_t>> islands() const;
  std::optional<std::vector<std::uint32_t>> cut(unsigned turned);
  std::optional<std::vector<std::uint32_t>> best_cut();

  MembraneFinder& finder;
  const MembraneQuery& query;
  const MembraneSearch& search;
  Parities parities;
  std::vector<Node> nodes;
  std::vector<std::uint32_t> near;  // vertices of N, from the loop outwards
  std::vector<Meeting> meetings;
  std::vector<std::uint32_t> parts;  // roots of the rest's parts that meet N from both sides
};

/// The ends of the loop's grid edges on this side, or on the other.
std::vector<std::uint32_t> MembraneFinder::Search::ends(bool on_this_side) const {
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
bool MembraneFinder::Search::may_be_near(std::uint32_t vertex) {
  if (finder.is_on_border(vertex)) return false;
  std::array<std::pair<Parities::Place, bool>, 8> met{};
  std::size_t count = 0;
  bool even = true;
  for_each_cell(vertex, [&](const Incidence& at) {
    const std::uint32_t node = finder.node_of_cell_[at.cell];
    if (node == none) return;
    const Parities::Place place = parities.find(node);
    const bool odd = place.odd ^ at.odd;
    for (std::size_t i = 0; i < count; ++i)
      if (met[i].first.root == place.root && met[i].second != odd) even = false;
    met[count++] = {place, odd};
  });
  return even;
}

void MembraneFinder::Search::take(std::uint32_t vertex) {
  const std::uint32_t node = node_of(vertex, true);
  nodes[node].is_near = true;
  near.push_back(vertex);
  for_each_cell(vertex, [&](const Incidence& at) {
    const std::uint32_t cell = node_of(at.cell, false);
    nodes[cell].is_near = true;
    parities.unite(node, cell, at.odd);
  });
}

/// N, and where it meets the rest; false if there is none.
bool MembraneFinder::Search::collect_near() {
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
bool MembraneFinder::Search::expand(std::uint32_t vertex, std::vector<std::uint32_t>& next) {
  const std::uint32_t node = node_of(vertex, true);
  bool even = true;
  for_each_cell(vertex, [&](const Incidence& at) {
    if (is_near_cell(at.cell)) return;
    const bool is_new = finder.node_of_cell_[at.cell] == none;
    even = parities.unite(node, node_of(at.cell, false), at.odd) && even;
    if (!is_new) return;
    const auto push = [&](std::uint32_t corner) {
      if (finder.node_of_vertex_[corner] != none) return;
      node_of(corner, true);
      next.push_back(corner);
    };
    if (at.cube != none) {
      for_each_corner(at, push);
      return;
    }
    for (std::uint32_t v = 0; v < finder.sides_.lattice.vertex_count(); ++v)
      if (finder.is_on_border(v) && is_here(v)) push(v);
  });
  return even;
}

/// Potentials on the rest, as far as it takes to join all its parts that meet N; false if the rest
/// has an odd walk, or meets N from one side only.
bool MembraneFinder::Search::explore_rest() {
  std::vector<std::uint32_t> front;
  for (const Meeting& meeting : meetings)
    if (finder.node_of_vertex_[meeting.vertex] == none) {
      node_of(meeting.vertex, true);
      front.push_back(meeting.vertex);
    }
  const std::vector<std::uint32_t> start = front;
  std::vector<std::uint32_t> next;
  std::vector<std::uint32_t> roots;
  // Of each part: its root, and whether it meets N from either side.
  const auto sides_met = [&] {
    std::vector<std::pair<std::uint32_t, unsigned>> met;
    for (const Meeting& meeting : meetings) {
      const Parities::Place at = parities.find(finder.node_of_vertex_[meeting.vertex]);
      const Parities::Place cell = parities.find(finder.node_of_cell_[meeting.cell]);
      met.emplace_back(at.root, (at.odd ^ cell.odd ^ meeting.odd) ? 2U : 1U);
    }
    std::sort(met.begin(), met.end());
    std::vector<std::pair<std::uint32_t, unsigned>> merged;
    for (const auto& [root, side] : met) {
      if (merged.empty() || merged.back().first != root) merged.emplace_back(root, 0U);
      merged.back().second |= side;
    }
    return merged;
  };
  while (!front.empty()) {
    next.clear();
    for (const std::uint32_t vertex : front)
      if (!expand(vertex, next)) return false;
    std::swap(front, next);
    roots.clear();
    for (const std::uint32_t vertex : front)
      roots.push_back(parities.find(finder.node_of_vertex_[vertex]).root);
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    const auto met = sides_met();
    const bool both =
        std::any_of(met.begin(), met.end(), [](const auto& part) { return part.second == 3U; });
    if (both && roots.size() <= 1) break;
  }
  for (const auto& [root, sides] : sides_met())
    if (sides == 3U) parts.push_back(root);
  return !parts.empty();
}

/// Connected parts of the other side beside N that do not touch the loop: for each the vertices of
/// N that share a cube with it.
std::vector<std::vector<std::uint32_t>> MembraneFinder::Search::islands() const {
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

/// `turned`: bit i swaps the sides of part i + 1 of the rest.
std::optional<std::vector<std::uint32_t>> MembraneFinder::Search::cut(unsigned turned) {
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
    const Parities::Place at = parities.find(finder.node_of_vertex_[meeting.vertex]);
    const std::uint32_t cell_node = finder.node_of_cell_[meeting.cell];
    const bool second = at.odd ^ parities.find(cell_node).odd ^ meeting.odd ^ search.from_far_side;
    const auto part =
        static_cast<std::size_t>(std::find(parts.begin(), parts.end(), at.root) - parts.begin());
    std::uint32_t behind = second ? CutNetwork::sink : CutNetwork::source;
    if (part == parts.size()) {
      if (number[at.root] == none) number[at.root] = node(none, false);
      behind = number[at.root];
    } else if (part > 0 && (turned >> (part - 1) & 1U) != 0) {
      behind ^= 1U;
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

std::optional<std::vector<std::uint32_t>> MembraneFinder::Search::best_cut() {
  constexpr std::size_t most_turns = 3;
  const std::size_t turns = std::min(parts.size() - 1, most_turns);
  std::optional<std::vector<std::uint32_t>> best;
  for (unsigned turned = 0; turned < 1U << turns; ++turned) {
    auto found = cut(turned);
    if (found && (!best || found->size() < best->size())) best = std::move(found);
  }
  return best;
}

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
