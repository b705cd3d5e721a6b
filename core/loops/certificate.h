// The class of every walk on M in H1(I) and H1(O): what certifies a loop.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/complex/near_surface.h"
#include "core/curves/curve.h"
#include "core/engines/dual_pass.h"
#include "core/surface/surface.h"
#include "core/z2/label.h"

namespace isoloop {

/// A cocycle on M's edge graph: the values along a closed walk sum to its class in
/// H1(I) + H1(O), which equals H1(M). Generators below inside_rank are those of H1(I) (numbered as
/// in the inside's DualPass), those from inside_rank on are those of H1(O).
struct SurfaceClasses {
  std::uint32_t inside_rank = 0;
  std::uint32_t outside_rank = 0;
  LabelPool pool;
  std::vector<std::uint32_t> of_edge;  // by edge number of the graph; numbers in pool
};

/// The same where the sides are not told apart: a cocycle with its values in H1(M), one generator
/// for each edge that stays unpaired after M (core/surface/surface_order.h). inside_rank is 0.
SurfaceClasses surface_classes(const Surface& surface);

/// Pushes M's edges off M to either side. At a vertex of M a walk turns round a grid edge from one
/// cube to another; the labels of the pieces that it passes sum to its class. Compiled in
/// certificate.cpp for the complexes that are listed there.
template <BesideSurface C>
SurfaceClasses surface_classes(const Surface& surface, const C& inside, const DualPass& inside_pass,
                               const C& outside, const DualPass& outside_pass);

/// Class of a cycle of closed curves. Throws SelfCheckFailed where a curve leaves M's edges.
GeneratorSet class_of(const Surface& surface, const SurfaceClasses& classes,
                      std::span<const Curve> curves);

/// A class as seen from one side: its part in that side's homology, which vanishes if it bounds
/// there, and its part in the other side's. Generators from 0, as in the sides' own DualPass.
struct SplitClass {
  GeneratorSet own;
  GeneratorSet other;
};
SplitClass split_class(const SurfaceClasses& classes, Side side,
                       std::span<const std::uint32_t> set);

}  // namespace isoloop
