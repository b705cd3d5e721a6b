#include "tools/commands/generate_command.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "tools/flags/input_flags.h"
#include "tools/runs/memory_cap.h"
#include "tools/runs/output_files.h"
#include "tools/runs/written_volume.h"
#include "tools/words/flag_checks.h"
#include "tools/words/number_text.h"
#include "volume/base/file_kind.h"
#include "volume/files/write.h"
#include "volume/formats/raw.h"
#include "volume/shapes/shapes.h"

namespace isoloop {
namespace {

struct GenerateFlags {
  std::string shape;
  std::string output;
  std::string max_memory;
  ShapeOptions options;
};

std::string names_text() {
  std::string text;
  for (const std::string& name : shape_names()) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// The flags with which the written file reads back as the solid that was meant.
std::string read_back_flags(const std::filesystem::path& path, const Shape& shape) {
  std::string flags;
  const Volume& volume = shape.volume;
  if (file_kind(path) == FileKind::raw && !layout_from_name(path)) {
    flags += " --dims";
    for (const std::int64_t dim : volume.dims) flags += " " + std::to_string(dim);
    flags += " --type f32";
  }
  return flags + (shape.level.inside == InsideRule::below ? " --inside below" : " --inside above") +
         " --iso " + shortest_text(shape.level.iso);
}

/// The name of a raw file may say what is in it, and is believed when the file is read.
void check_name(const std::filesystem::path& path, const Shape& shape) {
  if (file_kind(path) != FileKind::raw) return;
  const std::optional<RawLayout> named = layout_from_name(path);
  if (!named || (named->dims == shape.volume.dims && named->type == VoxelType::float32)) return;
  throw InvalidArgument(path.string() + ": the name states " + dims_text(named->dims) +
                        " voxels of " + type_name(named->type) + ", but the shape has " +
                        dims_text(shape.volume.dims) + " of float32: take another name");
}

void generate(const GenerateFlags& flags) {
  const std::filesystem::path path(flags.output);
  check_written_format("--output", flags.output);
  check_writable(path);
  ShapeOptions options = flags.options;
  if (!flags.max_memory.empty()) {
    options.max_bytes = parse_bytes(flags.max_memory);
    cap_memory(options.max_bytes);
  }
  Shape shape = make_shape(flags.shape, options);
  if (voxel_type(shape.volume.values) != VoxelType::float32) {
    throw SelfCheckFailed("a shape must be made of float32 voxels");
  }
  check_name(path, shape);
  if (file_kind(path) == FileKind::vdb) clip_to_narrow_band(shape);
  write_volume(shape.volume, path);
  std::cerr << "isoloop: wrote " << flags.output << ", ";
  if (shape.known) {
    std::cerr << "known answer b0 " << shape.known->b0 << ", b1 " << shape.known->b1 << ", b2 "
              << shape.known->b2 << " (components, tunnels, cavities)\n";
  } else {
    std::cerr << "no answer known beforehand\n";
  }
  std::cerr << "isoloop: read it back with: isoloop loops " << flags.output
            << read_back_flags(path, shape) << '\n';
}

void refuse_without_shape(const CLI::App& command, const std::string& flag,
                          const std::string& shape, const std::string& asked) {
  if (command.get_option(flag)->count() == 0 || asked == shape) return;
  throw InvalidArgument(flag + " means nothing for " + asked + ": it is for " + shape);
}

}  // namespace

void add_generate_command(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("generate", "write a solid of known topology");
  auto flags = std::make_shared<GenerateFlags>();
  command.add_option("SHAPE", flags->shape, "one of " + names_text())->required()->type_name("");
  want_whole_number(
      command.add_option("--size", flags->options.size, "voxels along the longest axis")
          ->type_name("N")
          ->capture_default_str(),
      1);
  want_whole_number(command.add_option("--holes", flags->options.holes, "holes through a plate")
                        ->type_name("K")
                        ->capture_default_str(),
                    0, most_holes);
  want_whole_number(
      command.add_option("--cells", flags->options.cells, "cells of a lattice along each axis")
          ->type_name("M")
          ->capture_default_str(),
      1, most_cells);
  add_memory_flag(command, flags->max_memory);
  want_file_name(
      command.add_option("-o,--output", flags->output, "file to write: " + written_extensions())
          ->type_name("FILE")
          ->required());
  command.footer(
      "Examples:\n"
      "  isoloop generate engine_block --size 128 -o block.vdb\n"
      "  isoloop generate plate --size 200 --holes 12 -o plate.raw\n"
      "  isoloop generate lattice --size 128 --cells 4 -o lattice_128x128x128_float32.raw");
  command.callback([flags, &command] {
    refuse_without_shape(command, "--holes", "plate", flags->shape);
    refuse_without_shape(command, "--cells", "lattice", flags->shape);
    generate(*flags);
  });
}

}  // namespace isoloop
