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

/// Those of the 26 neighbours of a voxel that share a face with it (6), an edge too (18) or a
/// corner too (26).
inline std::vector<Offset> neighbour_offsets(int adjacency) {
  const int longest = adjacency == 6 ? 1 : adjacency == 18 ? 2 : 3;
  std::vector<Offset> offsets;
  for (int n = 0; n < 27; ++n) {
    const Offset o{n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
    const int length = o[0] * o[0] + o[1] * o[1] + o[2] * o[2];
    if (length > 0 && length <= longest) offsets.push_back(o);
  }
  return offsets;
}

/// The inside voxels of the block of 1 or 2 voxels along each axis that begins at `at`; bit c of
/// the result is that at offset c.
inline unsigned block_bits(const Mask& mask, std::int64_t at, int span) {
  unsigned bits = 0;
  for (int corner = 0; corner < 8; ++corner) {
    if ((corner & ~span) != 0) continue;
    const Offset o{corner & 1, corner >> 1 & 1, corner >> 2 & 1};
    if (mask.voxels[static_cast<std::size_t>(at + offset_in(mask, o))] == 1) bits |= 1U << corner;
  }
  return bits;
}

/// Calls visit(span, bits) for every block within the box; bit a of `span`: two voxels along axis
/// a.
template <class Visit>
void for_each_block(const Mask& mask, const Visit& visit) {
  for (int span = 0; span < 8; ++span) {
    for (std::int64_t k = 0; k + (span >> 2) < mask.dims[2]; ++k) {
      for (std::int64_t j = 0; j + (span >> 1 & 1) < mask.dims[1]; ++j) {
        for (std::int64_t i = 0; i + (span & 1) < mask.dims[0]; ++i) {
          visit(span, block_bits(mask, i + mask.dims[0] * (j + mask.dims[1] * k), span));
        }
      }
    }
  }
}

/// 6: voxels - pairs + 2x2 squares - 2x2x2 blocks that lie wholly in the set. 26: corners - edges +
/// faces - cubes of the union of closed voxels. 18: as 26, but voxels that touch in a corner alone
/// have one each.
inline std::int64_t euler_characteristic(const Mask& mask, int adjacency = 6) {
  std::int64_t sum = 0;
  for_each_block(mask, [&](int span, unsigned bits) {
    const int long_axes = (span & 1) + (span >> 1 & 1) + (span >> 2);
    unsigned whole = 0;
    for (int corner = 0; corner < 8; ++corner) {
      if ((corner & ~span) == 0) whole |= 1U << corner;
    }
    const std::int64_t sign = long_axes % 2 == 0 ? 1 : -1;
    if (adjacency == 6) {
      if (bits == whole) sum += sign;
      return;
    }
    if (bits != 0) sum -= sign;
    const bool opposite = bits == 0x81U || bits == 0x42U || bits == 0x24U || bits == 0x18U;
    if (adjacency == 18 && span == 7 && opposite) ++sum;
  });
  return sum;
}

struct Betti {
  std::int64_t b0 = 0;
  std::int64_t b1 = 0;
  std::int64_t b2 = 0;
};

/// The outside is taken by the adjacency that goes with that of the inside: 26 with 6, else 6.
inline Betti count_betti(const Mask& mask, int adjacency = 6) {
  Betti betti;
  betti.b0 = count_components(mask, 1, neighbour_offsets(adjacency));
  betti.b2 = count_components(mask, 0, neighbour_offsets(adjacency == 6 ? 26 : 6)) - 1;
  betti.b1 = betti.b0 + betti.b2 - euler_characteristic(mask, adjacency);
  return betti;
}

}  // namespace isoloop::oracle
