#include "tools/reports/report_csv.h"

#include "tools/reports/report_features.h"
#include "tools/reports/report_table.h"
#include "tools/words/number_text.h"

namespace isoloop {
namespace {

const char* triviality(const Loop& loop, bool trivial) {
  if (loop.kind == LoopKind::loop) return "unknown";
  return trivial ? "trivial" : "nontrivial";
}

constexpr const char* feature_columns =
    "label,area,depth,thickness,least_girth,mean_girth,axis_x,axis_y,axis_z";

void write_feature_cells(std::ostream& out, const LoopsRun& run, const Loop& loop) {
  const std::size_t place = place_of(run, loop);
  const Feature& feature = run.features[place];
  out << ',' << place + 1;
  for (const double x :
       {feature.area, feature.depth, feature.thickness(), feature.least_girth, feature.mean_girth})
    out << ',' << shortest_text(x);
  for (const double x : world_axis(run, feature)) out << ',' << shortest_text(x);
}

}  // namespace

void write_csv(std::ostream& out, const LoopsRun& run) {
  out << "id,kind,fix,length,size,component,curves,"
         "center_index_i,center_index_j,center_index_k,"
         "center_world_x,center_world_y,center_world_z,"
         "certificate_inside,certificate_outside";
  if (run.with_features) out << ',' << feature_columns;
  out << '\n';
  for (const Loop& loop : run.reported) {
    out << loop.id << ',' << kind_text(loop.kind) << ',' << fix_text(loop.kind) << ','
        << shortest_text(loop.length) << ',' << shortest_text(loop.size) << ',' << loop.component
        << ',' << loop.curves.size();
    for (const double index : loop.center_index) out << ',' << shortest_text(index);
    for (const double position : to_world(run.volume, loop.center_index)) {
      out << ',' << shortest_text(position);
    }
    out << ',' << triviality(loop, loop.certificate.trivial_inside) << ','
        << triviality(loop, loop.certificate.trivial_outside);
    if (run.with_features) write_feature_cells(out, run, loop);
    out << '\n';
  }
}

void write_count_csv(std::ostream& out, const CountRun& run) {
  const Surface& surface = run.analysis.surface;
  out << "component,vertices,triangles,euler,genus,bounds,borders\n";
  for (std::size_t i = 0; i < surface.components.size(); ++i) {
    const SurfaceComponent& part = surface.components[i];
    out << i << ',' << part.vertices << ',' << part.triangles << ',' << part.euler << ','
        << part.genus << ',' << bounds_text(surface.boundary, part) << ',' << part.borders << '\n';
  }
}

}  // namespace isoloop
