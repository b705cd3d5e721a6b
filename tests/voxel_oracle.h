// Betti numbers of a set of voxels, counted in the plainest way: shares no code with core/.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace isoloop::oracle {

using Offset = std::array<int, 3>;

/// 1 = in the set. (i, j, k) is at i + dims[0] * (j + dims[1] * k). The border must be 0.
struct Mask {
  std::vector<std::uint8_t> voxels;
  std::array<std::int64_t, 3> dims{};
};

inline std::int64_t offset_in(const Mask& mask, const Offset& o) {
  return o[0] + mask.dims[0] * (o[1] + mask.dims[1] * o[2]);
}

/// Components of the voxels equal to `value` under these neighbours.
inline std::int64_t count_components(Mask mask, std::uint8_t value,
                                     const std::vector<Offset>& neighbours) {
  constexpr std::uint8_t seen = 2;
  std::int64_t components = 0;
  std::vector<std::int64_t> stack;
  const auto count = static_cast<std::int64_t>(mask.voxels.size());
  for (std::int64_t start = 0; start < count; ++start) {
    if (mask.voxels[static_cast<std::size_t>(start)] != value) continue;
    ++components;
    mask.voxels[static_cast<std::size_t>(start)] = seen;
    stack.push_back(start);
    while (!stack.empty()) {
      const std::int64_t v = stack.back();
      stack.pop_back();
      const std::array<std::int64_t, 3> at{v % mask.dims[0], v / mask.dims[0] % mask.dims[1],
                                           v / (mask.dims[0] * mask.dims[1])};
      for (const Offset& o : neighbours) {
        bool within = true;
        for (std::size_t a = 0; a < 3; ++a) {
          within = within && at[a] + o[a] >= 0 && at[a] + o[a] < mask.dims[a];
        }
        if (!within) continue;
        const std::int64_t w = v + offset_in(mask, o);
        if (mask.voxels[static_cast<std::size_t>(w)] != value) continue;
        mask.voxels[static_cast<std::size_t>(w)] = seen;
        stack.push_back(w);
      }
    }
  }
  return components;
}

/// All offsets in {-1, 0, 1}^3 but (0, 0, 0); `faces_only` keeps the six of length 1.
inline std::vector<Offset> neighbour_offsets(bool faces_only) {
  std::vector<Offset> offsets;
  for (int n = 0; n < 27; ++n) {
    const Offset o{n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
    const int length = o[0] * o[0] + o[1] * o[1] + o[2] * o[2];
    if (length > 0 && (!faces_only || length == 1)) offsets.push_back(o);
  }
  return offsets;
}

/// Voxels - pairs + 2x2 squares - 2x2x2 blocks that lie wholly in the set (6-connected).
inline std::int64_t euler_characteristic(const Mask& mask) {
  std::int64_t sum = 0;
  for (int span = 0; span < 8; ++span) {  // bit a: the block spans two voxels along axis a
    const Offset top{span & 1, span >> 1 & 1, span >> 2 & 1};
    const std::int64_t sign = (top[0] + top[1] + top[2]) % 2 == 0 ? 1 : -1;
    for (std::int64_t k = 0; k + top[2] < mask.dims[2]; ++k) {
      for (std::int64_t j = 0; j + top[1] < mask.dims[1]; ++j) {
        for (std::int64_t i = 0; i + top[0] < mask.dims[0]; ++i) {
          const std::int64_t at = i + mask.dims[0] * (j + mask.dims[1] * k);
          bool whole = true;
          for (int corner = 0; corner < 8 && whole; ++corner) {
            const Offset o{corner & 1 & top[0], corner >> 1 & top[1], corner >> 2 & top[2]};
            whole = mask.voxels[static_cast<std::size_t>(at + offset_in(mask, o))] == 1;
          }
          if (whole) sum += sign;
        }
      }
    }
  }
  return sum;
}

struct Betti {
  std::int64_t b0 = 0;
  std::int64_t b1 = 0;
  std::int64_t b2 = 0;
};

/// Inside by faces (6 neighbours), outside by corners too (26): the dual pair of adjacencies.
inline Betti count_betti(const Mask& mask) {
  Betti betti;
  betti.b0 = count_components(mask, 1, neighbour_offsets(true));
  betti.b2 = count_components(mask, 0, neighbour_offsets(false)) - 1;
  betti.b1 = betti.b0 + betti.b2 - euler_characteristic(mask);
  return betti;
}

}  // namespace isoloop::oracle
