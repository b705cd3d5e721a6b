#include "core/betti.h"

namespace isoloop {

Betti betti_numbers(const Surface& surface) {
  Betti betti;
  for (const SurfaceComponent& component : surface.components) {
    ++(component.bounds_cavity ? betti.b2 : betti.b0);
    betti.b1 += component.genus;
  }
  return betti;
}

}  // namespace isoloop
