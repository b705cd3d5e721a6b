#include "tools/flags/input_flags.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "tools/flags/flag_lists.h"
#include "tools/flags/length_flag.h"
#include "tools/words/flag_checks.h"
#include "tools/words/value_hints.h"
#include "volume/base/file_kind.h"
#include "volume/base/header_text.h"
#include "volume/mesh/mesh.h"

namespace isoloop {
namespace {

// How many numbers may follow a flag.
std::size_t numbers_after(std::string_view flag) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 12> counts{{{"--dims", 3},
                                                                             {"--frame", 1},
                                                                             {"--channel", 1},
                                                                             {"--label", 1},
                                                                             {"--spacing", 3},
                                                                             {"--iso", 2},
                                                                             {"--nan-as", 1},
                                                                             {"--min-size", 1},
                                                                             {"--max-size", 1},
                                                                             {"--values", 1},
                                                                             {"--from", 1},
                                                                             {"--to", 1}}};
  for (const auto& [name, count] : counts) {
    if (flag == name) return count;
  }
  return 0;
}

/// " .stl .ply ...".
std::string mesh_words() {
  std::string words;
  for (const FileFormat& format : file_formats()) {
    if (format.is_mesh) words.append(" ").append(format.extensions[0]);
  }
  return words;
}

CLI::Option& add_file(CLI::App& command, const char* name, VolumeFlags& flags) {
  CLI::Option* const option = command.add_option(
      name, flags.file,
      "volume to read: " + supported_extensions() +
          ", or a folder of DICOM, TIFF, PNG or BMP slices; or mesh:" + mesh_words());
  want_file_name(option);
  return *option;
}

void check_volume_flags(CLI::App& command) {
  for (const char* flag :
       {"--dims", "--type", "--spacing", "--grid", "--series", "--label", "--crop", "--nan-as"}) {
    want_text(command.get_option(flag));
  }
  for (const char* flag : {"--skip", "--frame", "--channel"})
    want_whole_number(command.get_option(flag), 0);
  want_whole_number(command.get_option("--max-voxels"), 1);
  want_whole_number_or(command.get_option("--resolution"), 1, "auto");
  want_positive_number(command.get_option("--voxel"));
}

void take_resolution(const std::string& typed, VolumeFlags& flags) {
  flags.voxel_size.automatic = typed == "auto";
  flags.voxel_size.resolution = whole_number_of(typed);  // none of the word
}

void add_description_flags(CLI::App& command, VolumeFlags& flags) {
  flags.command = &command;
  command.add_option("--dims", flags.dims, "voxels along x, y and z of a raw file")
      ->type_name("X Y Z");
  command
      .add_option("--type", flags.type,
                  "voxel type of a raw file: u8 i8 u16 i16 u32 i32 f32 f64, or uint8 ... float64")
      ->type_name("TYPE");
  command.add_option("--endian", flags.endian, "byte order of a raw file (default little)")
      ->check(CLI::IsMember({"little", "big"}))
      ->type_name("ORDER");
  command.add_option("--skip", flags.skip, "bytes before the first voxel of a raw file")
      ->type_name("BYTES");
  command
      .add_option("--spacing", flags.spacing,
                  "length per voxel: one number, or one for each axis, a unit may follow (0.5mm); "
                  "replaces what the file says of its place (not of a .vdb file)")
      ->type_name("S | X Y Z");
  command
      .add_option("--grid", flags.grid,
                  "name of the grid in a .vdb file, of the array of points or cells in a .vti file")
      ->type_name("NAME");
  command.add_option("--frame", flags.frame, "which volume of a 4-D file, counted from 0")
      ->type_name("N");
  command.add_option("--channel", flags.channel, "which channel of a TIFF file, counted from 0")
      ->type_name("N");
  command
      .add_option("--series", flags.series,
                  "which series of a folder of DICOM slices: part of its identifier, number or "
                  "description")
      ->type_name("TEXT");
  command
      .add_option("--label", flags.label,
                  "these labels of a label map are inside, all other voxels outside")
      ->type_name("N[,M...]");
  command
      .add_option(
          "--crop", flags.crop,
          "read this part alone: voxels along x, y and z, counted from 0, up to but without "
          "the second number; 10:20,:,5: takes all along y")
      ->type_name("X:X,Y:Y,Z:Z");
  command
      .add_option("--affine", flags.affine,
                  "which of a NIfTI file's maps to the world to use (default sform, then qform)")
      ->check(CLI::IsMember({"sform", "qform"}))
      ->type_name("WHICH");
  command
      .add_option("--world", flags.world,
                  "frame of world coordinates: ras or lps; default the file's own")
      ->check(CLI::IsMember({"ras", "lps"}))
      ->type_name("FRAME");
  command
      .add_option("--voxel", flags.voxel_size.length,
                  "length of the voxels that a mesh is turned into, in its unit")
      ->type_name("LENGTH");
  command
      .add_option_function<std::string>(
          "--resolution", [&flags](const std::string& typed) { take_resolution(typed, flags); },
          "in place of --voxel: how many voxels lie along the mesh's longest side; auto, the "
          "default, doubles them from 64 on until they have the components, tunnels and cavities "
          "of the mesh, up to 1024 cubed in all, or 256 cubed where auto is not asked for")
      ->type_name("VOXELS|auto");
  command
      .add_option("--nan-as", flags.nan_as, "read NaN voxels as this value; else they are refused")
      ->type_name("VALUE");
  add_memory_flag(command, flags.max_memory);
  command
      .add_option("--max-voxels", flags.max_voxels,
                  "give up, exit code 4, on a volume of more voxels")
      ->type_name("N");
  check_volume_flags(command);
}

}  // namespace

