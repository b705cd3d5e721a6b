#include "tools/reports/report_summary.h"

#include <algorithm>
#include <string>

#include "tools/reports/report_table.h"
#include "tools/words/number_text.h"

namespace isoloop {
namespace {

void write_iso(std::ostream& out, const IsoLevel& level) {
  out << "iso=" << shortest_text(level.iso);
  if (level.upper) out << " iso_upper=" << shortest_text(*level.upper);
}

void write_counts(std::ostream& out, const Analysis& analysis) {
  const Betti& betti = analysis.betti;
  out << " b0=" << betti.b0 << " b1=" << betti.b1 << " b2=" << betti.b2
      << " euler=" << analysis.surface.euler() << " genus=" << analysis.surface.genus();
}

void write_kind(std::ostream& out, const LoopsRun& run, LoopKind kind) {
  double length = 0.0;
  std::int64_t loops = 0;
  for (const Loop& loop : run.reported) {
    if (loop.kind != kind) continue;
    length += loop.length;
    ++loops;
  }
  const std::string name = kind_text(kind);
  out << ' ' << name << "s=" << loops << ' ' << name
      << "_length=" << fixed_text(length, length_decimals(run.volume.spacing));
}

}  // namespace

void write_count_summary(std::ostream& out, const CountRun& run) {
  write_iso(out, run.level);
  write_counts(out, run.analysis);
  out << '\n';
}

void write_loops_summary(std::ostream& out, const LoopsRun& run) {
  write_iso(out, run.level);
  write_counts(out, run.analysis);
  const bool open = run.analysis.surface.boundary == Boundary::open;
  if (open) write_kind(out, run, LoopKind::loop);
  if (!open && run.filter.handles) write_kind(out, run, LoopKind::handle);
  if (!open && run.filter.tunnels) write_kind(out, run, LoopKind::tunnel);
  out << '\n';
}

void write_scan_summary(std::ostream& out, const ScanRun& run) {
  const Scan& scan = run.scan;
  if (!scan.proposed) {
    out << "proposed_iso=none\n";
    return;
  }
  const ScanRow& row = scan.rows[*scan.proposed];
  out << "proposed_iso=" << shortest_text(row.iso)
      << " proposed_by=" << (scan.by == ProposedBy::plateau ? "plateau" : "otsu")
      << " large_b0=" << row.large.b0 << " large_b1=" << row.large.b1
      << " large_b2=" << row.large.b2 << " ignored_below=" << scan.ignored_below << '\n';
}

void write_repair_summary(std::ostream& out, const RepairRun& run) {
  const Repair& repair = run.repair;
  write_iso(out, run.level);
  write_counts(out, repair.after);
  out << " removals=" << repair.removals.size() << " kept=" << repair.kept.size()
      << " changed_voxels=" << repair.changes.size() << " filled_voxels=" << repair.added_voxels
      << " cut_voxels=" << repair.removed_voxels << " shifted_voxels=" << repair.shifted_voxels
      << '\n';
}

}  // namespace isoloop
