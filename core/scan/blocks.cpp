#include "core/scan/blocks.h"

#include <algorithm>
#include <variant>

#include <tbb/parallel_for.h>

namespace isoloop {
namespace {

constexpr double largest = 1e30;  // whose sum over a block is a number

template <class T>
float mean_of(const GridView<T>& grid, const Index3& first, std::int64_t side) {
  Index3 last{};
  for (int a = 0; a < 3; ++a) last[a] = std::min(first[a] + side, grid.dims[a]);
  double sum = 0.0;
  for (std::int64_t z = first[2]; z < last[2]; ++z)
    for (std::int64_t y = first[1]; y < last[1]; ++y) {
      const std::int64_t row = grid.dims[0] * (y + grid.dims[1] * z);
      for (std::int64_t x = first[0]; x < last[0]; ++x)
        sum += std::clamp(static_cast<double>(grid.values[row + x]), -largest, largest);
    }
  const std::int64_t count = (last[0] - first[0]) * (last[1] - first[1]) * (last[2] - first[2]);
  return static_cast<float>(sum / static_cast<double>(count));
}

}  // namespace

Blocks means_of_blocks(const AnyGridView& any_grid, std::int64_t side) {
  return std::visit(
      [side](const auto& grid) {
        Blocks blocks;
        for (int a = 0; a < 3; ++a) blocks.dims[a] = (grid.dims[a] + side - 1) / side;
        const std::int64_t layer = blocks.dims[0] * blocks.dims[1];
        blocks.values.resize(static_cast<std::size_t>(layer * blocks.dims[2]));
        tbb::parallel_for(std::int64_t{0}, blocks.dims[2], [&](std::int64_t z) {
          float* to = blocks.values.data() + layer * z;
          for (std::int64_t y = 0; y < blocks.dims[1]; ++y)
            for (std::int64_t x = 0; x < blocks.dims[0]; ++x)
              *to++ = mean_of(grid, {x * side, y * side, z * side}, side);
        });
        return blocks;
      },
      any_grid);
}

}  // namespace isoloop
