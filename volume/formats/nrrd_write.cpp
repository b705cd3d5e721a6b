#include <ostream>
#include <string>

#include "volume/base/number_words.h"
#include "volume/formats/nrrd.h"
#include "volume/formats/raw.h"

namespace isoloop {
namespace {

void write_vector(std::ostream& out, const Vec3& v, double length) {
  for (std::size_t c = 0; c < 3; ++c) out << (c == 0 ? '(' : ',') << word_of_number(v[c] * length);
  out << ')';
}

std::string type_text(const VoxelArray& values) {
  switch (voxel_type(values)) {
    case VoxelType::float32:
      return "float";
    case VoxelType::float64:
      return "double";
    default:
      return type_name(values);
  }
}

const char* space_text(Frame frame) {
  switch (frame) {
    case Frame::lps:
      return "space: left-posterior-superior\n";
    case Frame::ras:
      return "space: right-anterior-superior\n";
    default:
      return "space dimension: 3\n";
  }
}

void write_units(std::ostream& out, const char* field, const std::string& unit) {
  if (unit.empty()) return;
  out << field;
  for (int axis = 0; axis < 3; ++axis) out << " \"" << unit << '"';
  out << '\n';
}

void write_placement(std::ostream& out, const Volume& volume) {
  if (volume.frame == Frame::index) {
    out << "spacings:";
    for (const double length : volume.spacing) out << ' ' << word_of_number(length);
    out << '\n';
    write_units(out, "units:", volume.unit);
    return;
  }
  out << space_text(volume.frame) << "space directions:";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    out << ' ';
    write_vector(out, volume.direction[axis], volume.spacing[axis]);
  }
  out << "\nspace origin: ";
  write_vector(out, volume.origin, 1.0);
  out << '\n';
  write_units(out, "space units:", volume.unit);
}

}  // namespace

void write_nrrd(std::ostream& out, const Volume& volume) {
  out << "NRRD0004\ntype: " << type_text(volume.values) << "\ndimension: 3\n";
  write_placement(out, volume);
  out << "sizes: " << volume.dims[0] << ' ' << volume.dims[1] << ' ' << volume.dims[2]
      << "\nkinds: domain domain domain\nendian: little\nencoding: raw\n\n";
  write_raw(out, volume);
}

}  // namespace isoloop
