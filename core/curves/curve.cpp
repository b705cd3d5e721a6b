#include "core/curves/curve.h"

#include <algorithm>
#include <cstddef>
#include <unordered_map>

namespace isoloop {

std::vector<Curve> closed_curves(std::span<const std::array<std::uint32_t, 2>> edges) {
  std::unordered_multimap<std::uint32_t, std::size_t> at;  // vertex -> edge
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const std::uint32_t vertex : edges[e]) at.emplace(vertex, e);
  std::vector<bool> used(edges.size());
  std::vector<Curve> curves;
  for (std::size_t start = 0; start < edges.size(); ++start) {
    if (used[start]) continue;
    Curve path{edges[start][0]};
    std::unordered_map<std::uint32_t, std::size_t> place{{path[0], 0}};
    for (std::size_t next = start; next < edges.size();) {
      used[next] = true;
      const std::uint32_t to = edges[next][edges[next][0] == path.back() ? 1 : 0];
      const auto [met, is_new] = place.try_emplace(to, path.size());
      if (is_new) {
        path.push_back(to);
      } else {  // the path has come round: cut the curve off and go on from there
        const auto begin = path.begin() + static_cast<std::ptrdiff_t>(met->second);
        curves.emplace_back(begin, path.end());
        for (auto v = begin + 1; v != path.end(); ++v) place.erase(*v);
        path.erase(begin + 1, path.end());
      }
      next = edges.size();
      const auto [from, end] = at.equal_range(path.back());
      for (auto it = from; it != end; ++it)
        if (!used[it->second]) next = std::min(next, it->second);
    }
  }
  return curves;
}

double length_of(const Surface& surface, std::span<const Curve> curves) {
  double length = 0.0;
  for (const Curve& curve : curves)
    for_each_edge(curve, [&](std::uint32_t u, std::uint32_t v) {
      length += distance(scaled_point(surface, u), scaled_point(surface, v));
    });
  return length;
}

}  // namespace isoloop
