// Closed geodesics: curves on M that cross its triangles and are as short as their surroundings
// allow.
#pragma once

#include "core/curves/curve.h"
#include "core/curves/triangle_fans.h"
#include "core/surface/surface.h"
#include "isoloop/loop.h"

namespace isoloop {

/// Whether it is as described: shares between 0 and 1, and each point and the next in one triangle.
bool lies_on(const Surface& surface, const TriangleFans& fans, const Geodesic& geodesic);

/// In voxel indices.
Vec3 index_point(const SurfaceMesh& surface, const SurfacePoint& point);

/// In the unit of the spacing.
double length_of(const Surface& surface, const Geodesic& geodesic);

/// A walk along edges of M that the geodesic can be moved to within M: each point goes to the
/// nearer end of its edge, and ends of neighbours are corners of one triangle. Where vertices would
/// follow themselves there is but one.
Curve pushed_to_edges(const Geodesic& geodesic);

/// A curve that `curve` can be moved to within M, no longer, and straight when the triangles round
/// it are laid flat, except at vertices where it leaves pi or more on either side: no small
/// movement makes it shorter. From the triangles to the left of the curve it moves across vertices
/// for as long as that helps (Xin and Wang, CAD 39, 2007, for closed paths). A curve that shrinks
/// to the fan of one vertex, so that it bounds a disc, is returned as it is.
Geodesic closed_geodesic(const Surface& surface, const TriangleFans& fans, const Curve& curve);

}  // namespace isoloop
