#include "tools/runs/written_volume.h"

#include <algorithm>
#include <cstdint>

#include "core/base/errors.h"
#include "core/base/memory_budget.h"
#include "volume/base/file_kind.h"
#include "volume/base/memory_limit.h"
#include "volume/files/write.h"
#include "volume/formats/nifti.h"
#include "volume/formats/raw.h"

namespace isoloop {
namespace {

bool is_exact_as_float(VoxelType type) {
  return type == VoxelType::float32 || bytes_per_voxel(type) < sizeof(float);
}

bool is_written_as_floats(const std::string& name) {
  return file_format(name)->written == Written::as_floats;
}

}  // namespace

void check_written_format(const std::string& flag, const std::string& name) {
  if (is_written(name)) return;
  throw InvalidArgument(flag + ' ' + name + ": volumes are written as " + written_extensions());
}

void check_written(const std::string& flag, const std::string& name, const Volume& volume) {
  check_written_format(flag, name);
  const VoxelType type = voxel_type(volume.values);
  const auto layout = file_kind(name) == FileKind::raw ? layout_from_name(name) : std::nullopt;
  if (layout && (layout->dims != volume.dims || layout->type != type)) {
    throw InvalidArgument(flag + ' ' + name + " would hold " + dims_text(volume.dims) + ' ' +
                          type_name(type) + " voxels; name it so");
  }
  if (file_kind(name) == FileKind::nifti &&
      *std::max_element(volume.dims.begin(), volume.dims.end()) > most_nifti_voxels) {
    throw InvalidArgument(flag + ' ' + name + ": NIfTI holds " + std::to_string(most_nifti_voxels) +
                          " voxels along an axis at most; name a .nrrd");
  }
  if (is_written_as_floats(name) && !is_exact_as_float(type)) {
    throw InvalidArgument(flag + ' ' + name + ": OpenVDB grids are written as float, which would " +
                          "round " + type_name(type) + " voxels; name a .nrrd");
  }
}

void check_writer_memory(const std::string& stage, const std::string& name, const RunInput& run) {
  if (!is_written_as_floats(name)) return;
  constexpr std::uint64_t bytes_per_voxel = 8;  // floats, all of them and in the tree
  check_memory(stage.c_str(), checked_voxel_bytes(run.volume.dims, bytes_per_voxel, run.file),
               run.cost.max_bytes);
}

void warn_of_left_out(RunInput& run, const std::string& name) {
  for (const Finding& finding : left_out_of(run.volume, name))
    run.volume.warnings.push_back(finding);
}

}  // namespace isoloop
