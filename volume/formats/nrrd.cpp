#include "volume/formats/nrrd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "volume/base/header_text.h"
#include "volume/base/refuse.h"
#include "volume/voxels/length_unit.h"
#include "volume/voxels/stored_voxels.h"

namespace isoloop {
namespace {

/// Lines "name: value", by name; names that mean the same are made one.
using Fields = std::map<std::string, std::string>;

std::string field_name(std::string_view text) {
  std::string name = lower_case(trimmed(text));
  std::erase(name, ' ');
  return name == "centerings" ? "centers" : name;
}

/// Whether a value that is cut would be none, or would name a file that is not there.
bool proves_itself(const std::string& name) {
  return name == "datafile" || name == "encoding" || name == "endian" || name == "type";
}

Fields read_fields(ByteStream& stream, bool& detached, bool& is_ended, const std::string& what) {
  const std::string magic = read_line(stream, what);
  if (magic.size() != 8 || !magic.starts_with("NRRD000") || magic[7] < '1' || magic[7] > '5') {
    refuse(what, "is no NRRD file of version 1 to 5");
  }
  Fields fields;
  while (true) {
    // A detached header may end where the file does.
    if (stream.most_left() == 0 && fields.contains("datafile")) {
      detached = true;
      return fields;
    }
    const std::string line = read_line_or_rest(stream, what, is_ended);
    if (line.empty()) break;
    if (line[0] == '#') continue;
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) {
      refuse(what, "its header has a line without a colon: '" + line.substr(0, 80) + "'");
    }
    if (line.substr(colon, 2) == ":=") continue;  // a key and a value of the user's own
    const std::string name = field_name(std::string_view(line).substr(0, colon));
    const std::string value(trimmed(std::string_view(line).substr(colon + 1)));
    if (!fields.emplace(name, value).second) refuse(what, "its header states " + name + " twice");
    if (!is_ended && !proves_itself(name)) refuse(what, "ends within its header");
    if (name == "datafile" && names_several_files(what, value)) {
      refuse(what, "its voxels lie in several files; join them with: unu save -e gzip",
             Fault::unsupported);
    }
  }
  detached = fields.contains("datafile");
  return fields;
}

const std::string& field(const Fields& fields, const std::string& name, const std::string& what) {
  const auto found = fields.find(name);
  if (found == fields.end()) refuse(what, "its header does not state " + name);
  return found->second;
}

StoredType type_of(const std::string& name, const std::string& what) {
  struct Name {
    std::string_view name;
    StoredType type;
  };
  static constexpr std::array<Name, 35> names{{{"signed char", StoredType::int8},
                                               {"int8", StoredType::int8},
                                               {"int8_t", StoredType::int8},
                                               {"uchar", StoredType::uint8},
                                               {"unsigned char", StoredType::uint8},
                                               {"uint8", StoredType::uint8},
                                               {"uint8_t", StoredType::uint8},
                                               {"short", StoredType::int16},
                                               {"short int", StoredType::int16},
                                               {"signed short", StoredType::int16},
                                               {"signed short int", StoredType::int16},
                                               {"int16", StoredType::int16},
                                               {"int16_t", StoredType::int16},
                                               {"ushort", StoredType::uint16},
                                               {"unsigned short", StoredType::uint16},
                                               {"unsigned short int", StoredType::uint16},
                                               {"uint16", StoredType::uint16},
                                               {"uint16_t", StoredType::uint16},
                                               {"int", StoredType::int32},
                                               {"signed int", StoredType::int32},
                                               {"int32", StoredType::int32},
                                               {"int32_t", StoredType::int32},
                                               {"uint", StoredType::uint32},
                                               {"unsigned int", StoredType::uint32},
                                               {"uint32", StoredType::uint32},
                                               {"uint32_t", StoredType::uint32},
                                               {"longlong", StoredType::int64},
                                               {"long long", StoredType::int64},
                                               {"int64", StoredType::int64},
                                               {"int64_t", StoredType::int64},
                                               {"ulonglong", StoredType::uint64},
                                               {"uint64", StoredType::uint64},
                                               {"uint64_t", StoredType::uint64},
                                               {"float", StoredType::float32},
                                               {"double", StoredType::float64}}};
  for (const auto& [text, type] : names) {
    if (name == text) return type;
  }
  refuse(what, "holds voxels of type '" + name + "', which isoloop does not read",
         Fault::unsupported);
}

/// Which of the file's axes are x, y and z, and how many voxels lie along the one after them.
struct Axes {
  std::vector<std::int64_t> sizes;
  std::vector<std::size_t> spatial;
  std::int64_t frames = 1;
};

bool is_frame_kind(const std::string& kind) {
  return kind == "time" || kind == "list" || kind == "???" || kind == "none";
}

// Axes of colours, vectors and the like are told by their kind.
Axes axes_of(const Fields& fields, const std::string& what) {
  const auto dimension = whole_numbers_of(field(fields, "dimension", what), 1, what).front();
  if (dimension < 1 || dimension > 16) {
    refuse(what, "its header states " + std::to_string(dimension) + " dimensions");
  }
  const auto count = static_cast<std::size_t>(dimension);
  Axes axes{.sizes = whole_numbers_of(field(fields, "sizes", what), count, what), .spatial = {}};
  std::vector<std::string> kinds(count, "domain");
  if (const auto given = fields.find("kinds"); given != fields.end()) {
    kinds = words_of(lower_case(given->second));
    if (kinds.size() != count) refuse(what, "its header states kinds that are not one an axis");
  }
  for (std::size_t axis = 0; axis < count; ++axis) {
    const bool space = kinds[axis] == "domain" || kinds[axis] == "space";
    if (axes.sizes[axis] < 1) refuse(what, "its header states a size below 1");
    if (space && axes.spatial.size() < 3) {
      axes.spatial.push_back(axis);
    } else if (axis + 1 == count && (space || is_frame_kind(kinds[axis]))) {
      axes.frames = axes.sizes[axis];
    } else if (axes.sizes[axis] > 1) {
      refuse(what,
             "holds " + std::to_string(axes.sizes[axis]) + " numbers per voxel (axis " +
                 std::to_string(axis) + " is of kind " + kinds[axis] +
                 "); take one channel, for example with: unu slice -a " + std::to_string(axis) +
                 " -p 0",
             Fault::unsupported);
    }
  }
  if (axes.spatial.empty()) refuse(what, "none of its axes is one of space");
  return axes;
}

/// "(1,0,0) none (0,1,0)": three numbers, or nothing for an axis that is not in space.
std::vector<std::optional<Vec3>> vectors_of(std::string_view text, const std::string& what) {
  std::vector<std::optional<Vec3>> vectors;
  while (!(text = trimmed(text)).empty()) {
    if (text.starts_with("none")) {
      vectors.emplace_back();
      text.remove_prefix(4);
      continue;
    }
    const std::size_t end = text.find(')');
    if (text[0] != '(' || end == std::string_view::npos) {
      refuse(what,
             "its header states a vector that is none: '" + std::string(text.substr(0, 80)) + "'");
    }
    std::string inner(text.substr(1, end - 1));
    std::replace(inner.begin(), inner.end(), ',', ' ');
    const std::vector<double> numbers = numbers_of(inner, 3, what);
    vectors.push_back(Vec3{numbers[0], numbers[1], numbers[2]});
    text.remove_prefix(end + 1);
  }
  return vectors;
}

struct Space {
  Frame frame = Frame::index;
  bool mirrored = false;  // left-anterior-superior: x has the other sign in RAS
};

Space space_of(const Fields& fields, const std::string& what) {
  const auto dimension = fields.find("spacedimension");
  if (dimension != fields.end()) {
    if (dimension->second != "3") refuse(what, "lies in a space that is not of three dimensions");
    return {.frame = Frame::world};
  }
  const auto given = fields.find("space");
  if (given == fields.end()) return {};
  const std::string space = lower_case(given->second);
  if (space == "right-anterior-superior" || space == "ras") return {.frame = Frame::ras};
  if (space == "left-posterior-superior" || space == "lps") return {.frame = Frame::lps};
  if (space == "left-anterior-superior" || space == "las") {
    return {.frame = Frame::ras, .mirrored = true};
  }
  if (space == "scanner-xyz" || space == "3d-right-handed" || space == "3d-left-handed") {
    return {.frame = Frame::world};
  }
  refuse(what, "lies in the space '" + space + "', which isoloop does not know",
         Fault::unsupported);
}

// Lengths alone: `spacings`, of all axes of the file.
Placement placement_by_spacings(const Fields& fields, const Axes& axes, const std::string& what) {
  Placement placement;
  const auto given = fields.find("spacings");
  if (given == fields.end()) {
    if (fields.contains("axismins") || fields.contains("axismaxs")) {
      refuse(what, "its header states axis mins and maxs but no spacings", Fault::damaged,
             {Advice::state_spacing});
    }
    return placement;
  }
  const std::vector<double> numbers = numbers_of(given->second, axes.sizes.size(), what);
  Vec3 spacing{1.0, 1.0, 1.0};
  for (std::size_t i = 0; i < axes.spatial.size(); ++i) spacing[i] = numbers[axes.spatial[i]];
  placement.columns = columns_of(spacing, what);
  return placement;
}

Placement placement_of(const Fields& fields, const Axes& axes, const std::string& what) {
  const Space space = space_of(fields, what);
  const auto given = fields.find("spacedirections");
  if (given == fields.end()) return placement_by_spacings(fields, axes, what);
  if (space.frame == Frame::index) refuse(what, "its header states directions but no space");
  const auto directions = vectors_of(given->second, what);
  if (directions.size() != axes.sizes.size()) {
    refuse(what, "its header states space directions that are not one an axis");
  }
  Placement placement{.frame = space.frame};
  for (std::size_t i = 0; i < axes.spatial.size(); ++i) {
    const auto& direction = directions[axes.spatial[i]];
    if (!direction) refuse(what, "its header gives no direction to an axis of space");
    placement.columns[i] = *direction;
  }
  if (const auto origin = fields.find("spaceorigin"); origin != fields.end()) {
    const auto points = vectors_of(origin->second, what);
    if (points.size() != 1 || !points[0]) refuse(what, "its header's space origin is no point");
    placement.origin = *points[0];
  }
  if (space.mirrored) {
    placement.origin[0] = 0.0 - placement.origin[0];
    for (Vec3& column : placement.columns) column[0] = 0.0 - column[0];
  }
  return placement;
}

/// What `units` or `space units` says of all axes of space alike; empty if they do not.
std::string unit_of(const Fields& fields, const Axes& axes) {
  const bool by_space = fields.contains("spacedirections");
  const auto given = fields.find(by_space ? "spaceunits" : "units");
  if (given == fields.end()) return {};
  std::vector<std::string> words;  // between quotation marks, which may hold nothing
  std::string_view text = given->second;
  while (!(text = trimmed(text)).empty()) {
    const std::size_t end = text.find('"', 1);
    if (text[0] != '"' || end == std::string_view::npos) return {};
    words.emplace_back(text.substr(1, end - 1));
    text.remove_prefix(end + 1);
  }
  std::string unit;
  for (std::size_t i = 0; i < axes.spatial.size(); ++i) {
    const std::size_t place = by_space ? i : axes.spatial[i];
    const auto length = place < words.size() ? length_unit(words[place]) : std::nullopt;
    if (!length || (i > 0 && length->name != unit)) return {};
    unit = length->name;
  }
  return unit;
}

std::int64_t whole_field(const Fields& fields, const std::string& name, const std::string& what) {
  const auto given = fields.find(name);
  return given == fields.end() ? 0 : whole_numbers_of(given->second, 1, what).front();
}

VoxelLayout layout_of(const Fields& fields, const Axes& axes, const std::string& what) {
  VoxelLayout layout;
  for (std::size_t i = 0; i < axes.spatial.size(); ++i) {
    layout.dims[i] = axes.sizes[axes.spatial[i]];
  }
  layout.frames = static_cast<std::uint64_t>(axes.frames);
  layout.type = type_of(lower_case(field(fields, "type", what)), what);
  if (bytes_per_voxel(layout.type) > 1) {
    const std::string endian = lower_case(field(fields, "endian", what));
    if (endian != "little" && endian != "big") refuse(what, "its endian is '" + endian + "'");
    layout.endian = endian == "big" ? Endian::big : Endian::little;
  }
  return layout;
}

bool is_gzip(const Fields& fields, const std::string& what) {
  const std::string encoding = lower_case(field(fields, "encoding", what));
  if (encoding == "raw") return false;
  if (encoding == "gzip" || encoding == "gz") return true;
  refuse(what,
         "its encoding is '" + encoding +
             "', and isoloop reads raw and gzip; convert it with: unu save -e gzip",
         Fault::unsupported);
}

/// Where the voxels are: a stream at the first of them.
void read_data(const Fields& fields, const std::filesystem::path& data, std::uint64_t first,
               const VoxelLayout& layout, std::uint64_t frame, const VoxelLimits& limits,
               Volume& volume) {
  const std::string what = data.string();
  const bool packed = is_gzip(fields, what);
  const std::int64_t lines = whole_field(fields, "lineskip", what);
  std::int64_t bytes = whole_field(fields, "byteskip", what);
  if (lines < 0 || bytes < (packed ? 0 : -1)) refuse(what, "its header skips less than nothing");
  ByteStream plain(data, Packing::plain, first);
  for (std::int64_t line = 0; line < lines; ++line) read_line(plain, what);
  if (bytes == -1) {  // the voxels are the last bytes of the file
    const std::uint64_t wanted =
        checked_voxel_bytes(layout.dims, bytes_per_voxel(layout.type), what) * layout.frames;
    plain.check_room(wanted, "its voxels");
    bytes = static_cast<std::int64_t>(plain.most_left() - wanted);
  }
  const std::uint64_t from = stored_bytes(data) - plain.most_left();
  ByteStream stream(data, packed ? Packing::gzip : Packing::plain, from);
  stream.skip(static_cast<std::uint64_t>(bytes), "what lies before its voxels");
  read_voxels(stream, layout, frame, limits, what, volume);
}

}  // namespace

