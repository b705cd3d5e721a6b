#include "tools/runs/count_run.h"

#include <utility>

#include "core/base/errors.h"
#include "tools/runs/frowns.h"
#include "tools/runs/read_run.h"
#include "tools/words/number_text.h"

namespace isoloop {
namespace {

void complete_hint(RunInput& run) {
  if (run.hint.empty()) return;
  const IsoLevel level{.iso = run.range.max, .topology = Topology::connected_26};
  try {
    const Betti betti =
        count_topology(voxels_of(run), level, {.max_bytes = run.cost.max_bytes}).betti;
    run.hint += ", which gives " + counted(betti.b0, "component", "components") + ", " +
                counted(betti.b1, "tunnel", "tunnels") + " and " +
                counted(betti.b2, "cavity", "cavities");
  } catch (const LimitExceeded&) {  // what was asked for may have room all the same
  }
}

}  // namespace

CountRun counted_run(RunInput volume, Boundary boundary, const Progress& progress) {
  CountRun run{std::move(volume)};
  complete_hint(run);
  run.analysis = about_file(run.file, [&] {
    return count_topology(
        voxels_of(run), run.level,
        {.boundary = boundary, .progress = progress, .max_bytes = run.cost.max_bytes});
  });
  check_counts(run.analysis);
  for (std::string& warning : count_warnings(run, run.analysis))
    add_warning(run, std::move(warning));
  return run;
}

}  // namespace isoloop