void add_memory_flag(CLI::App& command, std::string& size) {
  want_text(command
                .add_option("--max-memory", size,
                            "give up, exit code 4, rather than use more, for example 4G (default: "
                            "80 % of what is free)")
                ->type_name("SIZE"));
}

void add_volume_flags(CLI::App& command, VolumeFlags& flags) {
  add_file(command, "FILE", flags).required()->type_name("");
  add_description_flags(command, flags);
}

void add_named_volume_flags(CLI::App& command, VolumeFlags& flags) {
  add_file(command, "--file", flags).type_name("FILE");
  add_description_flags(command, flags);
}

void add_convention_flags(CLI::App& command, LevelFlags& flags) {
  command
      .add_option(
          "--inside", flags.inside,
          "which values are inside: above is f >= iso (default), below is f <= iso (default "
          "for a level set)")
      ->check(CLI::IsMember({"above", "below"}))
      ->type_name("RULE");
  command
      .add_option("--topology", flags.topology,
                  "of the surface within cubes: trilinear is that of the trilinear interpolant, "
                  "tunnels within cubes included; simple makes every part of a cube a ball")
      ->check(CLI::IsMember({"trilinear", "simple"}))
      ->type_name("WHICH")
      ->capture_default_str();
  command
      .add_option("--connectivity", flags.connectivity,
                  "of a mask, in place of --topology: inside voxels are joined across faces (6), "
                  "edges too (18) or corners too (26), whatever their values")
      ->check(CLI::IsMember({"6", "18", "26"}))
      ->type_name("N")
      ->excludes("--topology");
}

void add_level_flags(CLI::App& command, LevelFlags& flags) {
  command
      .add_option(
          "--iso", flags.iso,
          "value of the iso-surface; two: inside is between them; auto: what scan proposes; a "
          "level set has 0 by default")
      ->type_name("VALUE [UPPER]|auto");
  want_text(command.get_option("--iso"));
  add_convention_flags(command, flags);
  command.add_flag("--open-boundary", flags.open_boundary,
                   "end the surface at the border of the volume instead of closing it there; its "
                   "sides are not told apart");
}

