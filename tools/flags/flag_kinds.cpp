#include "tools/flags/flag_kinds.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "volume/base/file_kind.h"

namespace isoloop {
namespace {

struct Rule {
  std::string_view flag;
  bool (*is_given)(const VolumeFlags&);
  Option option;  // of the table of formats, where what a format takes stands
  std::string_view kinds_text;
};

constexpr std::array<Rule, 15> rules{{
    {"--dims", [](const VolumeFlags& f) { return !f.dims.empty(); }, Option::dims, "raw files"},
    {"--type", [](const VolumeFlags& f) { return !f.type.empty(); }, Option::voxel_type,
     "raw files"},
    {"--endian", [](const VolumeFlags& f) { return !f.endian.empty(); }, Option::dims, "raw files"},
    {"--skip", [](const VolumeFlags& f) { return f.skip.has_value(); }, Option::dims, "raw files"},
    {"--spacing", [](const VolumeFlags& f) { return !f.spacing.empty(); }, Option::spacing,
     "volumes other than .vdb files, whose transforms state it, and meshes, which want --voxel"},
    {"--grid", [](const VolumeFlags& f) { return !f.grid.empty(); }, Option::grid,
     ".vdb and .vti files"},
    {"--frame", [](const VolumeFlags& f) { return f.frame.has_value(); }, Option::frame,
     "files that may hold several volumes: NIfTI, NRRD, MetaImage, DICOM, TIFF and NumPy"},
    {"--channel", [](const VolumeFlags& f) { return f.channel.has_value(); }, Option::channel,
     "TIFF files"},
    {"--series", [](const VolumeFlags& f) { return !f.series.empty(); }, Option::series,
     "DICOM slices"},
    {"--affine", [](const VolumeFlags& f) { return !f.affine.empty(); }, Option::transform,
     "NIfTI files"},
    {"--label", [](const VolumeFlags& f) { return !f.label.empty(); }, Option::labels, "volumes"},
    {"--crop", [](const VolumeFlags& f) { return !f.crop.empty(); }, Option::crop, "volumes"},
    {"--nan-as", [](const VolumeFlags& f) { return f.nan_as.has_value(); }, Option::nan_value,
     "volumes"},
    {"--voxel", [](const VolumeFlags& f) { return f.voxel_size.length.has_value(); },
     Option::voxel_size, "meshes"},
    {"--resolution",
     [](const VolumeFlags& f) { return f.voxel_size.resolution || f.voxel_size.automatic; },
     Option::voxel_size, "meshes"},
}};

/// Whether the option means something for what the path names; so too where nothing is known of it.
bool may_take(const std::filesystem::path& path, Option option) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return folders_take_option(option);
  const FileFormat* const format = file_format(path);
  return format == nullptr || takes_option(*format, option);
}

/// Where the flag stands among those typed; behind all of them if it is not known.
std::size_t place_of(std::string_view flag, const VolumeFlags& flags) {
  if (flags.command == nullptr) return 0;
  const auto& typed = flags.command->parse_order();
  const auto is_it = [flag](const CLI::Option* option) {
    return option->check_name(std::string(flag));
  };
  return static_cast<std::size_t>(std::find_if(typed.begin(), typed.end(), is_it) - typed.begin());
}

}  // namespace

void check_flags_fit_file(const VolumeFlags& flags) {
  const Rule* first = nullptr;
  for (const Rule& rule : rules) {
    if (!rule.is_given(flags) || may_take(flags.file, rule.option)) continue;
    if (first == nullptr || place_of(rule.flag, flags) < place_of(first->flag, flags))
      first = &rule;
  }
  if (first == nullptr) return;
  throw InvalidArgument(std::string(first->flag) + " means nothing for " + flags.file +
                        ": it is for " + std::string(first->kinds_text));
}

void check_flags_agree(const VolumeFlags& volume, const LevelFlags& level) {
  if (volume.label.empty()) return;
  for (const auto& [flag, value] : {std::pair{"--iso", level.iso}, {"--inside", level.inside}}) {
    if (value.empty()) continue;
    if (place_of("--label", volume) < place_of(flag, volume))
      throw InvalidArgument(std::string("--label does not go with ") + flag +
                            ": a label says by itself what is inside");
    throw InvalidArgument(std::string(flag) +
                          " does not go with --label, which says by itself what is inside");
  }
}

}  // namespace isoloop
