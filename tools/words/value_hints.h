// What the values of a volume suggest: a mask, a label map, and the flags for them.
#pragma once

#include <string>

#include "volume/voxels/volume.h"

namespace isoloop {

/// Two values and no other.
bool is_mask(const ValueRange& range);

/// Whole numbers, three to most_distinct of them and not far apart.
bool is_label_map(const ValueRange& range);

/// Of a mask: that it is one, and the flags that read it so, for a note.
std::string mask_hint(const ValueRange& range);

/// What the values are, and the flags that go with them, for the message that --iso is missing.
std::string values_text(const ValueRange& range);

}  // namespace isoloop
