#include "core/repair/loop_site.h"

#include <map>

#include "core/loops/certificate.h"
#include "core/loops/loops.h"

namespace isoloop {

LoopSite site_of(const Workings& workings, const Loop& loop) {
  const Surface& surface = workings.analysis.surface;
  const Side side = side_of(loop.kind);
  LoopSite site;
  site.kind = loop.kind;
  site.other = loop.generators;
  site.crossing = workings.on(side).border_classes.coordinates(site.other).value();
  site.length = loop.length;
  for (const std::vector<Vec3>& points : drawn_curves(surface, loop))
    for (std::size_t i = 0; i < points.size(); ++i)
      site.steps += distance(points[i], points[(i + 1) % points.size()]);
  std::map<std::uint32_t, std::vector<Curve>> by_component;
  for (const Curve& curve : loop.curves)
    by_component[surface.component_of_vertex[curve.front()]].push_back(curve);
  std::size_t nontrivial = 0;
  for (const auto& [component, curves] : by_component)
    if (!class_of(surface, workings.classes, curves).empty()) ++nontrivial;
  site.spans_components = nontrivial > 1;
  const std::size_t on_edges = surface.grid_edges.size();
  for (const Curve& curve : loop.curves)
    for (const std::uint32_t vertex : curve)
      if (vertex < on_edges)
        site.edges.push_back(surface.grid_edges[vertex]);
      else
        site.cubes.push_back(workings.sides->tunnels[(vertex - on_edges) / ring_size].cube);
  return site;
}

std::uint32_t vertex_of(std::size_t voxel, const Index3& dims, const Lattice& lattice) {
  return *lattice.vertex_at(voxel_index(voxel, dims));
}

GeneratorSet joint_class(const Workings& workings, const LoopSite& site) {
  GeneratorSet set = site.other;
  // The class of a handle loop lies in H1(O), whose generators come after those of H1(I).
  if (site.kind == LoopKind::handle)
    for (std::uint32_t& generator : set) generator += workings.classes.inside_rank;
  return set;
}

}  // namespace isoloop
