#include "volume/formats/vti.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/errors.h"
#include "volume/base/header_text.h"
#include "volume/base/refuse.h"
#include "volume/formats/vti_data.h"
#include "volume/formats/vti_header.h"
#include "volume/voxels/stored_voxels.h"

namespace isoloop {
namespace {

StoredType type_of(const std::string& name, const std::string& what) {
  struct Name {
    std::string_view name;
    StoredType type;
  };
  static constexpr std::array<Name, 10> names{{{"Int8", StoredType::int8},
                                               {"UInt8", StoredType::uint8},
                                               {"Int16", StoredType::int16},
                                               {"UInt16", StoredType::uint16},
                                               {"Int32", StoredType::int32},
                                               {"UInt32", StoredType::uint32},
                                               {"Int64", StoredType::int64},
                                               {"UInt64", StoredType::uint64},
                                               {"Float32", StoredType::float32},
                                               {"Float64", StoredType::float64}}};
  for (const auto& [text, type] : names) {
    if (name == text) return type;
  }
  refuse(what, "holds values of type '" + name + "', which isoloop does not read",
         Fault::unsupported);
}

VtiEncoding encoding_of(const VtiHeader& header, const std::string& what) {
  VtiEncoding encoding;
  const std::string order = attribute(header.file, "byte_order", "LittleEndian");
  const std::string sizes = attribute(header.file, "header_type", "UInt32");
  const std::string compressor = attribute(header.file, "compressor", "");
  if (order != "LittleEndian" && order != "BigEndian") refuse(what, "its byte order is " + order);
  if (sizes != "UInt32" && sizes != "UInt64") refuse(what, "states sizes as " + sizes);
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
    refuse(what, "is compressed by " + compressor + "; isoloop reads vtkZLibDataCompressor",
           Fault::unsupported);
  }
  encoding.endian = order == "BigEndian" ? Endian::big : Endian::little;
  encoding.size_bytes = sizes == "UInt64" ? 8 : 4;
  encoding.packed = !compressor.empty();
  return encoding;
}

/// Sets the dims and returns the index of the first voxel's centre in the file's own numbering of
/// points. A cell lies between two of them, but along an axis that has one it lies in it.
Vec3 read_extent(const VtiHeader& header, VtiSite site, VoxelLayout& layout,
                 const std::string& what) {
  const auto numbers = whole_numbers_of(attribute(header.image, "WholeExtent", ""), 6, what);
  Vec3 first{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t low = numbers[2 * axis];
    const std::int64_t high = numbers[2 * axis + 1];
    constexpr std::int64_t most = std::int64_t{1} << 40;
    if (low > high || low < -most || high > most) refuse(what, "its extent makes no volume");
    const bool between_points = site == VtiSite::cells && high > low;
    layout.dims[axis] = high - low + (between_points ? 0 : 1);
    first[axis] = static_cast<double>(low) + (between_points ? 0.5 : 0.0);
  }
  return first;
}

Placement placement_of(const VtiHeader& header, const Vec3& first, const std::string& what) {
  const auto origin = numbers_of(attribute(header.image, "Origin", "0 0 0"), 3, what);
  const auto spacing = numbers_of(attribute(header.image, "Spacing", "1 1 1"), 3, what);
  const auto rows = numbers_of(attribute(header.image, "Direction", "1 0 0 0 1 0 0 0 1"), 9, what);
  Placement placement{.origin = {origin[0], origin[1], origin[2]}, .frame = Frame::world};
  columns_of({spacing[0], spacing[1], spacing[2]}, what);  // refuses what is no length
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t c = 0; c < 3; ++c) {
      placement.columns[axis][c] = rows[3 * c + axis] * spacing[axis];
    }
  }
  placement.origin = to_world(placement, first);
  return placement;
}

template <class T>
VoxelArray parsed_values(std::string_view text, std::uint64_t count, const std::string& what) {
  const std::vector<std::string> words = words_of(text);
  if (words.size() != count) {
    refuse(what, "holds " + std::to_string(words.size()) + " numbers, but " +
                     std::to_string(count) + " voxels");
  }
  std::vector<T> values;
  values.reserve(count);
  for (const std::string& word : words) {
    const std::optional<double> number = number_of(word);
    bool fits = number.has_value();
    if constexpr (std::is_integral_v<T>) {
      fits = fits && *number == std::floor(*number) &&
             *number >= static_cast<double>(std::numeric_limits<T>::min()) &&
             *number <= static_cast<double>(std::numeric_limits<T>::max());
    }
    if (!fits) refuse(what, "holds '" + word.substr(0, 40) + "' where a voxel's number should be");
    values.push_back(static_cast<T>(*number));
  }
  return values;
}

