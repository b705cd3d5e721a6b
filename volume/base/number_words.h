// Numbers in text headers, as they are written.
#pragma once

#include <array>
#include <charconv>
#include <string>

#include "isoloop/grid.h"

namespace isoloop {

/// The shortest decimal that reads back as `number`.
inline std::string word_of_number(double number) {
  std::array<char, 32> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), number == 0.0 ? 0.0 : number).ptr;
  return {digits.data(), end};
}

/// Three of them, blanks between.
inline std::string words_of_numbers(const Vec3& numbers) {
  return word_of_number(numbers[0]) + ' ' + word_of_number(numbers[1]) + ' ' +
         word_of_number(numbers[2]);
}

}  // namespace isoloop
