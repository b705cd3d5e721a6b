#include "tools/reports/report_repair.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/flags/input_flags.h"
#include "tools/reports/report_json.h"
#include "tools/reports/report_table.h"
#include "tools/words/largest.h"
#include "tools/words/number_text.h"
#include "tools/words/sentence.h"
#include "tools/words/text_rows.h"
#include "volume/base/memory_limit.h"

namespace isoloop {
namespace {

using Json = nlohmann::ordered_json;

double voxel_volume(const RepairRun& run) {
  const Vec3& spacing = run.volume.spacing;
  return spacing[0] * spacing[1] * spacing[2];
}

std::string action_text(RepairAction action) {
  return action == RepairAction::cut ? "cut" : "filled";
}

std::string center_text(const Vec3& center) {
  std::string text = "(";
  for (const std::size_t a : {0U, 1U, 2U}) {
    if (a > 0) text += ", ";
    text += fixed_text(center[a], 1);
  }
  return text += ")";
}

void write_counts(std::ostream& out, const Repair& repair) {
  const auto row = [&](const char* name, std::int64_t before, std::int64_t after) {
    out << std::left << std::setw(10) << name << std::right << std::setw(9) << before
        << std::setw(9) << after << '\n';
  };
  out << "            before    after\n";
  row("components", repair.before.betti.b0, repair.after.betti.b0);
  row("tunnels", repair.before.betti.b1, repair.after.betti.b1);
  row("cavities", repair.before.betti.b2, repair.after.betti.b2);
}

std::string done_text(const Removal& removal) {
  const std::string done = action_text(removal.action);
  return removal.by.kind == removal.loop.kind ? done : done + ' ' + text_of(removal.by);
}

void write_removals(std::ostream& out, const RepairRun& run, std::size_t most_rows) {
  if (run.repair.removals.empty()) return;
  const int decimals = length_decimals(run.volume.spacing);
  std::vector<Row<6>> rows{
      {"round", "loop", with_unit("length", run.volume), "done", "voxels", "centre (index)"}};
  for (const Removal* removal : items_in_rows(run.repair.removals, most_rows, &Removal::length))
    rows.push_back({std::to_string(removal->round), text_of(removal->loop),
                    fixed_text(removal->length, decimals), done_text(*removal),
                    std::to_string(removal->voxels), center_text(removal->center_index)});
  out << '\n';
  write_rows(out, rows, {false, true, false, true, false, true});
  write_more(out, rows.size() - 1, run.repair.removals.size());
}

void write_kept(std::ostream& out, const RepairRun& run, std::size_t most_rows) {
  if (run.repair.kept.empty()) return;
  const int decimals = length_decimals(run.volume.spacing);
  std::vector<Row<4>> rows{
      {"round", "cannot be removed", with_unit("length", run.volume), "centre (index)"}};
  for (const KeptLoop* kept : items_in_rows(run.repair.kept, most_rows, &KeptLoop::length))
    rows.push_back({std::to_string(kept->round), text_of(kept->loop),
                    fixed_text(kept->length, decimals), center_text(kept->center_index)});
  out << '\n';
  write_rows(out, rows, {false, true, false, true});
  write_more(out, rows.size() - 1, run.repair.kept.size());
}

Json counts_of(const Analysis& analysis) {
  const Surface& surface = analysis.surface;
  return {
      {"vertices", surface.points.size()},
      {"triangles", surface.triangles.size()},
      {"components", surface.components.size()},
      {"euler", surface.euler()},
      {"genus", surface.genus()},
      {"betti", {{"b0", analysis.betti.b0}, {"b1", analysis.betti.b1}, {"b2", analysis.betti.b2}}}};
}

Json kept_of(const RepairRun& run, const KeptLoop& kept) {
  return {{"kind", kind_text(kept.loop.kind)},
          {"id", kept.loop.id},
          {"round", kept.round},
          {"length", kept.length},
          {"center_index", kept.center_index},
          {"center_world", to_world(run.volume, kept.center_index)}};
}

Json removal_of(const RepairRun& run, const Removal& removal) {
  return {{"kind", kind_text(removal.loop.kind)},
          {"id", removal.loop.id},
          {"round", removal.round},
          {"length", removal.length},
          {"action", removal.action == RepairAction::cut ? "cut" : "fill"},
          {"along", {{"kind", kind_text(removal.by.kind)}, {"id", removal.by.id}}},
          {"voxels", removal.voxels},
          {"center_index", removal.center_index},
          {"center_world", to_world(run.volume, removal.center_index)}};
}

}  // namespace

void write_repair_table(std::ostream& out, const RepairRun& run, std::size_t most_rows) {
  const Repair& repair = run.repair;
  out << run.file << ": " << dims_text(run.volume.dims) << ' ' << type_name(run.volume.values)
      << ", inside is " << inside_text(run) << "\n\n";
  write_counts(out, repair);
  write_removals(out, run, most_rows);
  write_kept(out, run, most_rows);
  const auto volume_of = [&](std::int64_t voxels) {
    return "(volume " +
           fixed_text(static_cast<double>(voxels) * voxel_volume(run),
                      length_decimals(run.volume.spacing)) +
           (run.volume.unit.empty() ? "" : " " + run.volume.unit + "³") + ")";
  };
  out << '\n'
      << counted(static_cast<std::int64_t>(repair.changes.size()), "voxel", "voxels")
      << " changed: " << repair.added_voxels << " filled " << volume_of(repair.added_voxels) << ", "
      << repair.removed_voxels << " cut away " << volume_of(repair.removed_voxels);
  if (repair.shifted_voxels > 0)
    out << ", " << repair.shifted_voxels << " shifted on the side that they were on";
  out << '\n';
  if (repair.removals.empty()) {
    out << (repair.kept.empty() ? "nothing to repair\n" : "nothing was removed\n");
  } else {
    out << "verified: genus " << repair.before.surface.genus() << " - " << repair.removals.size()
        << " = " << repair.after.surface.genus()
        << "; components and cavities are as before; all other loops are still there\n";
  }
}

void write_repair_json(std::ostream& out, const RepairRun& run) {
  const Repair& repair = run.repair;
  Json removals = Json::array();
  for (const Removal& removal : repair.removals) removals.push_back(removal_of(run, removal));
  Json kept = Json::array();
  for (const KeptLoop& loop : repair.kept) kept.push_back(kept_of(run, loop));
  const double volume = voxel_volume(run);
  const Json json = {
      {"schema", "isoloop-repair/1"},
      {"input",
       {{"file", run.file},
        {"dims", run.volume.dims},
        {"type", type_name(run.volume.values)},
        {"spacing", run.volume.spacing},
        {"mesh", mesh_json(run, repair.before)},
        {"notes", notes_of(run)},
        {"warnings", sentences_of(run.volume.warnings)}}},
      {"iso", run.level.iso},
      {"conventions",
       {{"inside", inside_text(run.level)},
        {"topology", topology_text(run.level.topology)},
        {"round", "of analysis that `id` refers to; 1: of the input"},
        {"unit", "length: " + unit_text(run.volume) + "; volume: its cube"}}},
      {"output", run.output.empty() ? Json() : Json(run.output)},
      {"before", counts_of(repair.before)},
      {"after", counts_of(repair.after)},
      {"removals", std::move(removals)},
      {"kept", std::move(kept)},
      {"changed_voxels", repair.changes.size()},
      {"filled_voxels", repair.added_voxels},
      {"cut_voxels", repair.removed_voxels},
      {"shifted_voxels", repair.shifted_voxels},
      {"filled_volume", static_cast<double>(repair.added_voxels) * volume},
      {"cut_volume", static_cast<double>(repair.removed_voxels) * volume},
      {"rounds", repair.rounds},
      {"verified", true},
      {"seconds", {{"read", run.cost.read_seconds}, {"total", run.cost.total_seconds}}},
      {"peak_bytes", run.cost.peak_bytes}};
  out << json.dump(1, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace isoloop
