// What tests ask of a sentence.
#pragma once

#include <string>

namespace isoloop::test {

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace isoloop::test
