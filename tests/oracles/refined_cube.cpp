#include "tests/oracles/refined_cube.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoloop::oracle {
namespace {

/// A set of samples; bit x of rows[(y + 1) + (n + 2) * (z + 1)] is the sample (x, y, z). The rows
/// round the cube are empty.
struct Samples {
  explicit Samples(int count)
      : n(count), rows(static_cast<std::size_t>(count + 2) * static_cast<std::size_t>(count + 2)) {}

  std::size_t place(int y, int z) const {
    const int at = (y + 1) + (n + 2) * (z + 1);
    return static_cast<std::size_t>(at);
  }
  std::uint64_t& row(int y, int z) { return rows[place(y, z)]; }
  std::uint64_t row(int y, int z) const { return rows[place(y, z)]; }

  int n;
  std::vector<std::uint64_t> rows;
};

std::array<Samples, 2> sample(const std::array<double, 8>& f, int steps) {
  std::array<Samples, 2> sides{Samples(steps + 1), Samples(steps + 1)};
  for (int z = 0; z <= steps; ++z)
    for (int y = 0; y <= steps; ++y) {
      const auto along = [&](int x) {
        const auto mixed = [&](int a, int b, int at) {
          return (f[static_cast<std::size_t>(a)] * (steps - at) +
                  f[static_cast<std::size_t>(b)] * at) /
                 steps;
        };
        return (mixed(x, x + 2, y) * (steps - z) + mixed(x + 4, x + 6, y) * z) / steps;
      };
      const double first = along(0);
      const double last = along(1);
      for (int x = 0; x <= steps; ++x) {
        const bool inside = first * (steps - x) + last * x >= 0;
        sides[inside ? 1 : 0].row(y, z) |= std::uint64_t{1} << x;
      }
    }
  return sides;
}

/// Calls visit(y, z) for the rows from `first` on that neighbour row (y, z).
template <class Visit>
void for_each_neighbour(int y, int z, bool corners_join, const Visit& visit) {
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      if ((dy != 0 || dz != 0) && (corners_join || dy == 0 || dz == 0)) visit(y + dy, z + dz);
}

int count_parts(Samples left, bool corners_join) {
  int parts = 0;
  Samples part(left.n);
  std::vector<std::array<int, 2>> todo;
  const auto grow = [&](int y, int z, std::uint64_t seeds) {
    const std::uint64_t free = left.row(y, z);
    std::uint64_t reached = seeds & free;
    if (reached == 0) return;
    for (std::uint64_t before = 0; before != reached;) {
      before = reached;
      reached |= (reached << 1 | reached >> 1) & free;
    }
    left.row(y, z) &= ~reached;
    part.row(y, z) = reached;
    todo.push_back({y, z});
  };
  for (int z = 0; z < left.n; ++z)
    for (int y = 0; y < left.n; ++y)
      while (left.row(y, z) != 0) {
        ++parts;
        grow(y, z, left.row(y, z) & (~left.row(y, z) + 1));
        while (!todo.empty()) {
          const auto [from_y, from_z] = todo.back();
          todo.pop_back();
          std::uint64_t seeds = part.row(from_y, from_z);
          part.row(from_y, from_z) = 0;
          if (corners_join) seeds |= seeds << 1 | seeds >> 1;
          for_each_neighbour(from_y, from_z, corners_join,
                             [&](int to_y, int to_z) { grow(to_y, to_z, seeds); });
        }
      }
  return parts;
}

/// Voxels joined by faces: samples - pairs + squares - blocks that lie in the set.
int chi_by_faces(const Samples& set) {
  int chi = 0;
  for (int z = 0; z < set.n; ++z)
    for (int y = 0; y < set.n; ++y) {
      const std::uint64_t here = set.row(y, z);
      const std::uint64_t y_pair = here & set.row(y + 1, z);
      const std::uint64_t z_pair = here & set.row(y, z + 1);
      const std::uint64_t square = y_pair & set.row(y, z + 1) & set.row(y + 1, z + 1);
      const auto with_x = [](std::uint64_t bits) {
        return std::popcount(bits) - std::popcount(bits & bits >> 1);
      };
      chi += with_x(here) - with_x(y_pair) - with_x(z_pair) + with_x(square);
    }
  return chi;
}

/// Closed voxels: their vertices - edges + faces - voxels.
int chi_of_closed_voxels(const Samples& set) {
  int chi = 0;
  for (int z = -1; z < set.n; ++z)
    for (int y = -1; y < set.n; ++y) {
      const std::uint64_t here = set.row(y, z);
      const std::uint64_t y_pair = here | set.row(y + 1, z);
      const std::uint64_t z_pair = here | set.row(y, z + 1);
      const std::uint64_t square = y_pair | set.row(y, z + 1) | set.row(y + 1, z + 1);
      const auto with_x = [](std::uint64_t bits) {
        return std::popcount(bits | bits << 1) - std::popcount(bits);
      };
      chi += with_x(here) - with_x(y_pair) - with_x(z_pair) + with_x(square);
    }
  return chi;
}

}  // namespace

std::array<CubeParts, 2> refined_parts(const std::array<double, 8>& values, int steps) {
  std::array<CubeParts, 2> counts;
  const auto sides = sample(values, steps);
  for (std::size_t side = 0; side < 2; ++side) {
    counts[0][side] = {count_parts(sides[side], false), chi_by_faces(sides[side])};
    counts[1][side] = {count_parts(sides[side], true), chi_of_closed_voxels(sides[side])};
  }
  return counts;
}

std::optional<CubeParts> converged_parts(const std::array<double, 8>& values, int steps) {
  const auto coarse = refined_parts(values, steps);
  const auto fine = refined_parts(values, 2 * steps);
  if (coarse[0] != coarse[1] || fine[0] != fine[1] || coarse[0] != fine[0]) return std::nullopt;
  return coarse[0];
}

std::optional<int> converged_euler(const std::array<double, 8>& values, int steps) {
  const auto euler = [&](int n) -> std::optional<int> {
    const Samples inside = sample(values, n)[1];
    const int chi = chi_by_faces(inside);
    return chi == chi_of_closed_voxels(inside) ? std::optional(chi) : std::nullopt;
  };
  const std::optional<int> coarse = euler(steps);
  return coarse && coarse == euler(2 * steps) ? coarse : std::nullopt;
}

}  // namespace isoloop::oracle
