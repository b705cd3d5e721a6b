// DICOM: a folder of slices, one file each.
#pragma once

#include <filesystem>

#include "volume/base/memory_limit.h"
#include "volume/voxels/placement.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// Reads the slices of one series in a folder (where it holds none itself, in the folders within
/// it), or a single slice, in the order of their positions along the slices' normal. Values are
/// scaled by the rescale slope and intercept (of CT: Hounsfield units). The frame is `lps`. Several
/// slices at each position are frames, in the order of their instance numbers. Lengths are in mm
/// unless options.spacing is given. A warning says where the distances between slices differ by
/// more than 1 %. With options.spacing given a missing slice is a warning too. Throws
/// InvalidArgument (several series, which the message lists, and options.series, part of an
/// identifier, number or description, does not choose one; several frames), LimitExceeded, and
/// InvalidInput: a file that is cut short, holds no pixels, or is no DICOM file though it has no
/// other extension; a distance between slices of 1.5 times the usual (a slice is missing); slices
/// that do not fit together; colour, multi-frame files and compressed pixels; a placement that
/// place() refuses.
Volume read_dicom(const std::filesystem::path& path, const FormatOptions& options = {},
                  const VoxelLimits& limits = {});

struct DicomSeries {
  std::string id;           // what options.series chooses it by
  std::string description;  // may be empty
  std::size_t slices = 0;
};

/// The series of the folder's slices, in the order of their identifiers. Throws InvalidInput as
/// read_dicom() does.
std::vector<DicomSeries> dicom_series(const std::filesystem::path& folder);

/// Whether a file of the folder is a DICOM file.
bool holds_dicom(const std::filesystem::path& folder);

/// Whether a file of the folders within it, at any depth, is one.
bool holds_dicom_within(const std::filesystem::path& folder);

}  // namespace isoloop
