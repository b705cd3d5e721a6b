#include "tools/reports/report_scan.h"

#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/flags/input_flags.h"
#include "tools/reports/report_json.h"
#include "tools/reports/report_table.h"
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

std::string span_text(const IsoScan& scan, const Plateau& plateau) {
  const std::string first = shortest_text(scan.rows[plateau.first].iso);
  if (plateau.first == plateau.last) return first;
  return first + " to " + shortest_text(scan.rows[plateau.last].iso);
}

// One row each; marked where it is among the widest meaningful ones.
std::vector<Row<7>> plateau_rows(const IsoScan& scan) {
  const std::vector<std::size_t> widest = widest_plateaus(scan);
  std::vector<Row<7>> rows{{"iso", "width", "b0", "b1", "b2", "χ", "plateau"}};
  for (std::size_t i = 0; i < scan.plateaus.size(); ++i) {
    const Plateau& plateau = scan.plateaus[i];
    const ScanRow& row = scan.rows[plateau.first];
    const auto place = std::find(widest.begin(), widest.end(), i);
    rows.push_back(
        {span_text(scan, plateau), shortest_text(plateau.width), std::to_string(row.betti.b0),
         std::to_string(row.betti.b1), std::to_string(row.betti.b2), std::to_string(row.euler),
         place == widest.end() ? "" : "widest, no. " + std::to_string(place - widest.begin() + 1)});
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
          {"inside_voxels", row.inside_voxels}};
}

Json plateau_of(const IsoScan& scan, const Plateau& plateau) {
  const ScanRow& row = scan.rows[plateau.first];
  return {{"from", row.iso},
          {"to", scan.rows[plateau.last].iso},
          {"b0", row.betti.b0},
          {"b1", row.betti.b1},
          {"b2", row.betti.b2},
          {"width", plateau.width},
          {"meaningful", plateau.meaningful}};
}

template <class Items, class ToJson>
void write_list(std::ostream& out, const char* name, const Items& items, const ToJson& to_json) {
  out << ",\n  \"" << name << "\": [";
  const char* separator = "\n    ";
  for (const auto& item : items) {
    out << separator << to_json(item).dump();
    separator = ",\n    ";
  }
  out << (items.empty() ? "]" : "\n  ]");
}

}  // namespace

std::vector<std::size_t> widest_plateaus(const IsoScan& scan, std::size_t most) {
  std::vector<std::size_t> widest;
  for (std::size_t i = 0; i < scan.plateaus.size(); ++i)
    if (scan.plateaus[i].meaningful) widest.push_back(i);
  std::stable_sort(widest.begin(), widest.end(), [&](std::size_t a, std::size_t b) {
    return scan.plateaus[a].width > scan.plateaus[b].width;
  });
  widest.resize(std::min(widest.size(), most));
  return widest;
}

void write_scan_table(std::ostream& out, const ScanRun& run) {
  const IsoScan& scan = run.scan;
  out << run.file << ": " << volume_text(run.volume) << ", inside is " << rule_text(run) << ", "
      << counted(static_cast<std::int64_t>(scan.rows.size()), "iso value", "iso values") << " from "
      << shortest_text(scan.rows.front().iso) << " to " << shortest_text(scan.rows.back().iso)
      << "\n\n";
  write_rows(out, plateau_rows(scan), {false, false, false, false, false, false, true});
  out << "\nb0: components, b1: tunnels (the genus of the surface), b2: cavities, χ: of the "
         "surface\n";
  if (!scan.proposed) {
    out << "no iso value is proposed: no two neighbours give equal counts of a solid and an "
           "outside that both hold a thousandth of the voxels\n";
    write_hint(out, run);
    return;
  }
  const std::size_t widest = widest_plateaus(scan, 1).front();
  out << "proposed: --iso " << shortest_text(scan.rows[*scan.proposed].iso)
      << ", in the middle of the widest plateau, " << span_text(scan, scan.plateaus[widest])
      << '\n';
  write_hint(out, run);
}

void write_scan_csv(std::ostream& out, const ScanRun& run) {
  const IsoScan& scan = run.scan;
  out << "iso,b0,b1,b2,euler,genus,inside_voxels,plateau,meaningful\n";
  for (std::size_t p = 0; p < scan.plateaus.size(); ++p) {
    for (std::size_t i = scan.plateaus[p].first; i <= scan.plateaus[p].last; ++i) {
      const ScanRow& row = scan.rows[i];
      out << shortest_text(row.iso) << ',' << row.betti.b0 << ',' << row.betti.b1 << ','
          << row.betti.b2 << ',' << row.euler << ',' << row.genus << ',' << row.inside_voxels << ','
          << p + 1 << ',' << (scan.plateaus[p].meaningful ? 1 : 0) << '\n';
    }
  }
}

void write_scan_json(std::ostream& out, const ScanRun& run) {
  const IsoScan& scan = run.scan;
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
  out << "{\n  \"schema\": \"isoloop/1\",\n  \"input\": "
      << input.dump(-1, ' ', false, Json::error_handler_t::replace)
      << ",\n  \"conventions\": " << conventions.dump();
  write_list(out, "scan", scan.rows, row_of);
  write_list(out, "plateaus", scan.plateaus,
             [&scan](const Plateau& plateau) { return plateau_of(scan, plateau); });
  out << ",\n  \"proposed_iso\": "
      << (scan.proposed ? Json(scan.rows[*scan.proposed].iso) : Json()).dump()
      << ",\n  \"seconds\": "
      << Json{{"read", run.cost.read_seconds}, {"total", run.cost.total_seconds}}.dump()
      << ",\n  \"peak_bytes\": " << run.cost.peak_bytes << "\n}\n";
}

}  // namespace isoloop
