#include "tools/reports/report_stats.h"

#include <algorithm>
#include <array>
#include <string>

#include "tools/flags/engine_flags.h"
#include "tools/words/number_text.h"

namespace isoloop {

void write_stats(std::ostream& out, const LoopsRun& run) {
  const Surface& surface = run.analysis.surface;
  const StageSeconds& seconds = run.analysis.seconds;
  const double geodesic = seconds.closest + seconds.sizes;
  const double loops = seconds.surface + seconds.pass + seconds.pair + seconds.loops;
  std::array<std::string, 6> head{"surface triangles", "volume triangles", "genus",
                                  "geodesic s",        "loops s",          "engine"};
  std::array<std::string, 6> row{std::to_string(surface.triangles.size()),
                                 std::to_string(run.analysis.volume_triangles),
                                 std::to_string(surface.genus()),
                                 fixed_text(geodesic, 2),
                                 fixed_text(loops, 2),
                                 engine_text(run.engine)};
  for (auto* const line : {&head, &row}) {
    for (std::size_t c = 0; c < line->size(); ++c) {
      const std::size_t width = std::max(head[c].size(), row[c].size());
      out << (c == 0 ? "" : "  ") << std::string(width - (*line)[c].size(), ' ') << (*line)[c];
    }
    out << '\n';
  }
}

}  // namespace isoloop
