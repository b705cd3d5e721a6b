// The leaves of an octree over the box with their corners, minimal faces and minimal edges, and how
// these are numbered (docs/octree.md).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/unset_vector.h"
#include "core/cube/voxel_sides.h"
#include "core/octree/leaves.h"
#include "core/octree/ranked_bits.h"

namespace isoloop {

/// Vertices are the corners of leaves, numbered in the order of the lattice. A face of a leaf is
/// minimal if no smaller leaf lies beyond it, an edge if no smaller leaf touches it; where leaves
/// of two heights meet, those of the smaller ones are. With v the number of its lowest corner, a
/// leaf has number v, a minimal face or edge 3 v + axis (see Lattice): each at most once. Leaves
/// that M cuts, their faces and edges are of height 0, those of the lattice.
class Octree {
 public:
  static constexpr std::uint32_t none = 7;  // for a height, where there is nothing
  static constexpr auto no_vertex = static_cast<std::uint32_t>(-1);

  Octree(const VoxelSides& sides, const Leaves& leaves);

  const Lattice& lattice() const { return lattice_; }
  std::uint32_t vertex_count() const { return corners_.count(); }
  std::uint32_t leaf_count() const { return leaf_count_; }

  std::uint32_t lattice_vertex(std::uint32_t vertex) const { return lattice_vertex_[vertex]; }

  /// The vertex at a lattice vertex that is a corner of some leaf.
  std::uint32_t vertex_at(std::uint32_t lattice_vertex) const {
    return corners_.rank(lattice_vertex);
  }

  /// Of what begins at a vertex: 0 to 5, or none.
  std::uint32_t leaf_height(std::uint32_t vertex) const { return words_[vertex] & 7U; }
  std::uint32_t face_height(std::uint32_t vertex, std::uint32_t axis) const {
    return words_[vertex] >> (first_face + 3 * axis) & 7U;
  }
  std::uint32_t edge_height(std::uint32_t vertex, std::uint32_t axis) const {
    return words_[vertex] >> (first_edge + 3 * axis) & 7U;
  }

  bool is_inside(std::uint32_t vertex) const { return (words_[vertex] >> inside & 1U) != 0; }
  bool is_face_cut(std::uint32_t vertex, std::uint32_t axis) const {
    return (words_[vertex] >> (first_cut_face + axis) & 1U) != 0;
  }
  bool is_edge_cut(std::uint32_t vertex, std::uint32_t axis) const {
    return (words_[vertex] >> (first_cut_edge + axis) & 1U) != 0;
  }

  bool is_on_border(std::uint32_t vertex) const { return (words_[vertex] >> border & 1U) != 0; }
  /// Whether the cube that begins there has more than one cell on a side.
  bool has_many_cells(std::uint32_t vertex, Side side) const {
    return (words_[vertex] >> (first_many + static_cast<std::uint32_t>(side)) & 1U) != 0;
  }

  /// Lattice steps along an axis.
  std::uint32_t step(std::uint32_t height, std::uint32_t axis) const {
    return lattice_.stride[axis] << height;
  }

  /// The minimal face of normal `axis` that begins at a lattice vertex and has that height; as
  /// no_vertex where there is none.
  std::uint32_t face_at(std::uint32_t lattice_vertex, std::uint32_t axis,
                        std::uint32_t height) const {
    if (!corners_[lattice_vertex]) return no_vertex;
    const std::uint32_t vertex = vertex_at(lattice_vertex);
    return face_height(vertex, axis) == height ? 3 * vertex + axis : no_vertex;
  }

  /// Calls visit(first vertex, axis, whether it is one minimal edge) for the sides of a minimal
  /// face. A side of two has one height more than they.
  template <class Visit>
  void for_each_side(std::uint32_t vertex, std::uint32_t axis, const Visit& visit) const {
    const std::uint32_t b = (axis + 1) % 3;
    const std::uint32_t c = (axis + 2) % 3;
    const std::uint32_t height = face_height(vertex, axis);
    const auto offer = [&](std::uint32_t first, std::uint32_t along) {
      visit(first, along, edge_height(first, along) == height);
    };
    offer(vertex, b);
    offer(end_of(vertex, b, height), c);
    offer(end_of(vertex, c, height), b);
    offer(vertex, c);
  }

  /// The vertex at the other end of an edge of that height, minimal or a side.
  std::uint32_t end_of(std::uint32_t vertex, std::uint32_t axis, std::uint32_t height) const {
    if (axis == 0 && height == 0) return vertex + 1;
    return vertex_at(lattice_vertex_[vertex] + step(height, axis));
  }

  /// The lattice vertex at a position with some coordinates rounded down to multiples of 2^height.
  std::uint32_t rounded(std::array<std::uint32_t, 3> position, std::uint32_t height,
                        std::array<bool, 3> axes = {true, true, true}) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (axes[a]) position[a] = position[a] >> height << height;
    return lattice_.vertex(position[0], position[1], position[2]);
  }

  /// The leaf that holds the cube with that lowest corner, if its height is `least` or greater.
  std::uint32_t leaf_at(std::uint32_t cube, std::uint32_t least = 0) const;

  /// The leaves before and after a minimal face that does not lie on the border of the box.
  std::array<std::uint32_t, 2> leaves_beside(std::uint32_t vertex, std::uint32_t axis) const {
    const std::uint32_t height = face_height(vertex, axis);
    const std::uint32_t at = lattice_vertex_[vertex];
    const std::uint32_t before = at - step(height, axis);
    std::uint32_t below = no_vertex;
    if (corners_[before]) {
      const std::uint32_t there = vertex_at(before);
      if (leaf_height(there) == height) below = there;
    }
    if (below == no_vertex) below = leaf_at(at - lattice_.stride[axis], height + 1);
    return {below, leaf_height(vertex) != none ? vertex : leaf_at(at, height + 1)};
  }

  /// Bit i: whether lattice vertex `first` + i, one of a row, is a corner; of 64 at most.
  std::uint64_t corner_bits(std::uint32_t first) const { return corners_.bits(first); }

  /// Layers of the largest blocks; the vertices of a layer follow one another.
  std::uint32_t layer_count() const { return static_cast<std::uint32_t>(first_.size() - 1); }
  std::uint32_t first_vertex(std::uint32_t layer) const { return first_[layer]; }
  /// After those of a layer that lie in its lowest plane.
  std::uint32_t end_of_first_plane(std::uint32_t layer) const {
    return corners_.rank(lattice_vertex(first_[layer]) / lattice_.stride[2] * lattice_.stride[2] +
                         lattice_.stride[2]);
  }

 private:
  // Bits of a word: three each for the heights of a leaf, faces and edges.
  static constexpr std::uint32_t first_face = 3;
  static constexpr std::uint32_t first_edge = 12;
  static constexpr std::uint32_t inside = 21;
  static constexpr std::uint32_t first_cut_face = 22;
  static constexpr std::uint32_t first_cut_edge = 25;
  static constexpr std::uint32_t first_many = 28;
  static constexpr std::uint32_t border = 30;

  void number_corners(const Leaves& leaves);
  void offer_heights(const Leaves& leaves);
  void note_sides(const VoxelSides& sides);

  Lattice lattice_;
  RankedBits corners_;                         // by lattice vertex
  UnsetVector<std::uint32_t> lattice_vertex_;  // by vertex
  std::vector<std::uint32_t> words_;           // by vertex: what begins there
  std::vector<std::uint32_t> first_;           // vertices of each layer, and the end
  std::uint32_t leaf_count_ = 0;
};

}  // namespace isoloop