ReadOptions read_options(const VolumeFlags& flags) {
  ReadOptions options;
  if (!flags.dims.empty()) options.raw.dims = parse_dims(flags.dims);
  if (!flags.type.empty()) {
    options.raw.type = parse_voxel_type(flags.type);
    if (!options.raw.type) {
      throw InvalidArgument("--type " + flags.type +
                            " is no voxel type; one of u8 i8 u16 i16 u32 i32 f32 f64 is");
    }
  }
  options.raw.endian = flags.endian == "big" ? Endian::big : Endian::little;
  options.raw.skip = flags.skip.value_or(0);
  if (!flags.spacing.empty()) {
    options.format.spacing = parse_spacing(split_unit("--spacing", flags.spacing).text);
    options.raw.spacing = *options.format.spacing;
  }
  options.format.frame = flags.frame;
  options.format.channel = flags.channel;
  options.format.series = flags.series;
  if (flags.affine == "sform") options.format.transform = NiftiTransform::sform;
  if (flags.affine == "qform") options.format.transform = NiftiTransform::qform;
  if (!flags.label.empty()) options.labels = parse_labels(flags.label);
  if (!flags.crop.empty()) options.crop = parse_crop(flags.crop);
  if (flags.world == "ras") options.world = Frame::ras;
  if (flags.world == "lps") options.world = Frame::lps;
  options.grid = flags.grid;
  options.format.array = flags.grid;
  options.nan_as = flags.nan_as;
  if (flags.nan_as && std::isnan(*flags.nan_as)) {
    throw InvalidArgument("--nan-as wants a number to stand in for NaN");
  }
  options.max_voxels = flags.max_voxels;
  options.voxel_size = flags.voxel_size;
  if (!flags.voxel_size.length && !flags.voxel_size.resolution && is_mesh(flags.file)) {
    constexpr std::uint64_t most_by_itself = 256ULL * 256 * 256;  // seconds, not minutes
    if (!flags.voxel_size.automatic && options.max_voxels == 0) options.max_voxels = most_by_itself;
    options.voxel_size.automatic = true;
  }
  if (!flags.max_memory.empty()) options.max_bytes = parse_bytes(flags.max_memory);
  return options;
}

IsoLevel iso_level(const LevelFlags& flags, const Volume& volume, const ValueRange& range) {
  IsoLevel level;
  if (!flags.iso.empty()) {
    const std::vector<double> values = parse_iso(flags.iso);
    level.iso = values[0];
    if (values.size() == 2) level.upper = values[1];
  } else if (volume.mask) {
    level.iso = 0.5;
  } else if (!volume.level_set && !flags.iso_is_open) {
    throw InvalidArgument("--iso is required: the file is no level set; " + values_text(range) +
                          "; --iso auto takes what isoloop scan proposes");
  }
  if (level.upper && !flags.inside.empty()) {
    throw InvalidArgument("--inside does not go with two iso values, between which the inside is");
  }
  const bool below =
      flags.inside.empty() ? volume.level_set && !level.upper : flags.inside == "below";
  level.inside = below ? InsideRule::below : InsideRule::above;
  level.topology = flags.topology == "simple" ? Topology::simple : Topology::trilinear;
  if (flags.connectivity == "6") level.topology = Topology::connected_6;
  if (flags.connectivity == "18") level.topology = Topology::connected_18;
  if (flags.connectivity == "26") level.topology = Topology::connected_26;
  return level;
}

std::string topology_text(Topology topology) {
  switch (topology) {
    case Topology::trilinear:
      return "trilinear";
    case Topology::simple:
      return "simple";
    case Topology::connected_6:
      return "6-connected";
    case Topology::connected_18:
      return "18-connected";
    case Topology::connected_26:
      return "26-connected";
  }
  return "trilinear";
}

std::string ambiguous_faces_text(Topology topology) {
  if (topology == Topology::trilinear || topology == Topology::simple) {
    return "asymptotic decider; a saddle at the iso value is outside";
  }
  return topology == Topology::connected_6 ? "outside joined" : "inside joined";
}

