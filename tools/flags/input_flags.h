// The flags that say what to read and where the solid's border runs: the same in every subcommand.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/cube/voxel_sides.h"
#include "core/grid/grid.h"
#include "tools/words/cli_app.h"
#include "volume/files/read.h"

namespace isoloop {

/// What and how to read, as typed.
struct VolumeFlags {
  std::string file;
  std::string dims;                   // "64 64 32" or "64x64x32" voxels; empty: not given
  std::string type;                   // of the voxels, "u8" to "f64"; empty: not given
  std::string endian;                 // "little", "big" or empty: little
  std::optional<std::uint64_t> skip;  // bytes before the first voxel; unset: 0
  std::string spacing;  // one length per voxel, or one for each axis, "0.5mm"; empty: the file's
  std::string grid;     // name of the grid in a .vdb file; empty: the only one
  std::optional<std::int64_t> frame;      // of a 4-D file, from 0
  std::optional<std::int64_t> channel{};  // of a TIFF file, from 0
  std::string series;                     // of DICOM slices: part of its identifier or description
  std::string affine;                     // "sform", "qform" or empty: as NIfTI's standard says
  std::string label;                  // "3" or "3,7": labels that are inside; empty: values count
  std::string world;                  // "ras", "lps" or empty: the file's frame
  std::optional<double> nan_as;       // the value that takes the place of NaN
  std::string max_memory;             // "4G"; empty: what the machine can spare
  std::uint64_t max_voxels = 0;       // 0: no bound of its own
  VoxelSize voxel_size{};             // of a mesh
  std::string crop{};                 // "10:20,:,5:": voxels along x, y and z; empty: all
  const CLI::App* command = nullptr;  // whose flags were parsed in the order typed; may be null
};

/// Where the solid's border runs, as typed.
struct LevelFlags {
  std::string iso;     // "70", or "70 90": between; unit of the voxel values; empty: not given
  std::string inside;  // "above", "below" or empty: as the file suggests
  std::string topology = "trilinear";
  std::string connectivity{};  // of a mask's inside: "6", "18", "26", or empty: as `topology` says
  bool open_boundary = false;
  bool iso_is_open = false;  // where `iso` is empty, a value is settled later
};

/// Adds --max-memory, for parse_bytes(). `size` must outlive the parse.
void add_memory_flag(CLI::App& command, std::string& size);

/// Adds FILE and the flags that describe it. `flags` must outlive the parse.
void add_volume_flags(CLI::App& command, VolumeFlags& flags);

/// The same, the file after --file, which may be left out.
void add_named_volume_flags(CLI::App& command, VolumeFlags& flags);

/// Adds --inside, --topology and --connectivity. `flags` must outlive the parse.
void add_convention_flags(CLI::App& command, LevelFlags& flags);

/// Adds --iso, those of add_convention_flags() and --open-boundary. `flags` must outlive the
/// parse.
void add_level_flags(CLI::App& command, LevelFlags& flags);

/// Throws InvalidArgument naming the flag that makes no sense.
ReadOptions read_options(const VolumeFlags& flags);

/// A level set has the level 0 and its inside below unless the flags say otherwise; a mask has the
/// level 0.5; other volumes have their inside above. `range`: of the volume's values. Throws
/// InvalidArgument if iso is missing, saying what the values suggest, or not finite.
IsoLevel iso_level(const LevelFlags& flags, const Volume& volume, const ValueRange& range);

/// As the flags spell it: "trilinear", "simple", or "6-connected" and the like.
std::string topology_text(Topology topology);

/// How ambiguous faces are decided, in words.
std::string ambiguous_faces_text(Topology topology);

Boundary boundary_of(const LevelFlags& flags);

/// One iso value, or two in ascending order, from "70" or "70 90"; finite. Throws
/// InvalidArgument.
std::vector<double> parse_iso(std::string_view text);

/// Three voxel counts from "64 64 32", "64x64x32" or "64,64,32". Throws InvalidArgument.
Index3 parse_dims(std::string_view text);

/// One length for all axes or three, as above; each positive and finite. Throws InvalidArgument.
Vec3 parse_spacing(std::string_view text);

/// Bytes from "4G", "512M", "1.5GiB", "65536". K, M, G and T are powers of 1024.
/// Throws InvalidArgument.
std::uint64_t parse_bytes(std::string_view text);

/// Ties each flag that takes numbers to the numbers after it: "--dims", "64", "64", "32" become
/// "--dims=64 64 32", so that a FILE after them is not taken for a number, nor "-.5" for a flag.
/// Throws InvalidArgument where another flag or nothing follows.
std::vector<std::string> tie_numbers_to_flags(const std::vector<std::string>& arguments);

}  // namespace isoloop
