#include "volume/formats/meta_image.h"

#include <array>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "volume/base/header_text.h"
#include "volume/base/refuse.h"
#include "volume/voxels/stored_voxels.h"

namespace isoloop {
namespace {

/// Lines "Name = value" by name in small letters, the last of which says where the voxels are.
using Fields = std::map<std::string, std::string>;

/// An unended last line may be that of the data file's name, which that file proves.
Fields read_fields(ByteStream& stream, const std::string& what, bool& is_ended) {
  Fields fields;
  while (!fields.contains("elementdatafile")) {
    const std::string line = read_line_or_rest(stream, what, is_ended);
    if (trimmed(line).empty()) continue;
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) {
      refuse(what, "its header has a line without '=': '" + line.substr(0, 80) + "'");
    }
    const std::string name = lower_case(trimmed(std::string_view(line).substr(0, equals)));
    const std::string value(trimmed(std::string_view(line).substr(equals + 1)));
    if (!fields.emplace(name, value).second) refuse(what, "its header states " + name + " twice");
  }
  return fields;
}

/// The value of the first of these names that the header has; empty if it has none of them.
std::string first_of(const Fields& fields, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (const auto found = fields.find(name); found != fields.end()) return found->second;
  }
  return {};
}

std::string required(const Fields& fields, const char* name, const std::string& what) {
  const std::string value = first_of(fields, {name});
  if (value.empty()) refuse(what, std::string("its header does not state ") + name);
  return value;
}

bool flag(const Fields& fields, std::initializer_list<const char*> names, bool if_missing,
          const std::string& what) {
  const std::string value = lower_case(first_of(fields, names));
  if (value.empty()) return if_missing;
  if (value != "true" && value != "false" && value != "1" && value != "0") {
    refuse(what, "its header says '" + value + "' where True or False should be");
  }
  return value == "true" || value == "1";
}

StoredType type_of(const std::string& name, const std::string& what) {
  struct Name {
    std::string_view name;
    StoredType type;
  };
  static constexpr std::array<Name, 12> names{{{"MET_CHAR", StoredType::int8},
                                               {"MET_UCHAR", StoredType::uint8},
                                               {"MET_SHORT", StoredType::int16},
                                               {"MET_USHORT", StoredType::uint16},
                                               {"MET_INT", StoredType::int32},
                                               {"MET_UINT", StoredType::uint32},
                                               {"MET_LONG", StoredType::int32},
                                               {"MET_ULONG", StoredType::uint32},
                                               {"MET_LONG_LONG", StoredType::int64},
                                               {"MET_ULONG_LONG", StoredType::uint64},
                                               {"MET_FLOAT", StoredType::float32},
                                               {"MET_DOUBLE", StoredType::float64}}};
  for (const auto& [text, type] : names) {
    if (lower_case(name) == lower_case(text)) return type;
  }
  refuse(what, "holds voxels of type '" + name + "', which isoloop does not read",
         Fault::unsupported);
}

std::size_t dimensions_of(const Fields& fields, const std::string& what) {
  const auto count = whole_numbers_of(required(fields, "ndims", what), 1, what).front();
  if (count < 1 || count > 4) {
    refuse(what, "has " + std::to_string(count) + " dimensions; 1 to 4 are read",
           Fault::unsupported);
  }
  return static_cast<std::size_t>(count);
}

VoxelLayout layout_of(const Fields& fields, const std::string& what) {
  VoxelLayout layout;
  const std::size_t count = dimensions_of(fields, what);
  const auto sizes = whole_numbers_of(required(fields, "dimsize", what), count, what);
  for (std::size_t axis = 0; axis < count && axis < 3; ++axis) layout.dims[axis] = sizes[axis];
  if (count == 4) {
    if (sizes[3] < 1) refuse(what, "its header states a size below 1");
    layout.frames = static_cast<std::uint64_t>(sizes[3]);
  }
  layout.type = type_of(required(fields, "elementtype", what), what);
  const std::string channels = first_of(fields, {"elementnumberofchannels"});
  if (!channels.empty() && whole_numbers_of(channels, 1, what).front() != 1) {
    refuse(what, "holds " + channels + " numbers per voxel (multi-channel); take one channel",
           Fault::unsupported);
  }
  if (!flag(fields, {"binarydata"}, true, what)) {
    refuse(what, "holds its voxels as text; convert them to binary (BinaryData = True)",
           Fault::unsupported);
  }
  if (flag(fields, {"binarydatabyteordermsb", "elementbyteordermsb"}, false, what)) {
    layout.endian = Endian::big;
  }
  const std::string slope = first_of(fields, {"elementtointensityfunctionslope"});
  const std::string offset = first_of(fields, {"elementtointensityfunctionoffset"});
  if (!slope.empty()) layout.slope = numbers_of(slope, 1, what).front();
  if (!offset.empty()) layout.intercept = numbers_of(offset, 1, what).front();
  return layout;
}

