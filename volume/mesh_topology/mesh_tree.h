// The triangles of a mesh by place: a balanced tree of boxes.
#pragma once

#include <cstdint>
#include <vector>

#include "volume/mesh/mesh.h"
#include "volume/mesh/mesh_box.h"

namespace isoloop {

/// Halved along the longest side of each box, again and again. The tree is the same for any number
/// of threads.
class MeshTree {
 public:
  static constexpr std::uint32_t mixed = 0xffffffff;

  /// `shell_of`: a number for each triangle.
  MeshTree(const Mesh& mesh, const std::vector<std::uint32_t>& shell_of);

  /// Calls visit(triangle) for the triangles of all leaves that `enters(box, shell)` leads to; a
  /// box is entered only if those round it are. `shell`: of all triangles in the box, or mixed.
  template <class Enters, class Visit>
  void walk(const Enters& enters, const Visit& visit) const {
    walk(0, 0, order_.size(), enters, visit);
  }

 private:
  static constexpr std::size_t leaf_size = 4;  // triangles at most

  struct Node {
    Box box{};
    std::uint32_t shell = mixed;
  };

  static std::size_t nodes_for(std::size_t triangles);
  void build(std::size_t node, std::size_t first, std::size_t last, const Mesh& mesh,
             const std::vector<std::uint32_t>& shell_of);

  template <class Enters, class Visit>
  void walk(std::size_t node, std::size_t first, std::size_t last, const Enters& enters,
            const Visit& visit) const {
    if (!enters(nodes_[node].box, nodes_[node].shell)) return;
    if (last - first <= leaf_size) {
      for (std::size_t i = first; i < last; ++i) visit(order_[i]);
      return;
    }
    const std::size_t middle = first + (last - first) / 2;
    walk(2 * node + 1, first, middle, enters, visit);
    walk(2 * node + 2, middle, last, enters, visit);
  }

  std::vector<Node> nodes_;           // the halves of node n are 2 n + 1 and 2 n + 2
  std::vector<std::uint32_t> order_;  // triangles; a node has a range of them
};

/// Most bytes of a tree, for each triangle.
inline constexpr std::uint64_t tree_bytes_per_triangle = 64;

}  // namespace isoloop