VoxelArray values_of_text(std::string_view text, StoredType type, std::uint64_t count,
                          const std::string& what) {
  // Each number takes a letter and a blank at least: before memory is asked for.
  if (text.size() / 2 + 1 < count) refuse(what, "its text is too short for its voxels");
  switch (type) {
    case StoredType::uint8:
      return parsed_values<std::uint8_t>(text, count, what);
    case StoredType::int8:
      return parsed_values<std::int8_t>(text, count, what);
    case StoredType::uint16:
      return parsed_values<std::uint16_t>(text, count, what);
    case StoredType::int16:
      return parsed_values<std::int16_t>(text, count, what);
    case StoredType::uint32:
    case StoredType::uint64:
      return parsed_values<std::uint32_t>(text, count, what);
    case StoredType::int32:
    case StoredType::int64:
      return parsed_values<std::int32_t>(text, count, what);
    case StoredType::float32:
      return parsed_values<float>(text, count, what);
    case StoredType::float64:
      return parsed_values<double>(text, count, what);
  }
  refuse(what, "holds values of an unknown type");
}

VoxelArray values_of_bytes(const std::string& bytes, const VoxelLayout& layout,
                           const std::string& what) {
  std::size_t at = 0;
  const auto next = [&](std::span<std::byte> to) {
    if (to.size() > bytes.size() - at) refuse(what, "ends within its voxels");
    std::memcpy(to.data(), bytes.data() + at, to.size());
    at += to.size();
  };
  return read_stored(next, layout, what);
}

VoxelArray values_of(const VtiArray& array, const VtiHeader& header, const VoxelLayout& layout,
                     const std::string& what) {
  const std::string format = attribute(array.tag, "format", "ascii");
  const auto count = static_cast<std::uint64_t>(layout.dims[0] * layout.dims[1] * layout.dims[2]);
  if (format == "ascii") return values_of_text(array.text, layout.type, count, what);
  VtiEncoding encoding = encoding_of(header, what);
  std::string_view stored = trimmed(array.text);
  encoding.base64 = true;
  if (format == "appended") {
    const auto offset = whole_numbers_of(attribute(array.tag, "offset", ""), 1, what).front();
    if (offset < 0 || static_cast<std::uint64_t>(offset) > header.appended.size()) {
      refuse(what, "its array begins beyond the file's end; fetch the file again");
    }
    stored = header.appended.substr(static_cast<std::size_t>(offset));
    encoding.base64 = header.appended_base64;
  } else if (format != "binary") {
    refuse(what, "its array's format is '" + format + "'");
  }
  const std::uint64_t wanted = count * bytes_per_voxel(layout.type);
  return values_of_bytes(vti_bytes(stored, encoding, wanted, what), layout, what);
}

std::string whole_file(const std::filesystem::path& path, const VoxelLimits& limits) {
  ByteStream stream(path, Packing::plain);
  const std::uint64_t bytes = stream.most_left();
  const std::uint64_t limit = limits.max_bytes == 0 ? default_voxel_limit() : limits.max_bytes;
  constexpr std::uint64_t always = std::uint64_t{1} << 20;
  if (bytes > std::max(limit, always)) {
    throw LimitExceeded(
        {.file = path.string(),
         .text = "the file has " + std::to_string(bytes) + " bytes, and the limit is " +
                 std::to_string(limit),
         .advice = {Advice::raise_memory_limit}},
        {.unit = Excess::Unit::bytes, .needed = bytes, .limit = limit, .stage = "read"});
  }
  std::string text(bytes, '\0');
  stream.read(std::as_writable_bytes(std::span(text)), "the file");
  return text;
}

}  // namespace

Volume read_vti(const std::filesystem::path& path, const FormatOptions& options,
                const VoxelLimits& limits) {
  const std::string what = path.string();
  const std::string text = whole_file(path, limits);
  const VtiHeader header = parse_vti_header(text, what);
  const VtiArray& array = choose_array(header, options.array, what);
  const std::string components = attribute(array.tag, "NumberOfComponents", "1");
  if (components != "1") {
    refuse(what,
           "holds " + components +
               " numbers per voxel (vector or multi-channel); take one "
               "channel",
           Fault::unsupported);
  }
  VoxelLayout layout;
  layout.type = type_of(attribute(array.tag, "type", ""), what);
  const Vec3 first = read_extent(header, array.site, layout, what);
  layout.endian = encoding_of(header, what).endian;
  check_layout(layout, limits, what);
  choose_frame(layout, options.frame, what);
  Volume volume;
  volume.dims = layout.dims;
  volume.name = array.name();
  if (array.site == VtiSite::cells) {
    volume.notes.push_back(
        {.text = "cells are read as voxels, whose centres lie between the points"});
  }
  Placement placement;
  if (!options.spacing) placement = placement_of(header, first, what);
  place(volume, placement, options.spacing, what);
  volume.values = values_of(array, header, layout, what);
  return volume;
}

}  // namespace isoloop
