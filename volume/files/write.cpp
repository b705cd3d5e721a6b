#include "volume/files/write.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

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
#include "volume/voxels/value_range.h"

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

namespace {

/// What is found missing, one sentence each.
class Losses {
 public:
  Losses(const Volume& volume, const std::filesystem::path& path, const FileFormat& format)
      : volume_(volume), path_(path), format_(format), name_("a " + extension_of(path) + " file") {}

  std::vector<Finding> all() && {
    add_meaning();
    if (format_.written_frame == WrittenFrame::none) {
      if (volume_.frame != Frame::index || volume_.spacing != Vec3{1.0, 1.0, 1.0})
        add(name_ + " says nothing of where voxels lie: the spacing " +
            words_of_numbers(volume_.spacing) + " and the place are left out");
    } else {
      add_frame();
    }
    const bool is_nifti = format_.kind == FileKind::nifti;
    if (is_nifti) add_rounding();
    const bool has_unit = is_nifti ? nifti_has_unit(volume_.unit) : format_.writes_unit;
    if (!has_unit && !volume_.unit.empty())
      add(name_ + " cannot state that lengths are in " + volume_.unit + ": that is left out");
    return std::move(findings_);
  }

 private:
  void add(const std::string& text) { findings_.push_back({.file = path_.string(), .text = text}); }

  void add_meaning() {
    const bool is_vdb = format_.kind == FileKind::vdb;
    if (volume_.level_set && !is_vdb)
      add(name_ +
          " does not say that the voxels are distances of a level set: read it with iso 0, "
          "and what is below as inside");
    if (!volume_.level_set && is_vdb)
      add("where " + name_ + " is read, a layer of its least value, " +
          word_of_number(value_range(volume_).min) + ", lies round the voxels");
  }

  void add_frame() {
    const std::string stated = frame_name(volume_.frame);
    const bool is_medical = volume_.frame == Frame::lps || volume_.frame == Frame::ras;
    const WrittenFrame written = format_.written_frame;
    if (written == WrittenFrame::world && is_medical)
      add(name_ + " does not say that its coordinates are " + stated);
    // A place without a name gets one; NIfTI alone can leave the place out.
    const bool is_named = (written == WrittenFrame::ras && volume_.frame == Frame::world) ||
                          (written == WrittenFrame::lps && !is_medical);
    if (is_named)
      add("coordinates in " + name_ + " are " + (written == WrittenFrame::ras ? "RAS" : "LPS") +
          ", which the volume, of frame " + stated + ", does not say of its own");
  }

  /// NIfTI has floats for the place.
  void add_rounding() {
    constexpr double most = 1e-3;  // of a voxel
    double largest = 0.0;
    for (std::size_t row = 0; row < 3; ++row) {
      double rounded = std::abs(volume_.origin[row] - static_cast<float>(volume_.origin[row]));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double step = volume_.direction[axis][row] * volume_.spacing[axis];
        rounded +=
            std::abs(step - static_cast<float>(step)) * static_cast<double>(volume_.dims[axis]);
      }
      largest = std::max(largest, rounded);
    }
    const double voxel = *std::min_element(volume_.spacing.begin(), volume_.spacing.end());
    if (volume_.frame != Frame::index && largest > most * voxel)
      add(name_ + " states the place in numbers of 32 bits, which moves voxels by up to " +
          word_of_number(largest));
  }

  const Volume& volume_;
  const std::filesystem::path& path_;
  const FileFormat& format_;
  std::string name_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> left_out_of(const Volume& volume, const std::filesystem::path& path) {
  const FileFormat* const format = file_format(path);
  if (format == nullptr) return {};
  return Losses(volume, path, *format).all();
}

}  // namespace isoloop
