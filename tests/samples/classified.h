// A small volume with M, both passes and the classes of walks on M.
#pragma once

#include "core/engines/dual_pass.h"
#include "core/loops/certificate.h"
#include "tests/samples/core_fixture.h"

namespace isoloop::testing {

struct Classified {
  explicit Classified(const SmallVolume& volume)
      : prepared(volume, GeodesicMode::hierarchy),
        inside(prepared.pass_on(Side::inside)),
        outside(prepared.pass_on(Side::outside)),
        classes(surface_classes(prepared.surface, *prepared.inside, inside, *prepared.outside,
                                outside)) {}
  Prepared prepared;
  DualPass inside;
  DualPass outside;
  SurfaceClasses classes;
};

}  // namespace isoloop::testing
