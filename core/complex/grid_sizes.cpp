#include "core/complex/grid_sizes.h"

namespace isoloop {

float GridSizes::of_piece_near_surface(std::uint32_t piece) const {
  float largest = 0.0F;
  for (const std::uint32_t edge : complex_.edges_of(piece))
    largest = std::max(largest, of_edge(edge));
  return largest;
}

}  // namespace isoloop
