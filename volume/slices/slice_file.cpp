#include "volume/slices/slice_file.h"

#include <string>

#include "core/base/errors.h"
#include "volume/slices/bmp.h"
#include "volume/slices/png.h"
#include "volume/slices/tiff.h"

namespace isoloop {

std::optional<FileKind> slice_kind(const std::filesystem::path& path) {
  if (path.filename().string().starts_with('.')) return std::nullopt;
  const FileFormat* const format = file_format(path);
  if (format == nullptr || !format->is_slice) return std::nullopt;
  return format->kind;
}

SliceImage slice_image(const std::filesystem::path& path) {
  const std::optional<FileKind> kind = slice_kind(path);
  if (kind == FileKind::tiff) return tiff_slice_image(path);
  if (kind == FileKind::png) return png_image(path);
  return bmp_image(path);
}

void read_slice(const std::filesystem::path& path, const VoxelLimits& limits,
                std::span<std::byte> to) {
  const SliceImage image = slice_image(path);
  if (slice_bytes(image, path.string()) != to.size()) {
    throw InvalidInput({.file = path.string(), .text = "changed while it was read; read it again"},
                       Fault::unreadable);
  }
  const std::optional<FileKind> kind = slice_kind(path);
  if (kind == FileKind::tiff) return read_tiff_slice(path, limits, to);
  if (kind == FileKind::png) return read_png(path, limits, to);
  read_bmp(path, to);
}

Volume read_slice_volume(const std::filesystem::path& path, const FormatOptions& options,
                         const VoxelLimits& limits) {
  const std::string what = path.string();
  const SliceImage image = slice_image(path);
  Volume volume;
  volume.dims = {image.width, image.height, 1};
  slice_bytes(image, what);
  check_voxel_memory(volume.dims, bytes_per_voxel(image.type), limits, what);
  place(volume, {}, options.spacing, what);
  if (!options.spacing) {
    volume.notes.push_back({.text = "the file does not state a spacing: 1 is taken",
                            .advice = {Advice::override_spacing}});
  }
  volume.values =
      zero_voxels(image.type, static_cast<std::size_t>(checked_voxel_count(volume.dims, what)));
  std::visit(
      [&](auto& voxels) { read_slice(path, limits, std::as_writable_bytes(std::span(voxels))); },
      volume.values);
  return volume;
}

}  // namespace isoloop
