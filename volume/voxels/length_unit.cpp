#include "volume/voxels/length_unit.h"

#include <array>

#include "volume/base/header_text.h"

namespace isoloop {
namespace {

struct Spelling {
  std::string_view text;
  std::string_view name;
  double metres;
};

// In small letters; the micro sign is there as U+00B5, as the Greek letter, as ImageJ escapes it
// and as a byte of Latin-1.
constexpr std::array<Spelling, 29> spellings{{{"m", "m", 1.0},
                                              {"meter", "m", 1.0},
                                              {"metre", "m", 1.0},
                                              {"dm", "dm", 1e-1},
                                              {"cm", "cm", 1e-2},
                                              {"centimeter", "cm", 1e-2},
                                              {"mm", "mm", 1e-3},
                                              {"millimeter", "mm", 1e-3},
                                              {"millimetre", "mm", 1e-3},
                                              {"um", "µm", 1e-6},
                                              {"\xc2\xb5m", "µm", 1e-6},
                                              {"\xce\xbcm", "µm", 1e-6},
                                              {"\\u00b5m", "µm", 1e-6},
                                              {"\xb5m", "µm", 1e-6},
                                              {"micron", "µm", 1e-6},
                                              {"microns", "µm", 1e-6},
                                              {"micrometer", "µm", 1e-6},
                                              {"micrometre", "µm", 1e-6},
                                              {"nm", "nm", 1e-9},
                                              {"nanometer", "nm", 1e-9},
                                              {"nanometre", "nm", 1e-9},
                                              {"pm", "pm", 1e-12},
                                              {"km", "km", 1e3},
                                              {"\xc3\x85", "Å", 1e-10},
                                              {"angstrom", "Å", 1e-10},
                                              {"in", "inch", 0.0254},
                                              {"inch", "inch", 0.0254},
                                              {"inches", "inch", 0.0254},
                                              {"ft", "ft", 0.3048}}};

}  // namespace

std::optional<LengthUnit> length_unit(std::string_view spelling) {
  const std::string wanted = lower_case(trimmed(spelling));
  for (const auto& [text, name, metres] : spellings) {
    if (wanted == text) return LengthUnit{std::string(name), metres};
  }
  return std::nullopt;
}

}  // namespace isoloop
