// A volume in memory: voxels in their stored type, and where they lie in the world. Volumes to
// files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "isoloop/finding.h"
#include "isoloop/grid.h"
#include "isoloop/surface.h"

namespace isoloop {

/// Voxel values, first axis fastest, one alternative for each type of AnyGridView, in its order.
using VoxelArray =
    std::variant<std::vector<std::uint8_t>, std::vector<std::int8_t>, std::vector<std::uint16_t>,
                 std::vector<std::int16_t>, std::vector<std::uint32_t>, std::vector<std::int32_t>,
                 std::vector<float>, std::vector<double>>;

/// Names of the alternatives of VoxelArray, in its order.
enum class VoxelType { uint8, int8, uint16, int16, uint32, int32, float32, float64 };

/// What the world coordinates mean. `index`: the file has no frame, world = index * spacing.
enum class Frame { index, world, lps, ras };

/// Where a file holds voxels one after another, each as it is in memory but for the byte order.
struct StoredAt {
  std::filesystem::path file{};
  std::uint64_t first = 0;   // byte of the file: what follows is one stream up to its end
  bool packed = false;       // by gzip
  std::uint64_t offset = 0;  // bytes of the stream, unpacked, before the first voxel
  std::uint64_t size = 0;    // bytes of the stream, unpacked
  bool swapped = false;      // in the byte order that is not this machine's
};

/// Which of the file's voxels a volume holds: those from `first` on, of `whole` along each axis.
struct VolumePart {
  Index3 first{};
  Index3 whole{};
};

/// What a mesh says of its solid before any voxel is.
struct MeshCounts {
  std::size_t triangles = 0;
  std::size_t shells = 0;        // closed surfaces that it consists of; 0 unless `betti` is set
  std::size_t swallowed = 0;     // shells with solid on both their sides: they bound nothing
  std::optional<Betti> betti{};  // of the solid, exactly
  std::string unknown{};         // why `betti` is unset, as in "it is open"; else empty
  /// From a corner of one shell to a triangle of another, unit of the mesh; unset: farther than was
  /// looked, or one shell. Where edges pass each other shells may be nearer still.
  std::optional<double> gap{};
  std::optional<Betti> voxels{};  // where they were counted to find their size: those of the volume
};

/// Voxels with all that is known of where they lie and come from.
struct Volume {
  VoxelArray values{};
  Index3 dims{};                // voxels along each axis, each at least 1
  Vec3 spacing{1.0, 1.0, 1.0};  // length per voxel along each index axis
  std::string unit{};           // of the spacing: "mm", "µm" and the like; empty: not stated
  Vec3 origin{0.0, 0.0, 0.0};   // world position of the centre of voxel (0, 0, 0)
  // direction[a]: unit world vector along index axis a
  std::array<Vec3, 3> direction{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Frame frame = Frame::index;
  bool level_set = false;               // a signed distance: inside is below, iso defaults to 0
  bool mask = false;                    // 0 is outside, 1 and above inside: iso defaults to 0.5
  std::string name{};                   // of the grid within the file; empty where files hold one
  std::optional<StoredAt> stored_at{};  // unset where the file holds the voxels in another way
  std::filesystem::path data_file{};    // where the voxels lie apart from their header; else empty
  std::optional<VolumePart> part{};     // unset: all voxels of the file
  std::optional<MeshCounts> mesh{};     // of the mesh that was voxelised; unset: it was none
  std::vector<Finding> notes{};         // what was read how; a sentence each
  std::vector<Finding> warnings{};      // what a user should look at; a sentence each
};

/// The voxels as count(), find_loops(), scan() and repair() take them. Valid while `volume` lives
/// and keeps its values.
AnyGridView view(const Volume& volume);

/// World position of a point given in (fractional) voxel indices.
Vec3 to_world(const Volume& volume, const Vec3& index);

/// The points of curves, given in voxel indices, in the world.
std::vector<std::vector<Vec3>> to_world(const Volume& volume,
                                        std::vector<std::vector<Vec3>> curves);

/// Whether the index axes are left-handed in the world, so that triangles turn over on the way.
bool frame_mirrors(const Volume& volume);

/// The alternative that `values` holds.
VoxelType voxel_type(const VoxelArray& values);

/// 1, 2, 4 or 8.
std::uint64_t bytes_per_voxel(VoxelType type);

/// "uint8", "float32", …: the name of the stored voxel type.
std::string type_name(VoxelType type);
std::string type_name(const VoxelArray& values);

/// "index", "world", "LPS" or "RAS".
std::string frame_name(Frame frame);

/// Reads "uint8" or "u8", "float32" or "f32", … ; nothing if `name` is none of them.
std::optional<VoxelType> parse_voxel_type(std::string_view name);

/// Writes a .raw file (voxels in their stored type, little-endian, first axis fastest; a name such
/// as engine_256x256x128_uint8.raw lets it be read without options), a .nrrd, .nii, .nii.gz, .mha,
/// .npy or .vti file (with what the format can say of the place), or a .vdb file (values become
/// float32; a level set's background is its largest value, any other grid's its smallest). The
/// file appears whole or not at all.
/// Throws InvalidArgument (another extension; an axis too long for .nii) and InvalidInput (it
/// cannot be written).
void write_volume(const Volume& volume, const std::filesystem::path& path);

/// Unit of the voxel values.
struct ValueRange {
  double min = 0.0;
  double max = 0.0;
  std::vector<double> distinct{};  // all, ascending; empty if they are more than most_distinct
};

inline constexpr std::size_t most_distinct = 32;

/// The voxel values in one pass; NaN is passed over. {0, 0, {}} if no value is left.
ValueRange value_range(const Volume& volume);

}  // namespace isoloop
