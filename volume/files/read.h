// Volumes from files, in any format that isoloop reads.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "volume/formats/raw.h"
#include "volume/vdb/vdb.h"
#include "volume/voxelize/voxelize.h"
#include "volume/voxels/placement.h"
#include "volume/voxels/volume.h"

namespace isoloop {

struct ReadOptions {
  RawOptions raw{};    // for .raw files
  std::string grid{};  // grid of a .vdb file, see read_vdb; empty: the only scalar one
  VdbMargin margin = VdbMargin::background;  // of a .vdb file
  FormatOptions format{};                    // for files of any other kind
  std::vector<std::int64_t>
      labels{};                  // these become a mask, see mask_of_labels; empty: values stay
  std::optional<Frame> world{};  // lps or ras: coordinates are turned to it; unset: the file's own
  std::optional<double> nan_as{};  // takes the place of NaN, in voxel values; unset: NaN is refused
  std::uint64_t max_bytes = 0;     // most bytes of voxels; 0: 80 % of the available memory
  std::uint64_t max_voxels = 0;    // most voxels; 0: no bound of its own
  VoxelSize voxel_size{};          // of a mesh, see voxelize and voxelize_until_counts_agree
  std::optional<CropBox> crop{};   // voxels to keep, counted as the volume is without; unset: all
};

/// Reads a file of any kind that it knows, a folder of slices, or a mesh that it voxelises; see
/// read_raw, read_vdb, read_dicom, read_slice_folder and voxelize for shape and frame. The result
/// holds no NaN. With `crop` it is that part, see crop(): of raw, NIfTI, NRRD, MetaImage and NumPy
/// files (in C order) no other voxels are held in memory, of other files all are. Throws
/// InvalidArgument (options that do not fit the file, such as `crop` for a mesh), LimitExceeded
/// (more voxels than max_bytes allows; before they are asked for), and InvalidInput (a file that is
/// missing, of another kind, damaged, or that holds NaN while nan_as is unset).
Volume read_volume(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace isoloop
