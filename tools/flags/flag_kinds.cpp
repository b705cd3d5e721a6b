#include "tools/flags/flag_kinds.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

#include "core/base/errors.h"
#include "volume/base/file_kind.h"
#include "volume/mesh/mesh.h"

namespace isoloop {
namespace {

/// One bit for each kind of input.
using Kinds = std::uint32_t;

constexpr Kinds kind_bit(FileKind kind) { return Kinds{1} << static_cast<unsigned>(kind); }

constexpr Kinds mesh = Kinds{1} << 31U;
constexpr Kinds folder = Kinds{1} << 30U;  // of slices
constexpr Kinds volumes = ~mesh;
constexpr Kinds raw = kind_bit(FileKind::raw);
constexpr Kinds with_grids = kind_bit(FileKind::vdb) | kind_bit(FileKind::vti);
constexpr Kinds with_frames = kind_bit(FileKind::nifti) | kind_bit(FileKind::nrrd) |
                              kind_bit(FileKind::meta_image) | kind_bit(FileKind::dicom) |
                              kind_bit(FileKind::tiff) | kind_bit(FileKind::npy) | folder;

struct Rule {
  std::string_view flag;
  bool (*is_given)(const VolumeFlags&);
  Kinds kinds;
  std::string_view kinds_text;
};

constexpr std::array<Rule, 15> rules{{
    {"--dims", [](const VolumeFlags& f) { return !f.dims.empty(); }, raw, "raw files"},
    {"--type", [](const VolumeFlags& f) { return !f.type.empty(); }, raw, "raw files"},
    {"--endian", [](const VolumeFlags& f) { return !f.endian.empty(); }, raw, "raw files"},
    {"--skip", [](const VolumeFlags& f) { return f.skip.has_value(); }, raw, "raw files"},
    {"--spacing", [](const VolumeFlags& f) { return !f.spacing.empty(); },
     volumes & ~kind_bit(FileKind::vdb),
     "volumes other than .vdb files, whose transforms state it, and meshes, which want --voxel"},
    {"--grid", [](const VolumeFlags& f) { return !f.grid.empty(); }, with_grids,
     ".vdb and .vti files"},
    {"--frame", [](const VolumeFlags& f) { return f.frame.has_value(); }, with_frames,
     "files that may hold several volumes: NIfTI, NRRD, MetaImage, DICOM, TIFF and NumPy"},
    {"--channel", [](const VolumeFlags& f) { return f.channel.has_value(); },
     kind_bit(FileKind::tiff) | folder, "TIFF files"},
    {"--series", [](const VolumeFlags& f) { return !f.series.empty(); },
     kind_bit(FileKind::dicom) | folder, "DICOM slices"},
    {"--affine", [](const VolumeFlags& f) { return !f.affine.empty(); }, kind_bit(FileKind::nifti),
     "NIfTI files"},
    {"--label", [](const VolumeFlags& f) { return !f.label.empty(); }, volumes, "volumes"},
    {"--crop", [](const VolumeFlags& f) { return !f.crop.empty(); }, volumes, "volumes"},
    {"--nan-as", [](const VolumeFlags& f) { return f.nan_as.has_value(); }, volumes, "volumes"},
    {"--voxel", [](const VolumeFlags& f) { return f.voxel_size.length.has_value(); }, mesh,
     "meshes"},
    {"--resolution",
     [](const VolumeFlags& f) { return f.voxel_size.resolution || f.voxel_size.automatic; }, mesh,
     "meshes"},
}};

std::optional<Kinds> kind_of(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return folder;
  if (is_mesh(path)) return mesh;
  const std::optional<FileKind> kind = file_kind(path);
  if (!kind) return std::nullopt;
  return kind_bit(*kind);
}

}  // namespace

void check_flags_fit_file(const VolumeFlags& flags) {
  const std::optional<Kinds> kind = kind_of(flags.file);
  if (!kind) return;
  for (const Rule& rule : rules) {
    if ((rule.kinds & *kind) != 0 || !rule.is_given(flags)) continue;
    throw InvalidArgument(std::string(rule.flag) + " means nothing for " + flags.file +
                          ": it is for " + std::string(rule.kinds_text));
  }
}

void check_flags_agree(const VolumeFlags& volume, const LevelFlags& level) {
  if (volume.label.empty() || level.iso.empty()) return;
  throw InvalidArgument("--iso does not go with --label, which says by itself what is inside");
}

}  // namespace isoloop
