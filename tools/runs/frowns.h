// What a person would frown at in a run: the voxels, the level and the counts as warnings.
#pragma once

#include <string>
#include <vector>

#include "tools/runs/run_result.h"

namespace isoloop {

/// The file states no spacing, so that lengths are in voxels; empty if it does, or the flags do.
std::string spacing_note(const RunInput& run, bool stated_by_flag);

/// The values look like labels, although an iso value was stated; empty if not.
std::string label_warning(const RunInput& run, bool iso_is_stated);

/// The share of the voxels at the border of the volume that are inside, from 0 to 1.
double inside_share_of_border(const RunInput& run);

/// One sentence each: the solid fills the border all along; more than a thousand tunnels.
std::vector<std::string> count_warnings(const RunInput& run, const Analysis& analysis);

}  // namespace isoloop