Volume read_nrrd(const std::filesystem::path& path, const FormatOptions& options,
                 const VoxelLimits& limits) {
  const std::string what = path.string();
  ByteStream header(path, Packing::plain);
  const std::uint64_t size = header.most_left();
  bool detached = false;
  bool is_ended = true;
  const Fields fields = read_fields(header, detached, is_ended, what);
  is_gzip(fields, what);
  const Axes axes = axes_of(fields, what);
  VoxelLayout layout = layout_of(fields, axes, what);
  if (options.crop) layout.part = voxels_in(*options.crop, layout.dims, what);
  check_layout(layout, limits, what);
  Volume volume;
  volume.dims = layout.dims;
  Placement placement;
  if (!options.spacing) placement = placement_of(fields, axes, what);
  place(volume, placement, options.spacing, what);
  if (!options.spacing) volume.unit = unit_of(fields, axes);
  const std::uint64_t frame = choose_frame(layout, options.frame, what);

  const std::filesystem::path data = detached ? beside(path, fields.at("datafile")) : path;
  const std::uint64_t first = detached ? 0 : size - header.most_left();
  if (detached) volume.data_file = data;
  read_data(fields, data, first, layout, frame, limits, volume);
  if (!is_ended) volume.warnings.push_back(unended_header_warning(what));
  return volume;
}

}  // namespace isoloop
