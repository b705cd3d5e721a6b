#include "core/scan/cube_sweep.h"

#include "core/base/errors.h"

namespace isoloop {

InplaceVector<Step, 14> ends_of_steps(const CubeRanks& ranks) {
  InplaceVector<Step, 14> ends;
  const auto insert = [&](Step end) {
    std::size_t at = ends.count++;
    for (; at > 0 && ends.items[at - 1] > end; --at) ends.items[at] = ends.items[at - 1];
    ends.items[at] = end;
  };
  for (const Step rank : ranks.corner) insert(rank);
  for (const Steps& joined : ranks.face_joined)
    if (!joined.empty()) insert(joined.last);
  return ends;
}

TunnelEnds tunnel_ends(std::uint8_t inside, std::uint8_t joined, int hub) {
  const CubeCut& plain = cube_cut(inside, joined, false);
  const CubeCut& cut = tunnel_cut(inside, joined, false, hub).cut;
  const unsigned side = inside >> hub & 1U;
  for (int corner = 0; corner < 8; ++corner) {
    const bool joined_by_tunnel = (inside >> corner & 1U) == side &&
                                  cut.cell_of_corner[corner] == cut.cell_of_corner[hub] &&
                                  plain.cell_of_corner[corner] != plain.cell_of_corner[hub];
    if (joined_by_tunnel)
      return {side == 1 ? Side::inside : Side::outside, static_cast<std::uint8_t>(hub),
              static_cast<std::uint8_t>(corner)};
  }
  throw SelfCheckFailed("a tunnel within a cube joins no two of its cells");
}

}  // namespace isoloop
