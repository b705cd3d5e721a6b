// One DICOM file: a slice, its place and its pixels.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "volume/voxels/stored_voxels.h"

namespace isoloop {

struct DicomSlice {
  std::filesystem::path path;
  std::string series;       // its identifier
  std::string description;  // of the series, for messages: number, modality, text
  std::int64_t instance = 0;
  VoxelLayout layout;    // one layer
  int stored_bits = 16;  // of each pixel
  int shift = 0;         // bits below them
  bool is_signed = false;
  std::uint64_t pixels_from = 0;                           // byte of the file
  Vec3 spacing{1.0, 1.0, 1.0};                             // length per column, row and slice
  std::optional<Vec3> position;                            // of the first pixel
  std::array<Vec3, 2> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}};  // along a row, along a column
};

/// Throws InvalidInput as read_dicom does of one file.
DicomSlice read_dicom_slice(const std::filesystem::path& path);

/// The stored values, not yet scaled. Throws InvalidInput if the file cannot be read.
VoxelArray read_pixels(const DicomSlice& slice);

}  // namespace isoloop
