#include "core/killing_border.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

#include "core/errors.h"

namespace isoloop {

KillingBorders killing_borders(const GridComplex& complex, const DualPass& pass) {
  KillingBorders borders;
  borders.first.resize(pass.killing.size() + 1);
  const auto visit_all = [&](const auto& visit) {
    pass.labels.for_each([&](std::uint32_t piece, std::uint32_t label) {
      for (const auto& segment : complex.segments(piece))
        for (const std::uint32_t generator : pass.pool.generators(label)) visit(generator, segment);
    });
  };
  visit_all([&](std::uint32_t generator, const auto&) { ++borders.first[generator + 1]; });
  std::partial_sum(borders.first.begin(), borders.first.end(), borders.first.begin());
  borders.edges.resize(borders.first.back());
  std::vector<std::size_t> cursor = borders.first;
  visit_all([&](std::uint32_t generator, const auto& segment) {
    borders.edges[cursor[generator]++] = segment;
  });
  return borders;
}

Z2Basis border_classes(const Surface& surface, const SurfaceClasses& classes, Side side,
                       const KillingBorders& borders) {
  Z2Basis basis;
  for (std::uint32_t i = 0; i + 1 < borders.first.size(); ++i) {
    const std::vector<Curve> curves = closed_curves(borders.of(i));
    const SplitClass border = split_class(classes, side, class_of(surface, classes, curves));
    if (!border.own.empty() || !basis.add(border.other))
      throw SelfCheckFailed(std::string("the border of the surface across ") +
                            (side == Side::inside ? "handle " : "tunnel ") + std::to_string(i + 1) +
                            " is not a cycle of its kind");
  }
  return basis;
}

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
    for (std::size_t i = 0; i < curve.size(); ++i)
      length += distance(scaled_point(surface, curve[i]),
                         scaled_point(surface, curve[(i + 1) % curve.size()]));
  return length;
}

}  // namespace isoloop
