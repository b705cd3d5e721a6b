// What was found, as data: what an error tells, and a note or a warning of a volume. The words that
// name flags are those of tools/words/sentence.h.
#pragma once

#include <string>
#include <vector>

namespace isoloop {

/// What a caller may state or choose; core and volume have options for these, a command has flags.
enum class Option {
  none,
  iso,
  boundary,
  loops,  // by number
  spacing,
  dims,
  voxel_type,
  grid,  // or array, by name
  frame,
  channel,
  series,
  transform,  // of two in a file
  labels,
  crop,
  world,
  voxel_size,  // of a mesh
  automatic_resolution,
  nan_value,
  shape,
};

/// What may be done about it.
enum class Advice {
  raise_memory_limit,
  raise_voxel_limit,
  take_part,
  take_smaller_volume,
  take_smaller_mesh,
  take_larger_voxels,
  halve_resolution,
  correct_header,
  check_raw_layout,
  name_raw_file,
  state_dims,
  state_voxel_type,
  state_spacing,
  override_spacing,  // what was taken in place of a spacing that is not stated
  resample,          // to right angles
  state_voxel_size,
  replace_nan,
  choose_grid,
  choose_frame,
  choose_channel,
  choose_frame_and_channel,
  choose_series,
  choose_sform,  // of NIfTI
  choose_qform,
  unpack_slices,  // of DICOM
  check_dims,     // where no limit is high enough
};

inline constexpr Option last_option = Option::shape;
inline constexpr Advice last_advice = Advice::check_dims;

struct Finding {
  std::string file{};            // whose it is: a path, or the name of a shape; may be empty
  std::string place{};           // where in it: "line 7", "voxel (0, 1, 2)"; may be empty
  Option about = Option::none;   // what the text begins with, where it is an option
  std::string text{};            // what is so, one sentence without a full stop, no flag in it
  std::vector<Advice> advice{};  // each is enough
};

/// "the frame", "the crop".
std::string name_of(Option option);

/// "FILE: PLACE: TEXT", what is there of it, for callers that have no flags; without the advice.
std::string text_of(const Finding& finding);

}  // namespace isoloop
