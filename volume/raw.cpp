#include "volume/raw.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <ostream>
#include <regex>
#include <span>
#include <string>

#include "core/errors.h"
#include "volume/memory_limit.h"

namespace isoloop {
namespace {

constexpr Endian native_endian =
    std::endian::native == std::endian::big ? Endian::big : Endian::little;

template <class T>
void swap_bytes(std::span<T> values) {
  if constexpr (sizeof(T) > 1) {
    for (T& value : values) {
      const auto bytes = std::as_writable_bytes(std::span<T, 1>(&value, 1));
      std::reverse(bytes.begin(), bytes.end());
    }
  }
}

RawLayout layout_for(const std::filesystem::path& path, const RawOptions& options) {
  const std::optional<RawLayout> named = layout_from_name(path);
  const std::string hint = "; name the file NAME_256x256x128_uint8.raw or give ";
  if (!options.dims && !named) {
    throw InvalidArgument(path.string() + ": a raw file does not state its dimensions" + hint +
                          "--dims (and --type)");
  }
  if (!options.type && !named) {
    throw InvalidArgument(path.string() + ": a raw file does not state its voxel type" + hint +
                          "--type");
  }
  return {options.dims ? *options.dims : named->dims, options.type ? *options.type : named->type};
}

void check_spacing(const std::filesystem::path& path, const Vec3& spacing) {
  for (const double length : spacing) {
    if (!std::isfinite(length) || length <= 0.0) {
      throw InvalidArgument(path.string() + ": the spacing (--spacing) must be positive, not " +
                            std::to_string(length));
    }
  }
}

std::uint64_t file_size_of(const std::filesystem::path& path) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (error) throw InvalidInput(path.string() + ": cannot be read: " + error.message());
  return size;
}

void check_file_size(const std::filesystem::path& path, const RawLayout& layout, std::uint64_t skip,
                     std::uint64_t voxel_bytes) {
  const std::uint64_t found = file_size_of(path);
  if (found >= skip && found - skip == voxel_bytes) return;
  const bool fits = skip <= std::numeric_limits<std::uint64_t>::max() - voxel_bytes;
  const std::string expected = fits ? std::to_string(skip + voxel_bytes) : "more";
  const std::string after = skip > 0 ? " after " + std::to_string(skip) + " skipped bytes" : "";
  throw InvalidInput(path.string() + ": the file has " + std::to_string(found) + " bytes, but " +
                     dims_text(layout.dims) + " voxels of " + type_name(layout.type) + after +
                     " take " + expected +
                     "; check --dims, --type and --skip, or fetch the file again");
}

template <class T>
VoxelArray read_values(std::istream& file, const std::filesystem::path& path, std::uint64_t count,
                       Endian endian) {
  std::vector<T> values(count);
  const auto bytes = static_cast<std::streamsize>(count * sizeof(T));
  if (!file.read(reinterpret_cast<char*>(values.data()), bytes)) {
    throw InvalidInput(path.string() + ": reading stopped after " + std::to_string(file.gcount()) +
                       " of " + std::to_string(bytes) + " voxel bytes; fetch the file again");
  }
  if (endian != native_endian) swap_bytes<T>(values);
  return values;
}

VoxelArray read_values(std::istream& file, const std::filesystem::path& path,
                       const RawLayout& layout, std::uint64_t count, Endian endian) {
  switch (layout.type) {
    case VoxelType::uint8:
      return read_values<std::uint8_t>(file, path, count, endian);
    case VoxelType::int8:
      return read_values<std::int8_t>(file, path, count, endian);
    case VoxelType::uint16:
      return read_values<std::uint16_t>(file, path, count, endian);
    case VoxelType::int16:
      return read_values<std::int16_t>(file, path, count, endian);
    case VoxelType::uint32:
      return read_values<std::uint32_t>(file, path, count, endian);
    case VoxelType::int32:
      return read_values<std::int32_t>(file, path, count, endian);
    case VoxelType::float32:
      return read_values<float>(file, path, count, endian);
    case VoxelType::float64:
      return read_values<double>(file, path, count, endian);
  }
  throw InvalidArgument(path.string() + ": unknown voxel type");
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
                std::uint64_t max_bytes) {
  const RawLayout layout = layout_for(path, options);
  check_spacing(path, options.spacing);
  const std::uint64_t voxel_size = bytes_per_voxel(layout.type);
  const std::uint64_t bytes = checked_voxel_bytes(layout.dims, voxel_size, path.string());
  check_file_size(path, layout, options.skip, bytes);
  check_voxel_memory(layout.dims, voxel_size, max_bytes, path.string());
  std::ifstream file(path, std::ios::binary);
  if (!file.seekg(static_cast<std::streamoff>(options.skip))) {
    throw InvalidInput(path.string() + ": cannot be opened; check that you may read it");
  }
  Volume volume;
  volume.values = read_values(file, path, layout, bytes / voxel_size, options.endian);
  volume.dims = layout.dims;
  volume.spacing = options.spacing;
  return volume;
}

void write_raw(std::ostream& out, const Volume& volume) {
  std::visit(
      [&]<class T>(const std::vector<T>& values) {
        const auto put = [&](std::span<const T> voxels) {
          out.write(reinterpret_cast<const char*>(voxels.data()),
                    static_cast<std::streamsize>(voxels.size_bytes()));
        };
        if constexpr (native_endian == Endian::little) {
          put(values);
        } else {
          std::vector<T> swapped = values;
          swap_bytes<T>(swapped);
          put(swapped);
        }
      },
      volume.values);
}

}  // namespace isoloop
