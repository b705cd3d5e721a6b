// The scanner's log beside slices: Bruker SkyScan's, which states the size of a pixel.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/grid/grid.h"

namespace isoloop {

struct SliceLog {
  std::filesystem::path file{};
  Vec3 spacing{1.0, 1.0, 1.0};  // µm per voxel
};

/// The spacing that the logs state: "Pixel Size (um)" of a section [Reconstruction], times "Section
/// to Section Step" along z, else "Image Pixel Size (um)" of any section. Nothing where none states
/// one. Where they disagree, nothing, and `warning` says so. Logs are read up to 1 MiB each.
std::optional<SliceLog> read_slice_logs(const std::vector<std::filesystem::path>& logs,
                                        std::optional<Finding>& warning);

}  // namespace isoloop
