#include "volume/files/read.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "core/base/errors.h"
#include "core/base/memory_budget.h"
#include "volume/base/byte_stream.h"
#include "volume/base/file_kind.h"
#include "volume/formats/dicom.h"
#include "volume/formats/meta_image.h"
#include "volume/formats/nifti.h"
#include "volume/formats/npy.h"
#include "volume/formats/nrrd.h"
#include "volume/formats/raw.h"
#include "volume/formats/vti.h"
#include "volume/mesh/mesh.h"
#include "volume/slices/slice_file.h"
#include "volume/slices/slice_folder.h"
#include "volume/slices/tiff.h"
#include "volume/vdb/vdb.h"
#include "volume/voxelize/voxelize_auto.h"
#include "volume/voxels/labels.h"

namespace isoloop {
namespace {

VoxelLimits limits_of(const ReadOptions& options) {
  return {options.max_bytes, options.max_voxels};
}

bool is_step(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".step" || extension == ".stp" || extension == ".STEP" || extension == ".STP";
}

Volume read_folder(const std::filesystem::path& path, const ReadOptions& options) {
  const VoxelLimits limits = limits_of(options);
  if (holds_dicom(path)) return read_dicom(path, options.format, limits);
  const bool slices = holds_slices(path);
  const bool within = holds_dicom_within(path);
  if (slices && within) {
    throw InvalidInput({.file = path.string(),
                        .text =
                            "holds images itself and DICOM slices in folders within it; give the "
                            "folder of those that are meant"});
  }
  if (slices) return read_slice_folder(path, options.format, limits);
  if (within) return read_dicom(path, options.format, limits);
  throw InvalidInput(
      {.file = path.string(),
       .text = "is a folder without slices that isoloop reads (DICOM, TIFF, PNG or BMP); "
               "it holds " +
               folder_contents(path) + "; give a file: " + supported_extensions()},
      Fault::unsupported);
}

Volume read_mesh_file(const std::filesystem::path& path, const ReadOptions& options) {
  const VoxelLimits limits = limits_of(options);
  if (options.crop) {
    throw InvalidArgument({.file = path.string(),
                           .about = Option::crop,
                           .text = "is for volumes; a mesh is read whole"});
  }
  const Mesh mesh = read_mesh(path, options.max_bytes);
  if (options.voxel_size.automatic) {
    return voxelize_until_counts_agree(mesh, options.voxel_size, limits, path.string());
  }
  return voxelize(mesh, options.voxel_size, limits, path.string());
}

Volume read_by_kind(const std::filesystem::path& path, const ReadOptions& options) {
  const VoxelLimits limits = limits_of(options);
  if (is_mesh(path)) return read_mesh_file(path, options);
  const VoxelSize& size = options.voxel_size;
  if (size.length || size.resolution || size.automatic) {
    throw InvalidArgument({.file = path.string(),
                           .about = Option::voxel_size,
                           .text = "is for meshes: " + mesh_extensions()});
  }
  const std::optional<FileKind> kind = file_kind(path);
  if (!kind) {
    if (is_step(path)) {
      throw InvalidInput({.file = path.string(),
                          .text = "STEP files hold exact solids, which isoloop does not "
                                  "read; export a mesh (.stl) from the CAD program"},
                         Fault::unsupported);
    }
    throw InvalidInput({.file = path.string(),
                        .text = "unknown kind of file; isoloop reads " + supported_extensions() +
                                ", and meshes: " + mesh_extensions()},
                       Fault::unsupported);
  }
  switch (*kind) {
    case FileKind::raw:
      return read_raw(path, options.raw, limits);
    case FileKind::vdb:
      return read_vdb(path, options.grid, limits, options.margin);
    case FileKind::nifti:
      return read_nifti(path, options.format, limits);
    case FileKind::nrrd:
      return read_nrrd(path, options.format, limits);
    case FileKind::meta_image:
      return read_meta_image(path, options.format, limits);
    case FileKind::dicom:
      return read_dicom(path, options.format, limits);
    case FileKind::tiff:
      return read_tiff(path, options.format, limits);
    case FileKind::png:
    case FileKind::bmp:
      return read_slice_volume(path, options.format, limits);
    case FileKind::npy:
      return read_npy(path, options.format, limits);
    case FileKind::vti:
      return read_vti(path, options.format, limits);
    case FileKind::stl:
    case FileKind::ply:
    case FileKind::obj:
    case FileKind::off:
      break;  // read_mesh_file() has them
  }
  throw InvalidInput({.file = path.string(), .text = "unknown kind of file"});
}

/// The part of a volume that was read whole.
Volume part_of(Volume volume, const ReadOptions& options, const std::string& what) {
  const VoxelBox box = voxels_in(*options.crop, volume.dims, what);
  const std::uint64_t voxel_bytes = bytes_per_voxel(voxel_type(volume.values));
  const std::uint64_t bytes = checked_voxel_bytes(volume.dims, voxel_bytes, what) +
                              checked_voxel_bytes(box.dims, voxel_bytes, what);
  const std::uint64_t limit = options.max_bytes == 0 ? default_voxel_limit() : options.max_bytes;
  if (bytes > limit) {
    throw LimitExceeded(
        {.file = what,
         .text = dims_text(volume.dims) + " voxels and the part of them need " + bytes_text(bytes) +
                 ", and the limit is " + bytes_text(limit),
         .advice = {Advice::raise_memory_limit, Advice::take_smaller_volume}},
        {.unit = Excess::Unit::bytes, .needed = bytes, .limit = limit, .stage = "read"});
  }
  return crop(std::move(volume), *options.crop, what);
}

template <class T>
void replace_nan(std::vector<T>& values, double nan_as, const std::string& what) {
  const double most = std::numeric_limits<T>::max();
  if (std::isnan(nan_as) || (std::isfinite(nan_as) && std::abs(nan_as) > most)) {
    throw InvalidArgument({.file = what,
                           .about = Option::nan_value,
                           .text = "must be a number that its voxels can hold"});
  }
  std::replace_if(
      values.begin(), values.end(), [](T value) { return std::isnan(value); },
      static_cast<T>(nan_as));
}

template <class T>
void refuse_nan(const std::vector<T>& values, const Index3& dims, const std::string& what) {
  const auto is_nan = [](T value) { return std::isnan(value); };
  const auto first = std::find_if(values.begin(), values.end(), is_nan);
  if (first == values.end()) return;
  const std::int64_t at = first - values.begin();
  const auto text = [](std::int64_t number) { return std::to_string(number); };
  const std::int64_t count = std::count_if(first, values.end(), is_nan);
  throw InvalidInput(
      {.file = what,
       .place = "voxel (" + text(at % dims[0]) + ", " + text(at / dims[0] % dims[1]) + ", " +
                text(at / (dims[0] * dims[1])) + ")",
       .text = count == 1 ? "NaN" : "NaN, the first of " + text(count),
       .advice = {Advice::replace_nan}},
      Fault::not_finite);
}

}  // namespace

Volume read_volume(const std::filesystem::path& path, const ReadOptions& asked) {
  ReadOptions options = asked;
  options.raw.crop = options.crop;
  options.format.crop = options.crop;
  const bool folder = std::filesystem::is_directory(path);
  if (!folder) check_is_file(path);
  Volume volume = folder ? read_folder(path, options) : read_by_kind(path, options);
  if (options.crop && !volume.part) volume = part_of(std::move(volume), options, path.string());
  std::visit(
      [&]<class T>(std::vector<T>& values) {
        if constexpr (std::is_floating_point_v<T>) {
          if (options.nan_as) {
            replace_nan(values, *options.nan_as, path.string());
          } else {
            refuse_nan(values, volume.dims, path.string());
          }
        }
      },
      volume.values);
  if (!options.labels.empty()) {
    volume = mask_of_labels(std::move(volume), options.labels, path.string());
  }
  if (options.world) turn_frame(volume, *options.world, path.string());
  return volume;
}

}  // namespace isoloop
