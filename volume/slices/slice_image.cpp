#include "volume/slices/slice_image.h"

#include <vector>

#include "core/base/errors.h"
#include "volume/base/memory_limit.h"

namespace isoloop {

std::string slice_text(const SliceImage& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + " " +
         type_name(static_cast<VoxelType>(image.type)) +
         (image.white_is_zero ? ", 0 is white" : "");
}

std::uint64_t slice_bytes(const SliceImage& image, const std::string& what) {
  if (image.width < 1 || image.height < 1)
    throw InvalidInput({.file = what, .text = "is an image of no size"});
  return checked_voxel_bytes({image.width, image.height, 1}, bytes_per_voxel(image.type), what);
}

VoxelArray zero_voxels(StoredType type, std::size_t count) {
  switch (type) {
    case StoredType::uint8:
      return std::vector<std::uint8_t>(count);
    case StoredType::int8:
      return std::vector<std::int8_t>(count);
    case StoredType::uint16:
      return std::vector<std::uint16_t>(count);
    case StoredType::int16:
      return std::vector<std::int16_t>(count);
    case StoredType::uint32:
      return std::vector<std::uint32_t>(count);
    case StoredType::int32:
      return std::vector<std::int32_t>(count);
    case StoredType::float32:
      return std::vector<float>(count);
    default:
      return std::vector<double>(count);
  }
}

}  // namespace isoloop
