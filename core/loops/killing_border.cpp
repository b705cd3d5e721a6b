#include "core/loops/killing_border.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "core/base/errors.h"
#include "core/complex/flat_complex.h"
#include "core/complex/grid_complex.h"
#include "core/complex/octree_complex.h"

namespace isoloop {

template <MeetsSurface C>
KillingBorders killing_borders(const C& complex, const DualPass& pass) {
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

template KillingBorders killing_borders(const GridComplex&, const DualPass&);
template KillingBorders killing_borders(const FlatComplex&, const DualPass&);
template KillingBorders killing_borders(const OctreeComplex&, const DualPass&);

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

}  // namespace isoloop
