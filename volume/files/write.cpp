#include "volume/files/write.h"

#include "core/base/errors.h"
#include "volume/base/atomic_file.h"
#include "volume/base/file_kind.h"
#include "volume/base/number_words.h"
#include "volume/formats/meta_image.h"
#include "volume/formats/nifti.h"
#include "volume/formats/npy.h"
#include "volume/formats/nrrd.h"
#include "volume/formats/raw.h"
#include "volume/formats/vti.h"
#include "volume/vdb/vdb.h"

namespace isoloop {

void write_volume(const Volume& volume, const std::filesystem::path& path) {
  if (!is_written(path)) {
    throw InvalidArgument(
        {.file = path.string(), .text = "volumes are written as " + written_extensions()});
  }
  AtomicFile file(path);
  write_volume(file.stream(), volume, path);
  file.commit();
}

void write_volume(std::ostream& out, const Volume& volume, const std::filesystem::path& path) {
  switch (file_kind(path).value_or(FileKind::raw)) {
    case FileKind::vdb:
      write_vdb(out, volume, path.string());
      break;
    case FileKind::nrrd:
      write_nrrd(out, volume);
      break;
    case FileKind::nifti:
      write_nifti(out, volume, path.string(), extension_of(path).ends_with(".gz"));
      break;
    case FileKind::meta_image:
      write_meta_image(out, volume);
      break;
    case FileKind::npy:
      write_npy(out, volume);
      break;
    case FileKind::vti:
      write_vti(out, volume);
      break;
    default:
      write_raw(out, volume);
  }
}

std::vector<Finding> left_out_of(const Volume& volume, const std::filesystem::path& path) {
  std::vector<Finding> findings;
  const FileFormat* const format = file_format(path);
  if (format == nullptr) return findings;
  const std::string name = "a " + extension_of(path) + " file";
  const auto add = [&](const std::string& text) {
    findings.push_back({.file = path.string(), .text = text});
  };
  if (volume.level_set && format->kind != FileKind::vdb)
    add(name +
        " does not say that the voxels are distances of a level set: read it with iso 0, "
        "and what is below as inside");
  if (format->written_frame == WrittenFrame::none) {
    if (volume.frame != Frame::index || volume.spacing != Vec3{1.0, 1.0, 1.0}) {
      add(name + " says nothing of where voxels lie: the spacing " +
          words_of_numbers(volume.spacing) + " and the place are left out");
    }
    return findings;
  }
  const std::string stated = frame_name(volume.frame);
  const bool is_medical = volume.frame == Frame::lps || volume.frame == Frame::ras;
  if (format->written_frame == WrittenFrame::world && is_medical)
    add(name + " does not say that its coordinates are " + stated);
  const bool has_place =
      volume.frame == Frame::world ||
      (volume.frame == Frame::index && format->written_frame == WrittenFrame::lps);
  if (has_place &&
      (format->written_frame == WrittenFrame::ras || format->written_frame == WrittenFrame::lps)) {
    add("coordinates in " + name + " are " +
        (format->written_frame == WrittenFrame::ras ? "RAS" : "LPS") +
        ", which the volume, of frame " + stated + ", does not say of its own");
  }
  if (!format->writes_unit && !volume.unit.empty())
    add(name + " has no unit of lengths: that they are in " + volume.unit + " is left out");
  return findings;
}

}  // namespace isoloop
