// Lengths as they are typed: "20", in the unit of the spacing, or "20mm".
#pragma once

#include <string>
#include <string_view>

#include "volume/voxels/length_unit.h"
#include "volume/voxels/volume.h"

namespace isoloop {

struct TypedLength {
  double value = 0.0;
  std::string unit{};  // "mm" and the like, as length_unit() spells it; empty: the spacing's
};

/// A number, which may be infinite or negative but not NaN, and the unit after it if there is one.
/// Throws InvalidArgument naming the flag.
TypedLength parse_length(const std::string& flag, std::string_view text);

/// Whether the word is a number, or one with a unit of length after it.
bool is_length(std::string_view word);

/// In the unit of the volume's spacing. Throws InvalidArgument naming the flag where the length has
/// a unit and the volume states none.
double length_in(const TypedLength& length, const Volume& volume, const std::string& flag);

/// "0.5 0.5 1" and "mm" of "0.5 0.5 1mm" or "0.5mm 0.5mm 1mm"; the unit is empty if none is typed.
/// Throws InvalidArgument for two units, or for what is no unit.
struct UnitOfText {
  std::string text{};
  std::string unit{};
};
UnitOfText split_unit(const std::string& flag, std::string_view text);

}  // namespace isoloop
