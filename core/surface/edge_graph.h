// M's edge graph: a Boost.Graph CSR graph with the length of each edge beside it.
#pragma once

#include <cstdint>
#include <vector>

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/pending/disjoint_sets.hpp>  // before the CSR header: that one lacks it
#include <boost/range/iterator_range.hpp>

namespace isoloop {

/// Directed; every edge is there in both directions. Vertices are those of M. An edge's number
/// (get(boost::edge_index, csr, edge)) indexes arrays that hold data per directed edge.
struct EdgeGraph {
  using Csr =
      boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                         boost::no_property, std::uint32_t, std::uint32_t>;
  Csr csr;
  std::vector<float> lengths;  // by edge number; unit of the spacing

  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(num_vertices(csr)); }

  /// Calls visit(target, edge number) for each edge that leaves `vertex`.
  template <class Visit>
  void for_each_out_edge(std::uint32_t vertex, const Visit& visit) const {
    for (const auto& edge : boost::make_iterator_range(out_edges(vertex, csr)))
      visit(target(edge, csr), get(boost::edge_index, csr, edge));
  }
};

inline constexpr auto no_edge = static_cast<std::uint32_t>(-1);

/// The number of the directed edge, or no_edge.
inline std::uint32_t edge_between(const EdgeGraph& graph, std::uint32_t from, std::uint32_t to) {
  std::uint32_t found = no_edge;
  graph.for_each_out_edge(from, [&](std::uint32_t target, std::uint32_t edge) {
    if (target == to) found = edge;
  });
  return found;
}

}  // namespace isoloop
