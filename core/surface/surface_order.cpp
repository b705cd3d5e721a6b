#include "core/surface/surface_order.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/errors.h"

namespace isoloop {
namespace {

constexpr auto none = static_cast<std::uint32_t>(-1);

/// Undirected edges in the order of their lower vertices, each with the two triangles on it, of
/// which one is `none` on M's border.
struct Edges {
  std::vector<std::array<std::uint32_t, 2>> ends;
  std::vector<std::array<std::uint32_t, 2>> triangles;
  std::vector<std::uint32_t> of_directed;  // by edge number of the graph
  std::vector<std::array<std::uint32_t, 3>> of_triangle;
};

Edges undirected_edges(const Surface& surface) {
  const EdgeGraph& graph = surface.graph;
  Edges edges;
  edges.of_directed.resize(graph.lengths.size());
  for (std::uint32_t u = 0; u < graph.vertex_count(); ++u)
    graph.for_each_out_edge(u, [&](std::uint32_t v, std::uint32_t edge) {
      if (v < u) return;
      edges.of_directed[edge] = static_cast<std::uint32_t>(edges.ends.size());
      edges.ends.push_back({u, v});
    });
  for (std::uint32_t u = 0; u < graph.vertex_count(); ++u)
    graph.for_each_out_edge(u, [&](std::uint32_t v, std::uint32_t edge) {
      if (v < u) edges.of_directed[edge] = edges.of_directed[edge_between(graph, v, u)];
    });
  edges.triangles.assign(edges.ends.size(), {none, none});
  edges.of_triangle.resize(surface.triangles.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t u = surface.triangles[t][i];
      const std::uint32_t v = surface.triangles[t][(i + 1) % 3];
      const std::uint32_t edge = edges.of_directed[edge_between(graph, u, v)];
      edges.of_triangle[t][i] = edge;
      edges.triangles[edge][u < v ? 0 : 1] = t;
    }
  return edges;
}

std::vector<bool> spanning_forest(const Surface& surface, const Edges& edges) {
  std::vector<bool> in_forest(edges.ends.size());
  DisjointSets sets(static_cast<std::uint32_t>(surface.points.size()));
  for (std::size_t e = 0; e < edges.ends.size(); ++e)
    in_forest[e] = sets.unite(edges.ends[e][0], edges.ends[e][1]);
  return in_forest;
}

/// A triangle and the edge that leads to its parent in the forest of triangles.
struct Step {
  std::uint32_t triangle = 0;
  std::uint32_t edge = 0;
};

/// A spanning forest of the triangles across edges out of `in_forest`, breadth first, so that
/// parents come before their children. A component with a border is entered across an edge of it;
/// of the others one triangle each, the root, is left out.
std::vector<Step> triangle_forest(const Edges& edges, const std::vector<bool>& in_forest) {
  std::vector<Step> steps;
  std::vector<bool> seen(edges.of_triangle.size());
  std::vector<std::uint32_t> reached;
  const auto grow_from = [&](std::uint32_t root) {
    seen[root] = true;
    reached.assign(1, root);
    for (std::size_t next = 0; next < reached.size(); ++next)
      for (const std::uint32_t edge : edges.of_triangle[reached[next]]) {
        const auto [s, t] = edges.triangles[edge];
        const std::uint32_t child = s == reached[next] ? t : s;
        if (child == none || in_forest[edge] || seen[child]) continue;
        seen[child] = true;
        reached.push_back(child);
        steps.push_back({child, edge});
      }
  };
  for (std::uint32_t edge = 0; edge < edges.triangles.size(); ++edge) {
    const auto [s, t] = edges.triangles[edge];
    if (in_forest[edge] || (s != none && t != none) || seen[std::min(s, t)]) continue;
    steps.push_back({std::min(s, t), edge});
    grow_from(std::min(s, t));
  }
  for (std::uint32_t root = 0; root < edges.of_triangle.size(); ++root)
    if (!seen[root]) grow_from(root);
  return steps;
}

}  // namespace

SurfaceOrder order_surface(const Surface& surface) {
  const Edges edges = undirected_edges(surface);
  const std::vector<bool> in_forest = spanning_forest(surface, edges);
  const std::vector<Step> steps = triangle_forest(edges, in_forest);
  std::vector<std::uint32_t> row(edges.ends.size(), none);
  SurfaceOrder order;
  order.edges.reserve(edges.ends.size());
  const auto give_row = [&](std::uint32_t edge) {
    row[edge] = order.row_count();
    order.edges.push_back(edges.ends[edge]);
  };
  std::vector<bool> crossed(edges.ends.size());
  for (const Step& step : steps) crossed[step.edge] = true;
  for (std::uint32_t e = 0; e < row.size(); ++e)
    if (in_forest[e]) give_row(e);
  order.tree = order.row_count();
  for (std::uint32_t e = 0; e < row.size(); ++e)
    if (!in_forest[e] && !crossed[e]) give_row(e);
  order.killed = order.row_count();
  if (order.killed - order.tree != surface.betti1())
    throw SelfCheckFailed("the surface has " + std::to_string(surface.betti1()) +
                          " independent loops, but " + std::to_string(order.killed - order.tree) +
                          " of its edges stay unpaired");
  std::for_each(steps.rbegin(), steps.rend(), [&](const Step& step) { give_row(step.edge); });
  std::for_each(steps.rbegin(), steps.rend(), [&](const Step& step) {
    auto& cycle = order.killed_cycles.emplace_back(edges.of_triangle[step.triangle]);
    for (std::uint32_t& edge : cycle) edge = row[edge];
  });
  order.row_of_edge = edges.of_directed;
  for (std::uint32_t& edge : order.row_of_edge) edge = row[edge];
  return order;
}

std::uint32_t row_between(const Surface& surface, const SurfaceOrder& order, std::uint32_t a,
                          std::uint32_t b) {
  return order.row_of_edge[edge_between(surface.graph, a, b)];
}

}  // namespace isoloop
