#include "tools/reports/report_scan.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/scan/plateau.h"
#include "tools/flags/input_flags.h"
#include "tools/reports/report_json.h"
#include "tools/reports/report_table.h"
#include "tools/runs/scan_run.h"
#include "tools/words/json_text.h"
#include "tools/words/number_text.h"
#include "tools/words/sentence.h"
#include "tools/words/text_rows.h"
#include "volume/base/memory_limit.h"

namespace isoloop {
namespace {

using Json = nlohmann::ordered_json;

std::string rule_text(const ScanRun& run) {
  return run.level.inside == InsideRule::above ? "f >= iso" : "f <= iso";
}

std::string span_text(const Scan& scan, const Plateau& plateau) {
  const std::string first = shortest_text(scan.rows[plateau.first].iso);
  if (plateau.first == plateau.last) return first;
  return first + " to " + shortest_text(scan.rows[plateau.last].iso);
}

// One row each; marked where it is meaningful.
std::vector<Row<7>> plateau_rows(const Scan& scan) {
  const std::vector<std::size_t> stablest = stablest_plateaus(scan.plateaus);
  std::vector<Row<7>> rows{{"iso", "width", "b0", "b1", "b2", "χ", "plateau"}};
  for (std::size_t i = 0; i < scan.plateaus.size(); ++i) {
    const Plateau& plateau = scan.plateaus[i];
    const ScanRow& row = scan.rows[plateau.first];
    const auto place = std::find(stablest.begin(), stablest.end(), i);
    rows.push_back(
        {span_text(scan, plateau), shortest_text(plateau.width), std::to_string(row.large.b0),
         std::to_string(row.large.b1), std::to_string(row.large.b2),
         std::to_string(2 * (row.large.b0 - row.large.b1 + row.large.b2)),
         place == stablest.end() ? ""
                                 : "stable, no. " + std::to_string(place - stablest.begin() + 1)});
  }
  return rows;
}

Json row_of(const ScanRow& row) {
  return {{"iso", row.iso},
          {"b0", row.betti.b0},
          {"b1", row.betti.b1},
          {"b2", row.betti.b2},
          {"euler", row.euler},
          {"genus", row.genus},
          {"inside_voxels", row.inside_voxels},
          {"large_b0", row.large.b0},
          {"large_b1", row.large.b1},
          {"large_b2", row.large.b2}};
}

Json plateau_of(const Scan& scan, const Plateau& plateau) {
  const ScanRow& row = scan.rows[plateau.first];
  return {{"from", row.iso},          {"to", scan.rows[plateau.last].iso},
          {"b0", row.large.b0},       {"b1", row.large.b1},
          {"b2", row.large.b2},       {"width", plateau.width},
          {"voxels", plateau.voxels}, {"meaningful", plateau.meaningful}};
}

Json proposer_json(const ScanRun& run) {
  if (!run.scan.proposed) return {};
  return run.scan.by == ProposedBy::plateau ? "plateau" : "otsu";
}

}  // namespace

void write_scan_table(std::ostream& out, const ScanRun& run) {
  const Scan& scan = run.scan;
  out << run.file << ": " << volume_text(run.volume) << ", inside is " << rule_text(run) << ", "
      << counted(static_cast<std::int64_t>(scan.rows.size()), "iso value", "iso values") << " from "
      << shortest_text(scan.rows.front().iso) << " to " << shortest_text(scan.rows.back().iso)
      << "\n\n";
  write_rows(out, plateau_rows(scan), {false, false, false, false, false, false, true});
  out << "\nb0: components, b1: tunnels (the genus of the surface), b2: cavities, χ: of the "
         "surface\n";
  if (scan.ignored_below > 0)
    out << "set aside: components and cavities of less than " << scan.ignored_below
        << " voxels, and tunnels that are as small (--ignore-below " << scan.ignored_below << ")\n";
  const std::string labels = labels_text(run);
  if (!labels.empty()) {
    out << "no iso value is proposed: " << labels << '\n';
  } else if (!scan.proposed) {
    out << "no iso value is proposed: all voxels are on one side of each\n";
  } else {
    out << "proposed: --iso " << shortest_text(scan.rows[*scan.proposed].iso) << ", "
        << proposal_text(scan) << '\n';
  }
  write_hint(out, run);
}

void write_scan_csv(std::ostream& out, const ScanRun& run) {
  const Scan& scan = run.scan;
  out << "iso,b0,b1,b2,euler,genus,inside_voxels,large_b0,large_b1,large_b2,plateau,meaningful\n";
  for (std::size_t p = 0; p < scan.plateaus.size(); ++p) {
    for (std::size_t i = scan.plateaus[p].first; i <= scan.plateaus[p].last; ++i) {
      const ScanRow& row = scan.rows[i];
      out << shortest_text(row.iso) << ',' << row.betti.b0 << ',' << row.betti.b1 << ','
          << row.betti.b2 << ',' << row.euler << ',' << row.genus << ',' << row.inside_voxels << ','
          << row.large.b0 << ',' << row.large.b1 << ',' << row.large.b2 << ',' << p + 1 << ','
          << (scan.plateaus[p].meaningful ? 1 : 0) << '\n';
    }
  }
}

void write_scan_json(std::ostream& out, const ScanRun& run) {
  const Scan& scan = run.scan;
  const Json input = {{"file", run.file},
                      {"dims", run.volume.dims},
                      {"part", part_json(run.volume)},
                      {"type", type_name(run.volume.values)},
                      {"minimum", run.range.min},
                      {"maximum", run.range.max},
                      {"notes", notes_of(run)},
                      {"warnings", sentences_of(run.volume.warnings)}};
  const Json conventions = {
      {"inside_rule", run.level.inside == InsideRule::above ? "above" : "below"},
      {"topology", topology_text(run.level.topology)}};
  out << "{\n  \"schema\": \"isoloop/1\",\n  \"input\": " << line_of(input);
  write_member(out, "conventions", conventions);
  write_list(out, "scan", scan.rows, row_of);
  write_list(out, "plateaus", scan.plateaus,
             [&scan](const Plateau& plateau) { return plateau_of(scan, plateau); });
  const auto iso_at = [&](std::optional<std::size_t> row) {
    return row ? Json(scan.rows[*row].iso) : Json();
  };
  write_member(out, "ignored_below", scan.ignored_below);
  write_member(out, "proposed_iso", iso_at(scan.proposed));
  write_member(out, "proposed_by", proposer_json(run));
  write_member(out, "otsu_iso", iso_at(scan.otsu));
  write_member(out, "valley_iso", iso_at(scan.valley));
  write_member(out, "seconds",
               {{"read", run.cost.read_seconds}, {"total", run.cost.total_seconds}});
  write_member(out, "peak_bytes", run.cost.peak_bytes);
  out << "\n}\n";
}

}  // namespace isoloop
