#include "volume/formats/raw.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <regex>
#include <span>
#include <string>

#include "core/base/errors.h"
#include "volume/base/byte_stream.h"
#include "volume/voxels/stored_voxels.h"

namespace isoloop {
namespace {

RawLayout layout_for(const std::filesystem::path& path, const RawOptions& options) {
  const std::optional<RawLayout> named = layout_from_name(path);
  if (!options.dims && !named) {
    throw InvalidArgument({.file = path.string(),
                           .text = "a raw file does not state its dimensions",
                           .advice = {Advice::name_raw_file, Advice::state_dims}},
                          Option::dims);
  }
  if (!options.type && !named) {
    throw InvalidArgument({.file = path.string(),
                           .text = "a raw file does not state its voxel type",
                           .advice = {Advice::name_raw_file, Advice::state_voxel_type}},
                          Option::voxel_type);
  }
  return {options.dims ? *options.dims : named->dims, options.type ? *options.type : named->type};
}

void check_spacing(const std::filesystem::path& path, const Vec3& spacing) {
  for (const double length : spacing) {
    if (!is_spacing(length)) {
      throw InvalidArgument({.file = path.string(),
                             .about = Option::spacing,
                             .text = "must lie between 1e-18 and 1e18"});
    }
  }
}

void check_file_size(const std::filesystem::path& path, const RawLayout& layout, std::uint64_t skip,
                     std::uint64_t voxel_bytes) {
  const std::uint64_t found = stored_bytes(path);
  if (found >= skip && found - skip == voxel_bytes) return;
  const bool fits = skip <= std::numeric_limits<std::uint64_t>::max() - voxel_bytes;
  const std::string expected = fits ? std::to_string(skip + voxel_bytes) : "more";
  const std::string after = skip > 0 ? " after " + std::to_string(skip) + " skipped bytes" : "";
  throw InvalidInput({.file = path.string(),
                      .text = "the file has " + std::to_string(found) + " bytes, but " +
                              dims_text(layout.dims) + " voxels of " + type_name(layout.type) +
                              after + " take " + expected,
                      .advice = {Advice::check_raw_layout}});
}

}  // namespace

std::optional<RawLayout> layout_from_name(const std::filesystem::path& path) {
  static const std::regex pattern(
      R"(^(?:.*_)?([0-9]+)x([0-9]+)x([0-9]+)_(u?int(?:8|16|32)|float(?:32|64))(?![0-9a-z]).*$)");
  const std::string name = path.filename().string();
  std::smatch match;
  // std::regex recurses once per character: a name longer than any file system's is not matched.
  if (name.size() > 255 || !std::regex_match(name, match, pattern)) return std::nullopt;
  RawLayout layout;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string digits = match[axis + 1].str();
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), layout.dims[axis]);
    if (error != std::errc() || layout.dims[axis] < 1) return std::nullopt;
  }
  layout.type = parse_voxel_type(match[4].str()).value();
  return layout;
}

Volume read_raw(const std::filesystem::path& path, const RawOptions& options,
                const VoxelLimits& limits) {
  const RawLayout layout = layout_for(path, options);
  check_spacing(path, options.spacing);
  check_file_size(path, layout, options.skip,
                  checked_voxel_bytes(layout.dims, bytes_per_voxel(layout.type), path.string()));
  Volume volume;
  ByteStream stream(path, Packing::plain, options.skip);
  VoxelLayout voxels{
      .dims = layout.dims, .type = static_cast<StoredType>(layout.type), .endian = options.endian};
  if (options.crop) voxels.part = voxels_in(*options.crop, layout.dims, path.string());
  volume.dims = layout.dims;
  volume.spacing = options.spacing;
  read_voxels(stream, voxels, 0, limits, path.string(), volume);
  return volume;
}

void for_each_little_endian(const VoxelArray& values,
                            const std::function<void(std::span<const std::byte>)>& take) {
  std::visit(
      [&]<class T>(const std::vector<T>& voxels) {
        if constexpr (native_endian == Endian::little) {
          take(std::as_bytes(std::span(voxels)));
        } else {
          std::vector<T> swapped = voxels;
          swap_bytes<T>(swapped);
          take(std::as_bytes(std::span(swapped)));
        }
      },
      values);
}

void write_raw(std::ostream& out, const Volume& volume) {
  for_each_little_endian(volume.values, [&](std::span<const std::byte> bytes) {
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
  });
}

}  // namespace isoloop
