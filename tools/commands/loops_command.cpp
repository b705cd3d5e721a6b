#include "tools/commands/loops_command.h"

#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "tools/flags/engine_flags.h"
#include "tools/flags/length_flag.h"
#include "tools/flags/table_flags.h"
#include "tools/flags/thread_flag.h"
#include "tools/page/page.h"
#include "tools/reports/report_csv.h"
#include "tools/reports/report_curves.h"
#include "tools/reports/report_features.h"
#include "tools/reports/report_json.h"
#include "tools/reports/report_mesh.h"
#include "tools/reports/report_pairs.h"
#include "tools/reports/report_stats.h"
#include "tools/reports/report_summary.h"
#include "tools/reports/report_surface.h"
#include "tools/reports/report_table.h"
#include "tools/runs/loops_run.h"
#include "tools/runs/mesh_comparison.h"
#include "tools/runs/output_files.h"
#include "tools/runs/report_run.h"
#include "tools/runs/written_volume.h"
#include "tools/words/flag_checks.h"
#include "volume/base/file_kind.h"
#include "volume/files/write.h"

namespace isoloop {
namespace {

struct LoopsFlags {
  LoopsInput input;
  ProgressFlags progress;
  std::string json;                  // file, "-" or empty
  std::string csv;                   // file, "-" or empty
  std::string ply;                   // file or empty
  std::string html;                  // file, "-" or empty
  std::vector<std::string> curves;   // files
  std::vector<std::string> surface;  // files
  bool features = false;
  std::optional<double> feature_ratio;
  std::vector<std::string> labels;  // files
  PageOptions page;
  TableFlags table;
  std::string side = "both";
};

LoopFilter filter_of(const LoopsFlags& flags) {
  LoopFilter filter = flags.input.filter;
  filter.handles = flags.side != "tunnel";
  filter.tunnels = flags.side != "handle";
  if (flags.input.level.open_boundary && flags.side != "both") {
    throw InvalidArgument("--side " + flags.side +
                          " does not go with --open-boundary, which tells no sides apart");
  }
  return filter;
}

bool reports_features(const LoopsFlags& flags) {
  return flags.features || flags.feature_ratio || !flags.labels.empty();
}

FeatureOptions feature_options(const LoopsFlags& flags) {
  if (flags.input.level.open_boundary && reports_features(flags)) {
    throw InvalidArgument(
        "--features, --feature-ratio and --labels do not go with --open-boundary");
  }
  FeatureOptions options;
  if (flags.feature_ratio) options.ratio = *flags.feature_ratio;
  if (!(options.ratio >= 1.0) || std::isinf(options.ratio)) {
    throw InvalidArgument("--feature-ratio must be a number from 1 on");
  }
  return options;
}

void add_labels(OutputFiles& outputs, const std::string& name, const LoopsRun& run) {
  check_written_format("--labels", name);
  // OpenVDB takes floats, all of them and in its tree.
  const bool as_floats = file_format(name)->written == Written::as_floats;
  const std::uint64_t writer_bytes_per_voxel = as_floats ? 8 : 0;
  outputs.add("--labels", name, [&run, writer_bytes_per_voxel, name](std::ostream& out) {
    write_volume(out, label_volume(run, writer_bytes_per_voxel), name);
  });
}

/// The reports of `run`, which is yet to be made; the page fills `left_out`.
OutputFiles outputs_of(const LoopsFlags& flags, const LoopsRun& run, LeftOut& left_out) {
  OutputFiles outputs(flags.input.volume.file);
  outputs.add("--json", flags.json, report_of(run, write_json));
  outputs.add("--csv", flags.csv, report_of(run, write_csv));
  outputs.add("--ply", flags.ply, [&run](std::ostream& out) { write_ply(out, run); });
  outputs.add("--html", flags.html,
              [&](std::ostream& out) { left_out = write_page(out, run, flags.page); });
  for (const std::string& name : flags.curves)
    outputs.add("--curves", name, report_of(run, curves_report(name)));
  for (const std::string& name : flags.surface)
    outputs.add("--surface", name, report_of(run, surface_report(name)));
  for (const std::string& name : flags.labels) add_labels(outputs, name, run);
  outputs.add("--dump-pairs", flags.input.engine.dump_pairs, report_of(run, write_pairs));
  return outputs;
}

void find(const LoopsFlags& flags) {
  LoopsInput input = flags.input;
  input.filter = filter_of(flags);
  input.with_scan = !flags.html.empty();
  const FeatureOptions features = feature_options(flags);
  if (reports_features(flags) || !flags.html.empty()) input.features = features;
  input.features_may_lack = !reports_features(flags);
  check_engine_flags(input);
  LoopsRun run;
  LeftOut left_out;
  const OutputFiles outputs = outputs_of(flags, run, left_out);
  check_table_flags(flags.table, outputs.uses_stdout());
  run_and_report<LoopsRun>(flags.progress, outputs, run,
                           {.run =
                                [&](const Progress& progress) {
                                  LoopsRun found = find_run(input, progress);
                                  found.with_features = reports_features(flags);
                                  return found;
                                },
                            .settle =
                                [&](LoopsRun& found) {
                                  compare_with_mesh(found, found.analysis);
                                  for (const std::string& name : flags.labels)
                                    warn_of_left_out(found, name);
                                },
                            .table =
                                [&](std::ostream& out, const LoopsRun& found) {
                                  if (flags.table.summary) return write_loops_summary(out, found);
                                  const std::size_t rows = most_rows(flags.table);
                                  write_table(out, found, rows);
                                  if (found.with_features) write_features(out, found, rows);
                                  const std::string lacks = left_out_text(left_out);
                                  if (!lacks.empty())
                                    out << "page: " << flags.html << lacks << '\n';
                                  if (input.engine.stats) write_stats(out << '\n', found);
                                }});
  if (input.engine.stats && (outputs.uses_stdout() || flags.table.summary))
    write_stats(std::cerr, run);
}

/// A flag that may be repeated, each time with one name.
void add_files(CLI::App& command, const char* flag, std::vector<std::string>& names,
               const std::string& text) {
  want_file_name(command.add_option(flag, names, text)->allow_extra_args(false)->type_name("FILE"));
}

void add_report_flags(CLI::App& command, LoopsFlags& flags) {
  command
      .add_option(
          "--min-size", flags.input.min_size,
          "report loops of this size and more only, in the unit of the spacing or with one (20mm)")
      ->type_name("SIZE");
  command.add_option("--max-size", flags.input.max_size, "report loops of this size and less only")
      ->type_name("SIZE");
  command.add_option("--side", flags.side, "report loops of this kind only")
      ->check(CLI::IsMember({"handle", "tunnel", "both"}))
      ->type_name("KIND")
      ->capture_default_str();
  const auto add_output = [&](const char* flag, std::string& name, const char* text,
                              const char* type) {
    want_file_name(command.add_option(flag, name, text)->type_name(type));
  };
  add_output("--json", flags.json, "write counts and loops as JSON; - is standard output",
             "FILE|-");
  add_output("--csv", flags.csv, "write one line for each loop; - is standard output", "FILE|-");
  add_output("--ply", flags.ply,
             "write the surface as a mesh, handle loops green, tunnel loops red, loops of neither "
             "kind blue",
             "FILE");
  add_output("--html", flags.html, "write a page to look at; - is standard output", "FILE|-");
  add_page_flags(command, flags.page);
  add_table_flags(command, flags.table);
  add_files(command, "--curves", flags.curves,
            "write the loops as curves: .vtp, .obj or .mrk.json (3D Slicer); may be repeated");
  add_files(command, "--surface", flags.surface,
            "write the surface alone: .ply, .obj, .stl or .vtp; may be repeated");
}

void add_feature_flags(CLI::App& command, LoopsFlags& flags) {
  command.add_flag(
      "--features", flags.features,
      "report how far each handle and tunnel extends, and label its vertices in --ply");
  command
      .add_option("--feature-ratio", flags.feature_ratio,
                  "a feature ends where its girth exceeds this times its loop's length (default "
                  "1.5: half a radius beyond the mouth of a bore)")
      ->type_name("RATIO");
  add_files(command, "--labels", flags.labels,
            "write a volume with the labels of the features: " + written_extensions() +
                "; may be repeated");
}

}  // namespace

void add_loops_command(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("loops", "find, prove and measure every handle loop and tunnel loop");
  auto flags = std::make_shared<LoopsFlags>();
  add_level_flags(command, flags->input.level);
  add_volume_flags(command, flags->input.volume);
  add_geodesic_flag(command, flags->input.geodesic);
  add_thread_flag(command, flags->input.threads);
  add_engine_flags(command, flags->input.engine);
  add_report_flags(command, *flags);
  add_feature_flags(command, *flags);
  add_progress_flags(command, flags->progress);
  command.footer(
      "Examples:\n"
      "  isoloop loops engine_256x256x128_uint8.raw --iso 70 --ply loops.ply\n"
      "  isoloop loops part.vdb --side tunnel --features --labels labels.nrrd --csv holes.csv\n"
      "  isoloop loops scan.raw --dims 512 512 300 --type i16 --iso 400 --json - > loops.json");
  command.callback([flags, &command] {
    if (command.get_option("--triangles")->count() > 0 && flags->html.empty())
      throw InvalidArgument("--triangles means nothing without --html, whose page it is for");
    find(*flags);
  });
}

}  // namespace isoloop
