// Units of length as programs spell them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace isoloop {

struct LengthUnit {
  std::string name;     // "mm", "µm" and the like, as reports print it
  double metres = 1.0;  // of one
};

/// The unit that "um", "micron", "µm", ImageJ's "\u00B5m", … stand for; nothing for what is no unit
/// of length, such as "pixel".
std::optional<LengthUnit> length_unit(std::string_view spelling);

}  // namespace isoloop
