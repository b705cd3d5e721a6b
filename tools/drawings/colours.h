// The colours of loops, the same in every file.
#pragma once

#include <array>
#include <cstdint>

#include "isoloop/loop.h"

namespace isoloop {

using Colour = std::array<std::uint8_t, 3>;  // red, green, blue

constexpr Colour colour_of(LoopKind kind) {
  switch (kind) {
    case LoopKind::handle:
      return {0, 160, 40};
    case LoopKind::tunnel:
      return {220, 20, 20};
    case LoopKind::loop:
      break;
  }
  return {30, 90, 230};
}

}  // namespace isoloop
