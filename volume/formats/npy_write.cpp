#include <algorithm>
#include <array>
#include <ostream>
#include <string>

#include "volume/formats/npy.h"
#include "volume/formats/raw.h"

namespace isoloop {
namespace {

bool is_of_bools(const Volume& volume) {
  const auto* const values = std::get_if<std::vector<std::uint8_t>>(&volume.values);
  return volume.mask && values != nullptr &&
         std::all_of(values->begin(), values->end(), [](std::uint8_t v) { return v <= 1; });
}

/// In the order of VoxelType.
constexpr std::array<const char*, 8> type_names{"|u1", "|i1", "<u2", "<i2",
                                                "<u4", "<i4", "<f4", "<f8"};

const char* type_text(const VoxelArray& values) { return type_names[values.index()]; }

}  // namespace

void write_npy(std::ostream& out, const Volume& volume) {
  const Index3& dims = volume.dims;
  std::string header = std::string("{'descr': '") +
                       (is_of_bools(volume) ? "|b1" : type_text(volume.values)) +
                       "', 'fortran_order': False, 'shape': (" + std::to_string(dims[2]) + ", " +
                       std::to_string(dims[1]) + ", " + std::to_string(dims[0]) + "), }";
  // Voxels begin at a multiple of 64 bytes; ten come before this text, and a newline ends it.
  header.append(63 - (header.size() + 10) % 64, ' ');
  header += '\n';
  const auto size = static_cast<unsigned>(header.size());
  out << "\x93NUMPY" << '\x01' << '\x00' << static_cast<char>(size & 0xffU)
      << static_cast<char>(size >> 8U) << header;
  write_raw(out, volume);
}

}  // namespace isoloop
