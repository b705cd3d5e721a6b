#include "tools/reports/report_pairs.h"

#include "tools/words/number_text.h"

namespace isoloop {

void write_pairs(std::ostream& out, const LoopsRun& run) {
  out << "side,size,piece,a,a_world_x,a_world_y,a_world_z,b,b_world_x,b_world_y,b_world_z\n";
  for (const SurfacePair& pair : run.analysis.pairs) {
    out << (pair.side == Side::inside ? "inside," : "outside,") << shortest_text(pair.size) << ','
        << pair.piece;
    for (const std::uint32_t vertex : pair.edge) {
      const auto& point = run.analysis.surface.points[vertex];
      out << ',' << vertex;
      for (const double position : to_world(run.volume, {point[0], point[1], point[2]})) {
        out << ',' << shortest_text(position);
      }
    }
    out << '\n';
  }
}

}  // namespace isoloop
