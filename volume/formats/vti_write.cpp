#include <array>
#include <cstdint>
#include <ostream>

#include "volume/base/number_words.h"
#include "volume/formats/raw.h"
#include "volume/formats/vti.h"

namespace isoloop {
namespace {

/// In the order of VoxelType.
constexpr std::array<const char*, 8> type_names{"UInt8",  "Int8",  "UInt16",  "Int16",
                                                "UInt32", "Int32", "Float32", "Float64"};

const char* type_text(const VoxelArray& values) { return type_names[values.index()]; }

void write_size(std::ostream& out, std::uint64_t bytes) {
  for (int i = 0; i < 8; ++i) out << static_cast<char>(bytes >> 8 * i & 0xffU);
}

}  // namespace

void write_vti(std::ostream& out, const Volume& volume) {
  const Index3& dims = volume.dims;
  const VoxelType type = voxel_type(volume.values);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" "
         "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <ImageData WholeExtent=\"";
  const auto write_extent = [&] {
    for (std::size_t a = 0; a < 3; ++a) out << (a == 0 ? "0 " : " 0 ") << dims[a] - 1;
  };
  write_extent();
  out << "\" Origin=\"" << words_of_numbers(volume.origin) << "\" Spacing=\""
      << words_of_numbers(volume.spacing) << "\" Direction=\"";
  // Row by row: its columns are the axes.
  for (std::size_t row = 0; row < 3; ++row)
    out << (row == 0 ? "" : " ")
        << words_of_numbers(
               {volume.direction[0][row], volume.direction[1][row], volume.direction[2][row]});
  out << "\">\n    <Piece Extent=\"";
  write_extent();
  const std::string name = volume.level_set ? "distance" : volume.mask ? "mask" : "values";
  out << "\">\n      <PointData Scalars=\"" << name << "\">\n        <DataArray type=\""
      << type_text(volume.values) << "\" Name=\"" << name
      << "\" format=\"appended\" offset=\"0\"/>\n      </PointData>\n    </Piece>\n  "
         "</ImageData>\n  <AppendedData encoding=\"raw\">\n_";
  write_size(out, static_cast<std::uint64_t>(dims[0] * dims[1] * dims[2]) * bytes_per_voxel(type));
  write_raw(out, volume);
  out << "\n  </AppendedData>\n</VTKFile>\n";
}

}  // namespace isoloop
