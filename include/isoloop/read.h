// Volumes from files, in any format that isoloop reads.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isoloop/grid.h"
#include "isoloop/volume.h"

namespace isoloop {

/// The byte order of stored numbers.
enum class Endian { little, big };

/// Voxel indices along an axis, from `begin` to before `end`.
struct CropRange {
  std::optional<std::int64_t> begin{};  // unset: 0
  std::optional<std::int64_t> end{};    // unset: as many as there are
};

using CropBox = std::array<CropRange, 3>;

/// How a .raw file is laid out.
struct RawOptions {
  std::optional<Index3> dims{};     // voxels along each axis; unset: as the file's name states
  std::optional<VoxelType> type{};  // unset: as the file's name states
  Endian endian = Endian::little;
  std::uint64_t skip = 0;         // bytes before the first voxel
  Vec3 spacing{1.0, 1.0, 1.0};    // length per voxel along each axis
  std::optional<CropBox> crop{};  // voxels to read; unset: all
};

/// Which of a NIfTI header's two maps to the world to use.
enum class NiftiTransform { automatic, sform, qform };

/// What a caller may ask of any format that is not raw or OpenVDB.
struct FormatOptions {
  std::optional<std::int64_t> frame{};    // of a 4-D file, from 0; unset: the file must hold one
  std::optional<std::int64_t> channel{};  // of a TIFF file, from 0; unset: the file must hold one
  std::optional<Vec3> spacing{};  // length per voxel; replaces all that the file says of where
  std::string series{};           // of a folder of DICOM slices: (part of) its identifier
  std::string array{};            // of a .vti file; empty: the active or only one
  NiftiTransform transform = NiftiTransform::automatic;
  std::optional<CropBox> crop{};  // voxels to read, where a format can leave others out
};

/// What surrounds the box of the active voxels: one layer of background, or nothing.
enum class VdbMargin { background, none };

/// How large voxels are: one of the three.
struct VoxelSize {
  std::optional<double> length{};            // of a voxel's edge, unit of the mesh
  std::optional<std::int64_t> resolution{};  // voxels along the mesh's longest side
  bool automatic = false;  // 64, 128, … along it, until voxels and mesh have the same counts
};

/// What to read of a file, and how.
struct ReadOptions {
  RawOptions raw{};  // for .raw files
  std::string
      grid{};  // grid of a .vdb file; NAME[1] of several of one name; empty: the only scalar one
  VdbMargin margin = VdbMargin::background;  // of a .vdb file
  FormatOptions format{};                    // for files of any other kind
  std::vector<std::int64_t> labels{};  // these become 1 and all else 0: a mask; empty: values stay
  std::optional<Frame> world{};  // lps or ras: coordinates are turned to it; unset: the file's own
  std::optional<double> nan_as{};  // takes the place of NaN, in voxel values; unset: NaN is refused
  std::uint64_t max_bytes = 0;     // most bytes of voxels; 0: 80 % of the available memory
  std::uint64_t max_voxels = 0;    // most voxels; 0: no bound of its own
  VoxelSize voxel_size{};          // of a mesh, which must have one
  std::optional<CropBox> crop{};   // voxels to keep, counted as the volume is without; unset: all
};

/// Reads a .raw, .vdb, .nii, .hdr or .img (of a pair; all three also with .gz behind), .nrrd,
/// .nhdr, .mha, .mhd, .npy, .vti, .dcm, .tif, .tiff, .png or .bmp file, a folder of slices, or a
/// mesh (.stl, .ply, .obj, .off) that becomes a level set with voxels of options.voxel_size. Voxels
/// keep their stored type unless the file scales them; the frame is what the file says (`index`: it
/// says nothing, as .raw files). Of a .vdb file the volume is the box of the active voxels and the
/// margin. The result holds no NaN; its notes say how the file was read, its warnings what to look
/// at. With `crop` it is that part: of raw, NIfTI, NRRD, MetaImage and NumPy files (in C order) no
/// other voxels are held in memory. Throws InvalidArgument (options that do not fit the file, such
/// as `crop` for a mesh), LimitExceeded (more voxels than max_bytes allows; before they are asked
/// for), and InvalidInput (a file that is missing, of another kind, damaged, or that holds NaN
/// while nan_as is unset).
Volume read_volume(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace isoloop