Placement placement_of(const Fields& fields, const std::string& what) {
  const std::size_t count = dimensions_of(fields, what);
  const std::size_t space = count < 3 ? count : 3;
  Vec3 spacing{1.0, 1.0, 1.0};
  Placement placement{.frame = Frame::lps};
  const std::string lengths = first_of(fields, {"elementspacing", "elementsize"});
  if (!lengths.empty()) {
    const auto numbers = numbers_of(lengths, count, what);
    for (std::size_t axis = 0; axis < space; ++axis) spacing[axis] = numbers[axis];
  }
  columns_of(spacing, what);  // refuses what is no length
  const std::string offset = first_of(fields, {"offset", "position", "origin"});
  if (!offset.empty()) {
    const auto numbers = numbers_of(offset, count, what);
    for (std::size_t axis = 0; axis < space; ++axis) placement.origin[axis] = numbers[axis];
  }
  const std::string matrix = first_of(fields, {"transformmatrix", "rotation", "orientation"});
  if (!matrix.empty()) {
    const auto numbers = numbers_of(matrix, count * count, what);
    for (std::size_t axis = 0; axis < space; ++axis) {
      for (std::size_t c = 0; c < space; ++c) {
        placement.columns[axis][c] = numbers[axis * count + c];
      }
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (double& entry : placement.columns[axis]) entry *= spacing[axis];
  }
  return placement;
}

/// The bytes before the voxels in their file; -1: whatever comes before its last ones.
std::int64_t header_size(const Fields& fields, const std::string& what) {
  const std::string text = first_of(fields, {"headersize"});
  const std::int64_t size = text.empty() ? 0 : whole_numbers_of(text, 1, what).front();
  if (size < -1) refuse(what, "its header skips less than nothing");
  return size;
}

void read_data(const Fields& fields, const std::filesystem::path& data, std::uint64_t first,
               const VoxelLayout& layout, std::uint64_t frame, const VoxelLimits& limits,
               Volume& volume) {
  const std::string what = data.string();
  const bool packed = flag(fields, {"compresseddata"}, false, what);
  const std::int64_t skipped = header_size(fields, what);
  if (skipped > 0) first += static_cast<std::uint64_t>(skipped);
  if (skipped == -1) {
    if (packed)
      refuse(what, "its voxels are compressed, so HeaderSize -1 says not where they are",
             Fault::unsupported);
    const std::uint64_t wanted =
        checked_voxel_bytes(layout.dims, bytes_per_voxel(layout.type), what) * layout.frames;
    ByteStream whole(data, Packing::plain, first);
    whole.check_room(wanted, "its voxels");
    first = stored_bytes(data) - wanted;
  }
  const std::string stated = first_of(fields, {"compresseddatasize"});
  ByteStream stream(data, packed ? Packing::zlib : Packing::plain, first);
  const std::uint64_t present = stored_bytes(data) - first;
  read_voxels(stream, layout, frame, limits, what, volume);
  // The voxels' own checksum was there and right.
  if (packed && !stated.empty() && stated != std::to_string(present)) {
    volume.warnings.push_back({.text = "the header states " + stated + " compressed bytes, but " +
                                       std::to_string(present) +
                                       " are there: their checksum proves that they are whole"});
  }
}

}  // namespace

Volume read_meta_image(const std::filesystem::path& path, const FormatOptions& options,
                       const VoxelLimits& limits) {
  const std::string what = path.string();
  ByteStream header(path, Packing::plain);
  bool is_ended = true;
  const Fields fields = read_fields(header, what, is_ended);
  if (const std::string object = first_of(fields, {"objecttype"});
      !object.empty() && lower_case(object) != "image") {
    refuse(what, "holds an object of type " + object + ", not an image", Fault::unsupported);
  }
  const std::string file = fields.at("elementdatafile");
  if (names_several_files(path, file)) {
    refuse(what, "its voxels lie in several files ('" + file + "'); join them to one .mha file",
           Fault::unsupported);
  }
  VoxelLayout layout = layout_of(fields, what);
  if (options.crop) layout.part = voxels_in(*options.crop, layout.dims, what);
  check_layout(layout, limits, what);
  Volume volume;
  volume.dims = layout.dims;
  place(volume, options.spacing ? Placement{} : placement_of(fields, what), options.spacing, what);
  add_scale_note(layout, volume);
  const std::uint64_t frame = choose_frame(layout, options.frame, what);
  const bool local = lower_case(file) == "local";
  if (!local) volume.data_file = beside(path, file);
  read_data(fields, local ? path : beside(path, file),
            local ? stored_bytes(path) - header.most_left() : 0, layout, frame, limits, volume);
  if (!is_ended) volume.warnings.push_back(unended_header_warning(what));
  return volume;
}

}  // namespace isoloop
