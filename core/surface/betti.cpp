#include "core/surface/betti.h"

namespace isoloop {

Betti betti_numbers(const Surface& surface) {
  Betti betti;
  if (surface.boundary == Boundary::open) {
    betti.b0 = static_cast<std::int64_t>(surface.components.size());
    betti.b1 = surface.betti1();
    for (const SurfaceComponent& component : surface.components)
      betti.b2 += component.borders == 0 ? 1 : 0;
    return betti;
  }
  for (const SurfaceComponent& component : surface.components) {
    ++(component.bounds_cavity ? betti.b2 : betti.b0);
    betti.b1 += component.genus;
  }
  return betti;
}

}  // namespace isoloop
