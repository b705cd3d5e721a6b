#include "tools/commands/info_command.h"

#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "core/base/memory_budget.h"
#include "tools/commands/typed_words.h"
#include "tools/flags/input_flags.h"
#include "tools/reports/report_table.h"
#include "tools/runs/mesh_comparison.h"
#include "tools/runs/output_files.h"
#include "tools/runs/read_run.h"
#include "tools/words/number_text.h"
#include "tools/words/sentence.h"
#include "tools/words/text_rows.h"
#include "tools/words/value_hints.h"
#include "volume/base/memory_limit.h"
#include "volume/formats/dicom.h"

namespace isoloop {
namespace {

std::string vector_text(const Vec3& v) {
  return shortest_text(v[0]) + " " + shortest_text(v[1]) + " " + shortest_text(v[2]);
}

// Rows of the map from voxel indices to the world.
std::string affine_text(const Volume& volume) {
  std::string text;
  for (std::size_t row = 0; row < 3; ++row) {
    text += row == 0 ? "" : ", ";
    for (std::size_t axis = 0; axis < 3; ++axis) {
      text += shortest_text(volume.direction[axis][row] * volume.spacing[axis]) + " ";
    }
    text += shortest_text(volume.origin[row]);
  }
  return text;
}

}  // namespace

void write_info(std::ostream& out, const VolumeFlags& flags, const Volume& volume) {
  const std::string& file = flags.file;
  const ValueRange range = value_range(volume);
  const std::uint64_t voxels = checked_voxel_count(volume.dims, file);
  out << "file       " << file << '\n';
  if (!volume.name.empty()) out << "grid       " << volume.name << '\n';
  out << "dims       " << dims_text(volume.dims) << "  (" << voxels << " voxels, "
      << bytes_text(voxels * bytes_per_voxel(voxel_type(volume.values))) << ")\n"
      << (volume.part ? "part       " + part_text(volume, *volume.part) + "\n" : "")
      << "type       " << type_name(volume.values) << '\n'
      << "values     " << shortest_text(range.min) << " to " << shortest_text(range.max) << '\n'
      << "spacing    " << vector_text(volume.spacing) << '\n'
      << (volume.unit.empty() ? "" : "unit       " + volume.unit + "\n") << "origin     "
      << vector_text(volume.origin) << '\n'
      << "direction  " << vector_text(volume.direction[0]) << ", "
      << vector_text(volume.direction[1]) << ", " << vector_text(volume.direction[2]) << '\n'
      << "frame      " << frame_name(volume.frame) << '\n'
      << "affine     " << affine_text(volume) << '\n'
      << "level set  "
      << (volume.level_set ? "yes: --iso 0 --inside below unless stated otherwise"
          : volume.mask    ? "no, a mask: --iso 0.5 --inside above unless stated otherwise"
                           : "no: --iso must be stated, --inside is above unless stated otherwise")
      << '\n';
  if (volume.mesh) out << "mesh       " << mesh_text(*volume.mesh) << '\n';
  for (const std::string& note : sentences_of(volume.notes)) out << "note       " << note << '\n';
  if (is_mask(range) && !volume.level_set && flags.label.empty()) {
    out << "note       " << mask_hint(range) << '\n';
  }
}

bool write_series(std::ostream& out, const VolumeFlags& flags, const InvalidArgument& error,
                  const std::string& command) {
  if (error.option != Option::series || !flags.series.empty()) return false;
  const std::vector<DicomSeries> series = dicom_series(flags.file);
  out << flags.file << ": " << counted(static_cast<std::int64_t>(series.size()), "series", "series")
      << " of DICOM slices\n\n";
  std::vector<Row<3>> rows{{"slices", "description", "command"}};
  for (const DicomSeries& one : series)
    rows.push_back(
        {std::to_string(one.slices), one.description, command + " --series " + shell_word(one.id)});
  write_rows(out, rows, {false, true, true});
  return true;
}

void add_info_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("info", "print what a volume is: size, type, values");
  auto flags = std::make_shared<VolumeFlags>();
  add_volume_flags(command, *flags);
  command.footer(
      "Examples:\n"
      "  isoloop info engine_256x256x128_uint8.raw\n"
      "  isoloop info scan.raw --dims 512 512 300 --type i16 --spacing 0.4 0.4 0.8\n"
      "  isoloop info cells.ome.tif --channel 1");
  command.callback([flags] {
    RunInput run;
    try {
      run = read_input(*flags);
    } catch (const InvalidArgument& error) {
      if (!write_series(std::cout, *flags, error, "isoloop info " + shell_word(flags->file))) throw;
      finish_stdout();
      return;
    }
    tell_warnings(std::cerr, run);
    write_info(std::cout, *flags, run.volume);
    finish_stdout();
  });
}

}  // namespace isoloop
