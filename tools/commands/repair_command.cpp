#include "tools/commands/repair_command.h"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "core/base/threads.h"
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
#include "tools/words/flag_checks.h"
#include "tools/words/progress.h"
#include "volume/base/atomic_file.h"
#include "volume/base/file_kind.h"
#include "volume/files/patch.h"
#include "volume/files/write.h"
#include "volume/formats/raw.h"

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

/// A .raw file says nothing of its voxels but by its name.
void check_raw(const CommandFlags& flags, const Volume& volume) {
  const std::string& output = flags.output;
  if (flags.volume.skip.value_or(0) > 0) {
    throw InvalidArgument("--output " + output +
                          " would lack the header that --skip passes over; name a .nrrd");
  }
  const auto layout = layout_from_name(output);
  if (!layout || (layout->dims == volume.dims && layout->type == voxel_type(volume.values))) return;
  throw InvalidArgument("--output " + output + " would hold " + (volume.mask ? "a mask of " : "") +
                        dims_text(volume.dims) + " " + type_name(volume.values) +
                        " voxels; name it so");
}

/// What a volume that is written anew would lose is refused.
void check_format(const CommandFlags& flags, const Volume& volume) {
  if (is_patched(flags, volume)) return;
  const bool would_change_type = !volume.mask && file_kind(flags.output) != FileKind::vdb &&
                                 extension_of(flags.output) == extension_of(flags.volume.file);
  if (!is_written(flags.output) || would_change_type) {
    throw InvalidArgument(
        "--output " + flags.output + ": a copy of " + flags.volume.file +
        " can be changed only if one file holds header and voxels, one after another, of 32 bits "
        "at most if they are whole numbers, neither scaled nor compressed otherwise than by gzip; "
        "in other formats volumes are written as " +
        written_extensions());
  }
  if (flags.volume.nan_as) {
    throw InvalidArgument("--output " + flags.output +
                          " would hold the value of --nan-as in place of NaN; only a copy of " +
                          flags.volume.file + " in its own format keeps NaN");
  }
  if (file_kind(flags.output) == FileKind::raw) check_raw(flags, volume);
  const bool is_rounded = file_format(flags.output)->written == Written::as_floats &&
                          !volume.mask && voxel_type(volume.values) != VoxelType::float32;
  if (is_rounded) {
    throw InvalidArgument("OpenVDB grids are written as float, which would round the voxels of " +
                          flags.volume.file + "; name an --output of .nrrd");
  }
}

void apply(const Repair& repair, Volume& volume) {
  std::visit(
      [&]<class T>(std::vector<T>& values) {
        for (const VoxelChange& change : repair.changes)
          values[change.voxel] = static_cast<T>(change.after);
      },
      volume.values);
}

void write_repaired(const CommandFlags& flags, const Repair& repair, const Volume& volume) {
  if (!is_patched(flags, volume)) {
    write_volume(volume, flags.output);
    return;
  }
  std::vector<std::size_t> voxels;
  for (const VoxelChange& change : repair.changes) voxels.push_back(change.voxel);
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

RepairRun run_of(const CommandFlags& flags, const Progress& progress) {
  RunInput input = read_run(flags.volume, flags.level);
  const RepairRequest request = repair_request(flags.repair, &input.volume);
  if (!flags.dry_run) check_format(flags, input.volume);
  return repaired_run(std::move(input), boundary_of(flags.level), request, progress);
}

/// Writes the repaired volume, unless the run is a dry one.
void settle(const CommandFlags& flags, RepairRun& run) {
  compare_with_mesh(run, run.repair.before);
  if (flags.dry_run) return;
  apply(run.repair, run.volume);
  run.output = flags.output;
  write_repaired(flags, run.repair, run.volume);
}

void repair(const CommandFlags& flags) {
  repair_request(flags.repair);  // refused before anything is read
  check_together(flags);
  RepairRun run;
  OutputFiles outputs(flags.volume.file);
  if (!flags.dry_run) outputs.reserve("--output", flags.output);
  outputs.add("--json", flags.json, report_of(run, write_repair_json));
  check_table_flags(flags.table, outputs.uses_stdout());
  run_and_report<RepairRun>(
      flags.progress, outputs, run,
      {.run = [&](const Progress& progress) { return run_of(flags, progress); },
       .settle = [&](RepairRun& repaired) { settle(flags, repaired); },
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
  add_repair_flags(command, flags->repair);
  want_file_name(
      command
          .add_option(
              "-o,--output", flags->output,
              "the repaired volume: FILE with the changed voxels, or anew as .nrrd, .raw or .vdb")
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
