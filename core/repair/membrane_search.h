// One search for a membrane: what core/repair/membrane.cpp and core/repair/membrane_search.cpp
// share.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/potentials.h"
#include "core/repair/membrane.h"

namespace isoloop {

/// Whether members differ by even or odd classes.
using ParitySets = Potentials<char, std::bit_xor<>>;

/// Its nodes are the vertices and cells that it meets.
template <HoldsVoxels C>
struct MembraneFinder<C>::Search {
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
  struct Part {
    std::uint32_t root;   // a node
    std::uint32_t group;  // the parts whose sides are known to match
    bool turned;          // its first side is the group's second
  };

  Search(MembraneFinder& owner, const MembraneQuery& asked, const MembraneOptions& how)
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
      place = parity_sets.add();
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
    const C& complex = finder.complex_;
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
      const std::uint32_t corner = lattice.corner(at.cube, c);
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
  bool is_second(const Meeting& meeting);
  std::uint32_t part_at(const Meeting& meeting);
  void group_parts();
  std::optional<std::vector<std::uint32_t>> cut(unsigned turned, bool from_far_side);
  std::optional<std::vector<std::uint32_t>> best_cut(bool from_far_side);

  MembraneFinder& finder;
  const MembraneQuery& query;
  const MembraneOptions& search;
  ParitySets parity_sets;
  std::vector<Node> nodes;
  std::vector<std::uint32_t> near;  // vertices of N, from the loop outwards
  std::vector<Meeting> meetings;
  std::vector<Part> parts;            // of the rest, that meet N from both sides; by root
  std::vector<std::uint32_t> groups;  // of parts, the largest first
};

}  // namespace isoloop
