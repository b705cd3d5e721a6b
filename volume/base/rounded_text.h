// Numbers as messages print them.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace isoloop {

/// To this many significant digits (1 to 17), without zeros at the end: "0.125", "1e-07".
inline std::string rounded_text(double number, int digits = 6) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, number);
  return text.data();
}

}  // namespace isoloop
