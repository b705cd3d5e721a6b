#include "tools/commands/repair_command.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "core/base/stage.h"
#include "core/base/threads.h"
#include "tools/flags/flag_lists.h"
#include "tools/flags/repair_flags.h"
#include "tools/flags/table_flags.h"
#include "tools/flags/thread_flag.h"
#include "tools/reports/report_repair.h"
#include "tools/reports/report_summary.h"
#include "tools/runs/mesh_comparison.h"
#include "tools/runs/output_files.h"
#include "tools/runs/read_run.h"
#include "tools/runs/repair_run.h"
#include "tools/runs/report_run.h"
#include "tools/runs/written_volume.h"
#include "tools/words/flag_checks.h"
#include "tools/words/progress.h"
#include "volume/base/atomic_file.h"
#include "volume/base/file_kind.h"
#include "volume/base/memory_limit.h"
#include "volume/files/patch.h"

namespace isoloop {
namespace {

struct CommandFlags {
  VolumeFlags volume;
  LevelFlags level;
  RepairFlags repair;
  std::string output;
  std::string json;  // file, "-" or empty
  bool dry_run = false;
  int threads = 0;  // 0: one for each core
  ProgressFlags progress;
  TableFlags table;
};

/// Whether the output is the file with the changed voxels in their places. An .img file is none
/// without its header.
bool is_patched(const CommandFlags& flags, const Volume& volume) {
  return extension_of(flags.output) == extension_of(flags.volume.file) && volume.stored_at &&
         !extension_of(flags.volume.file).starts_with(".img") &&
         std::filesystem::equivalent(volume.stored_at->file, flags.volume.file);
}

bool has_least_value_inside(const Volume& volume, const CommandFlags& flags,
                            const IsoLevel& level) {
  if (volume.level_set) return false;
  if (flags.volume.label.empty()) return level.inside == InsideRule::below;
  const std::vector<std::int64_t> asked = parse_labels(flags.volume.label);
  const double least = value_range(volume).min;
  return std::any_of(asked.begin(), asked.end(),
                     [&](std::int64_t label) { return static_cast<double>(label) == least; });
}

/// Warns of what a volume that is written anew loses. Throws where that would be voxels.
void check_output(const CommandFlags& flags, const Volume& volume, RunInput& run) {
  if (is_patched(flags, volume)) return;
  check_written("--output", flags.output, volume);
  if (file_kind(flags.output) == FileKind::raw && flags.volume.skip.value_or(0) > 0) {
    throw InvalidArgument("--output " + flags.output +
                          " would lack the header that --skip passes over; name a .nrrd");
  }
  if (flags.volume.nan_as) {
    throw InvalidArgument("--output " + flags.output +
                          " would hold the value of --nan-as in place of NaN; only a copy of " +
                          flags.volume.file + " in its own format keeps NaN");
  }
  if (file_kind(flags.output) == FileKind::vdb &&
      has_least_value_inside(volume, flags, run.level)) {
    throw InvalidArgument("--output " + flags.output +
                          ": where a .vdb file is read, a layer of its least value lies round the "
                          "voxels, and here that is inside; name a .nrrd");
  }
  check_writer_memory("write", flags.output, run);
  warn_of_left_out(run, flags.output);
  const std::string& file = flags.volume.file;
  if (file_kind(flags.output) == file_kind(file)) {
    add_warning(run, flags.output + " is written anew and is no copy of " + file +
                         ": its voxels are " + type_name(volume.values) +
                         ", and what else the header states, and other frames, are left out");
  }
}

void change_voxels(const std::vector<VoxelChange>& changes, Volume& volume) {
  std::visit([&](auto& values) { make_changes(std::span(changes), values); }, volume.values);
}

void write_repaired(const CommandFlags& flags, const std::vector<VoxelChange>& changes,
                    const Volume& volume) {
  if (!is_patched(flags, volume)) {
    write_volume(volume, flags.output);
    return;
  }
  std::vector<std::size_t> voxels;
  voxels.reserve(changes.size());
  for (const VoxelChange& change : changes) voxels.push_back(change.voxel);
  AtomicFile file(flags.output);
  write_patched(volume, voxels, file.stream());
  file.commit();
}

void check_together(const CommandFlags& flags) {
  if (!flags.volume.crop.empty()) {
    throw InvalidArgument(
        "--crop does not go with repair, which writes the whole file with some voxels changed");
  }
  if (!flags.output.empty() && flags.dry_run) {
    throw InvalidArgument("--output does not go with --dry-run, which writes no volume");
  }
  if (flags.output.empty() && !flags.dry_run) {
    throw InvalidArgument("give --output FILE for the repaired volume, or --dry-run");
  }
}

/// The label map that --label makes a mask of.
Volume label_map(const CommandFlags& flags, RunInput& run) {
  VolumeFlags all = flags.volume;
  all.label.clear();
  ReadOptions options = read_options(all);
  options.max_bytes = run.cost.max_bytes;
  Volume labels = about_file(run.file, [&] {
    return in_stage("read", [&] { return read_named(all, options, run.staged); });
  });
  const std::uint64_t bytes = checked_voxel_bytes(
      labels.dims, bytes_per_voxel(voxel_type(labels.values)), flags.volume.file);
  run.cost.max_bytes -= std::min(run.cost.max_bytes, bytes);
  return labels;
}

/// `labels` is filled where --label asks for some and a volume is to be written.
RepairRun run_of(const CommandFlags& flags, std::optional<Volume>& labels,
                 const Progress& progress) {
  RunInput input = read_run(flags.volume, flags.level);
  const RepairRequest request = repair_request(flags.repair, &input.volume);
  if (!flags.dry_run && !flags.volume.label.empty()) labels = label_map(flags, input);
  if (!flags.dry_run) check_output(flags, labels ? *labels : input.volume, input);
  tell_warnings(std::cerr, input);
  return repaired_run(std::move(input), boundary_of(flags.level), request, progress);
}

/// Writes the repaired volume, unless the run is a dry one.
void settle(const CommandFlags& flags, std::optional<Volume>& labels, RepairRun& run) {
  compare_with_mesh(run, run.repair.before);
  if (flags.dry_run) return;
  run.output = flags.output;
  change_voxels(run.repair.changes, run.volume);
  if (!labels) return write_repaired(flags, run.repair.changes, run.volume);
  const LabelChanges changes =
      changes_of_labels(run.repair, view(*labels), parse_labels(flags.volume.label));
  if (changes.overwritten > 0)
    add_warning(
        run, "voxels filled that had another label than 0: " + std::to_string(changes.overwritten));
  change_voxels(changes.changes, *labels);
  write_repaired(flags, changes.changes, *labels);
}

void repair(const CommandFlags& flags) {
  repair_request(flags.repair);  // refused before anything is read
  check_together(flags);
  std::optional<Volume> labels;
  RepairRun run;
  OutputFiles outputs(flags.volume.file);
  if (!flags.dry_run) outputs.reserve("--output", flags.output);
  outputs.add("--json", flags.json, report_of(run, write_repair_json));
  check_table_flags(flags.table, outputs.uses_stdout());
  run_and_report<RepairRun>(
      flags.progress, outputs, run,
      {.run = [&](const Progress& progress) { return run_of(flags, labels, progress); },
       .settle = [&](RepairRun& repaired) { settle(flags, labels, repaired); },
       .table =
           [&](std::ostream& out, const RepairRun& repaired) {
             if (flags.table.summary) return write_repair_summary(out, repaired);
             write_repair_table(out, repaired, most_rows(flags.table));
           }});
}

}  // namespace

void add_repair_command(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("repair", "cut handles and fill tunnels, and change nothing else");
  auto flags = std::make_shared<CommandFlags>();
  add_level_flags(command, flags->level);
  add_volume_flags(command, flags->volume);
  // Understood, and refused with a word on why.
  for (const char* flag : {"--crop", "--open-boundary"}) command.get_option(flag)->group("");
  add_repair_flags(command, flags->repair);
  want_file_name(command
                     .add_option("-o,--output", flags->output,
                                 "the repaired volume: FILE with the changed voxels, or anew as " +
                                     written_extensions())
                     ->type_name("FILE"));
  command.add_flag("--dry-run", flags->dry_run, "report, and write no volume");
  want_file_name(
      command.add_option("--json", flags->json, "write the report as JSON; - is standard output")
          ->type_name("FILE|-"));
  add_table_flags(command, flags->table);
  add_thread_flag(command, flags->threads);
  add_progress_flags(command, flags->progress);
  command.footer(
      "Examples:\n"
      "  isoloop repair scan.raw --iso 70 --fill-tunnels 30 -o out_256x256x128_uint8.raw\n"
      "  isoloop repair part.vdb --ids h3,t7 -o repaired.vdb\n"
      "  isoloop repair part.vdb --genus 0 --dry-run");
  command.callback([flags] { on_threads(flags->threads, [&] { repair(*flags); }); });
}

}  // namespace isoloop
