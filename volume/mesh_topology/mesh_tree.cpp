#include "volume/mesh_topology/mesh_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <tbb/parallel_invoke.h>

namespace isoloop {
namespace {

/// Twice the place of the middle of the triangle's box along an axis.
double middle_of(const Mesh& mesh, std::uint32_t triangle, std::size_t axis) {
  const auto& corners = mesh.triangles[triangle];
  const auto [low, high] =
      std::minmax({mesh.points[corners[0]][axis], mesh.points[corners[1]][axis],
                   mesh.points[corners[2]][axis]});
  return low + high;
}

std::size_t longest_axis(const Box& box) {
  std::size_t longest = 0;
  for (std::size_t a = 1; a < 3; ++a) {
    if (box.high[a] - box.low[a] > box.high[longest] - box.low[longest]) longest = a;
  }
  return longest;
}

}  // namespace

MeshTree::MeshTree(const Mesh& mesh, const std::vector<std::uint32_t>& shell_of)
    : nodes_(nodes_for(mesh.triangles.size())), order_(mesh.triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  build(0, 0, order_.size(), mesh, shell_of);
}

std::size_t MeshTree::nodes_for(std::size_t triangles) {
  std::size_t leaves = 1;
  for (std::size_t most = triangles; most > leaf_size; most = (most + 1) / 2) leaves *= 2;
  return 2 * leaves - 1;
}

void MeshTree::build(std::size_t node, std::size_t first, std::size_t last, const Mesh& mesh,
                     const std::vector<std::uint32_t>& shell_of) {
  Node& here = nodes_[node];
  if (last - first <= leaf_size) {
    here.shell = first < last ? shell_of[order_[first]] : mixed;
    for (std::size_t i = first; i < last; ++i) {
      here.box = joined(here.box, box_of(mesh, order_[i]));
      if (shell_of[order_[i]] != here.shell) here.shell = mixed;
    }
    return;
  }
  Box box;
  for (std::size_t i = first; i < last; ++i) box = joined(box, box_of(mesh, order_[i]));
  const std::size_t axis = longest_axis(box);
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(middle_of(mesh, a, axis), a) < std::pair(middle_of(mesh, b, axis), b);
  });
  const auto left = [&] { build(2 * node + 1, first, middle, mesh, shell_of); };
  const auto right = [&] { build(2 * node + 2, middle, last, mesh, shell_of); };
  constexpr std::size_t worth_a_task = 4096;
  if (last - first > worth_a_task) {
    tbb::parallel_invoke(left, right);
  } else {
    left();
    right();
  }
  const Node& low = nodes_[2 * node + 1];
  const Node& high = nodes_[2 * node + 2];
  here.box = box;
  here.shell = low.shell == high.shell ? low.shell : mixed;
}

}  // namespace isoloop
