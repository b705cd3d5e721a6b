// Shortest paths along M by the library: what our own searches are held against.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include "core/surface/edge_graph.h"

namespace isoloop::testing {

/// Lengths of the shortest paths from a vertex; infinite where there is none.
inline std::vector<float> boost_distances(const EdgeGraph& graph, std::uint32_t source) {
  std::vector<float> distances(graph.vertex_count());
  const auto edge_number = get(boost::edge_index, graph.csr);
  boost::dijkstra_shortest_paths(
      graph.csr, source,
      boost::weight_map(boost::make_iterator_property_map(graph.lengths.begin(), edge_number))
          .distance_inf(std::numeric_limits<float>::infinity())
          .distance_map(boost::make_iterator_property_map(distances.begin(),
                                                          get(boost::vertex_index, graph.csr))));
  return distances;
}

}  // namespace isoloop::testing
