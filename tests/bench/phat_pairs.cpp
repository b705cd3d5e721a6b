// What a user of PHAT would run on a volume: all persistence pairs of its cubical complex, voxels
// as vertices, cells entering with the last of theirs. Prints the loops alive at the iso value.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <numeric>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include <phat/algorithms/twist_reduction.h>
#include <phat/boundary_matrix.h>
#include <phat/compute_persistence_pairs.h>
#include <phat/persistence_pairs.h>
#include <phat/representations/default_representations.h>

#include "core/grid/level.h"
#include "volume/files/read.h"

namespace {

/// Cells by their place in a grid of 2n - 1 points along each axis; odd coordinates have extent.
struct Cells {
  std::array<std::int64_t, 3> dims{};
  std::vector<double> enters;  // minus the level of the last voxel that the cell asks for
  std::vector<std::uint8_t> dimension;
};

std::vector<double> levels_of(const isoloop::AnyGridView& grid, const isoloop::IsoLevel& level) {
  std::vector<double> levels;
  std::visit(
      [&](const auto& view) {
        for (const auto value : view.values) levels.push_back(isoloop::level_of(value, level));
      },
      grid);
  return levels;
}

Cells make_cells(const std::vector<double>& levels, const isoloop::Index3& dims) {
  Cells cells;
  for (std::size_t a = 0; a < 3; ++a) cells.dims[a] = 2 * dims[a] - 1;
  const auto& [nx, ny, nz] = cells.dims;
  const auto count = static_cast<std::size_t>(nx * ny * nz);
  cells.enters.reserve(count);
  cells.dimension.reserve(count);
  for (std::int64_t z = 0; z < nz; ++z)
    for (std::int64_t y = 0; y < ny; ++y)
      for (std::int64_t x = 0; x < nx; ++x) {
        double lowest =
            levels[static_cast<std::size_t>(x / 2 + dims[0] * (y / 2 + dims[1] * (z / 2)))];
        for (std::int64_t k = z / 2; k <= (z + 1) / 2; ++k)
          for (std::int64_t j = y / 2; j <= (y + 1) / 2; ++j)
            for (std::int64_t i = x / 2; i <= (x + 1) / 2; ++i)
              lowest = std::min(lowest,
                                levels[static_cast<std::size_t>(i + dims[0] * (j + dims[1] * k))]);
        cells.enters.push_back(-lowest);
        cells.dimension.push_back(static_cast<std::uint8_t>(x % 2 + y % 2 + z % 2));
      }
  return cells;
}

phat::boundary_matrix<phat::bit_tree_pivot_column> boundary_of(
    const Cells& cells, const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  phat::boundary_matrix<phat::bit_tree_pivot_column> matrix;
  matrix.set_num_cols(static_cast<phat::index>(order.size()));
  const std::array<std::int64_t, 3> stride{1, cells.dims[0], cells.dims[0] * cells.dims[1]};
  std::vector<phat::index> column;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    const std::int64_t cell = order[i];
    column.clear();
    for (std::size_t a = 0; a < 3; ++a) {
      if (cell / stride[a] % cells.dims[a] % 2 == 0) continue;
      column.push_back(place[static_cast<std::size_t>(cell - stride[a])]);
      column.push_back(place[static_cast<std::size_t>(cell + stride[a])]);
    }
    std::sort(column.begin(), column.end());
    matrix.set_dim(i, cells.dimension[static_cast<std::size_t>(cell)]);
    matrix.set_col(i, column);
  }
  return matrix;
}

std::size_t loops_alive(const Cells& cells) {
  std::vector<std::uint32_t> order(cells.enters.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(cells.enters[a], cells.dimension[a], a) <
           std::tuple(cells.enters[b], cells.dimension[b], b);
  });
  auto matrix = boundary_of(cells, order);
  phat::persistence_pairs pairs;
  phat::compute_persistence_pairs<phat::twist_reduction>(pairs, matrix);
  std::size_t alive = 0;
  for (phat::index i = 0; i < pairs.get_num_pairs(); ++i) {
    const auto [birth, death] = pairs.get_pair(i);
    const auto born = order[static_cast<std::size_t>(birth)];
    const auto dead = order[static_cast<std::size_t>(death)];
    if (cells.dimension[born] == 1 && cells.enters[born] <= 0.0 && cells.enters[dead] > 0.0)
      ++alive;
  }
  return alive;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: isoloop_bench_phat FILE ISO above|below\n";
    return 2;
  }
  try {
    const isoloop::Volume volume = isoloop::read_volume(argv[1]);
    const isoloop::IsoLevel level{std::atof(argv[2]), argv[3] == std::string("below")
                                                          ? isoloop::InsideRule::below
                                                          : isoloop::InsideRule::above};
    const Cells cells = make_cells(levels_of(isoloop::view(volume), level), volume.dims);
    std::cout << loops_alive(cells) << " loops alive\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 3;
  }
}