Boundary boundary_of(const LevelFlags& flags) {
  return flags.open_boundary ? Boundary::open : Boundary::closed;
}

std::vector<double> parse_iso(std::string_view text) {
  const std::string complaint =
      "--iso " + std::string(text) +
      " does not state a finite number, or two of which the second is the larger";
  // No comma parts them: in many countries it is the decimal sign.
  const std::vector<double> values = parse_list<double>(text, "", complaint);
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (values.empty() || values.size() > 2 || values.front() > values.back() ||
      !std::all_of(values.begin(), values.end(), is_finite)) {
    throw InvalidArgument(complaint);
  }
  return values;
}

Index3 parse_dims(std::string_view text) {
  const std::string complaint =
      "--dims " + std::string(text) + " does not state three voxel counts, as in --dims 64 64 32";
  const std::vector<std::int64_t> dims = parse_list<std::int64_t>(text, ",xX", complaint);
  const bool positive = std::all_of(dims.begin(), dims.end(), [](std::int64_t n) { return n > 0; });
  if (dims.size() != 3 || !positive) throw InvalidArgument(complaint);
  return {dims[0], dims[1], dims[2]};
}

Vec3 parse_spacing(std::string_view text) {
  const std::string complaint = "--spacing " + std::string(text) +
                                " does not state one or three lengths between 1e-18 and 1e18, as "
                                "in --spacing 0.5 0.5 1.2";
  const std::vector<double> lengths = parse_list<double>(text, ",xX", complaint);
  if (!std::all_of(lengths.begin(), lengths.end(), is_spacing)) throw InvalidArgument(complaint);
  if (lengths.size() == 1) return {lengths[0], lengths[0], lengths[0]};
  if (lengths.size() != 3) throw InvalidArgument(complaint);
  return {lengths[0], lengths[1], lengths[2]};
}

std::uint64_t parse_bytes(std::string_view text) {
  const std::string complaint =
      "--max-memory " + std::string(text) + " is no size, as 512M and 4G are";
  constexpr std::string_view units = "KMGT";
  std::string_view digits = text;
  double factor = 1.0;
  if (digits.ends_with("iB")) {
    digits.remove_suffix(2);
  } else if (digits.ends_with('B')) {
    digits.remove_suffix(1);
  }
  if (!digits.empty()) {
    const char letter = digits.back() == 'k' ? 'K' : digits.back();
    if (const std::size_t unit = units.find(letter); unit != std::string_view::npos) {
      factor = std::pow(1024.0, static_cast<double>(unit + 1));
      digits.remove_suffix(1);
    }
  }
  const std::optional<double> amount = parse_number<double>(digits);
  constexpr double most = 9e18;
  if (!amount || !(*amount > 0.0) || *amount * factor < 1.0 || *amount * factor > most) {
    throw InvalidArgument(complaint);
  }
  return static_cast<std::uint64_t>(*amount * factor);
}

std::vector<std::string> tie_numbers_to_flags(const std::vector<std::string>& arguments) {
  std::vector<std::string> tied;
  for (std::size_t i = 0; i < arguments.size();) {
    if (arguments[i] == "--") {
      tied.insert(tied.end(), arguments.begin() + static_cast<std::ptrdiff_t>(i), arguments.end());
      break;
    }
    const std::size_t most = numbers_after(arguments[i]);
    const std::string& flag = arguments[i++];
    std::string joined = flag;
    if (most > 0 && (i == arguments.size() || arguments[i].starts_with("--"))) {
      throw InvalidArgument(joined + " wants a number after it");
    }
    for (std::size_t taken = 0; taken < most && i < arguments.size(); ++taken, ++i) {
      const bool is_one = flag == "--spacing" ? is_length(arguments[i])
                                              : parse_number<double>(arguments[i]).has_value();
      if (!is_one) break;
      joined += (taken == 0 ? '=' : ' ') + arguments[i];
    }
    tied.push_back(std::move(joined));
  }
  return tied;
}

}  // namespace isoloop
