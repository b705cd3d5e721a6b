#include <array>
#include <ostream>

#include "volume/base/number_words.h"
#include "volume/formats/meta_image.h"
#include "volume/formats/raw.h"

namespace isoloop {
namespace {

/// In the order of VoxelType.
constexpr std::array<const char*, 8> type_names{"MET_UCHAR", "MET_CHAR",  "MET_USHORT",
                                                "MET_SHORT", "MET_UINT",  "MET_INT",
                                                "MET_FLOAT", "MET_DOUBLE"};

const char* type_text(const VoxelArray& values) { return type_names[values.index()]; }

}  // namespace

void write_meta_image(std::ostream& out, const Volume& volume) {
  const bool turns = volume.frame == Frame::ras;  // LPS is what the format has
  const auto in_lps = [&](const Vec3& v) { return turns ? Vec3{-v[0], -v[1], v[2]} : v; };
  out << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
         "CompressedData = False\nTransformMatrix =";
  for (const Vec3& axis : volume.direction) out << ' ' << words_of_numbers(in_lps(axis));
  out << "\nOffset = " << words_of_numbers(in_lps(volume.origin))
      << "\nElementSpacing = " << words_of_numbers(volume.spacing)
      << "\nDimSize = " << volume.dims[0] << ' ' << volume.dims[1] << ' ' << volume.dims[2]
      << "\nElementType = " << type_text(volume.values) << "\nElementDataFile = LOCAL\n";
  write_raw(out, volume);
}

}  // namespace isoloop
