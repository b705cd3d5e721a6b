#include "core/tighten/straighten.h"

#include <string>
#include <utility>

#include <tbb/parallel_for.h>

#include "core/base/errors.h"
#include "core/curves/geodesic.h"
#include "core/curves/triangle_fans.h"

namespace isoloop {

std::vector<Loop> straightened(const Surface& surface, const SurfaceClasses& classes,
                               std::vector<Loop> loops) {
  const TriangleFans fans(surface);
  tbb::parallel_for(std::size_t{0}, loops.size(), [&](std::size_t i) {
    Loop& loop = loops[i];
    std::vector<Geodesic> geodesics;
    for (const Curve& curve : loop.curves) {
      geodesics.push_back(closed_geodesic(surface, fans, curve));
      if (!lies_on(surface, fans, geodesics.back()))
        throw SelfCheckFailed(name_of(loop.kind) + " " + std::to_string(loop.id) +
                              " left the surface as it was straightened");
      const Curve pushed = pushed_to_edges(geodesics.back());
      if (class_of(surface, classes, {&pushed, 1}) != class_of(surface, classes, {&curve, 1}))
        throw SelfCheckFailed(name_of(loop.kind) + " " + std::to_string(loop.id) +
                              " left its class as it was straightened");
    }
    set_geodesics(surface, loop, std::move(geodesics));
  });
  return loops;
}

}  // namespace isoloop
