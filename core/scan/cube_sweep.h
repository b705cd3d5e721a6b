// How the cut of one cube changes as the iso value runs through its range, step by step.
//
// Steps are ordered so that the solid shrinks: a corner of rank r is inside at the steps before r.
// An ambiguous face, whose inside corners come apart once, is joined during one stretch of steps:
// the levels of its inside corners fall from step to step and those of the others fall too, so the
// product of the first shrinks and that of the second grows. Between two ranks or ends of stretches
// the cut is the same; only an interior tunnel asks at every step.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/inplace_vector.h"
#include "core/cube/cube.h"
#include "core/cube/cube_interior.h"

namespace isoloop {

using Step = std::uint16_t;

/// The steps first ... last - 1.
struct Steps {
  Step first = 0;
  Step last = 0;

  bool empty() const { return first >= last; }
  bool has(Step step) const { return first <= step && step < last; }
};

struct CubeRanks {
  std::array<Step, 8> corner{};        // the corner is inside at the steps before
  std::array<Steps, 6> face_joined{};  // steps at which the face is ambiguous and joined

  std::uint8_t inside_at(Step step) const {
    unsigned bits = 0;
    for (unsigned c = 0; c < 8; ++c) bits |= (step < corner[c] ? 1U : 0U) << c;
    return static_cast<std::uint8_t>(bits);
  }
  std::uint8_t joined_at(Step step) const {
    unsigned bits = 0;
    for (unsigned f = 0; f < 6; ++f) bits |= (face_joined[f].has(step) ? 1U : 0U) << f;
    return static_cast<std::uint8_t>(bits);
  }
};

/// Where the cut may change: all ranks and ends of stretches, ascending.
InplaceVector<Step, 14> ends_of_steps(const CubeRanks& ranks);

/// A tunnel joins the cells of one side at two corners of a cube.
struct TunnelEnds {
  Side side = Side::inside;
  std::uint8_t hub = 0;
  std::uint8_t partner = 0;
};

/// The cells that the tunnel at `hub` joins; `inside` and `joined` as for cube_cut().
TunnelEnds tunnel_ends(std::uint8_t inside, std::uint8_t joined, int hub);

/// Calls add_discs(steps, number of discs) for all steps at which M passes through the cube, and
/// add_tunnel(step, ends) for each step at which the interpolant has an interior tunnel there.
/// `levels_at(step)`: the corners' levels; nullptr where tunnels do not count (Topology::simple).
template <class LevelsAt, class AddDiscs, class AddTunnel>
void sweep_cube(const CubeRanks& ranks, const LevelsAt* levels_at, const AddDiscs& add_discs,
                const AddTunnel& add_tunnel) {
  const auto ends = ends_of_steps(ranks);
  for (std::size_t i = 0; i + 1 < ends.count; ++i) {
    const Steps steps{ends[i], ends[i + 1]};
    if (steps.empty()) continue;
    const std::uint8_t inside = ranks.inside_at(steps.first);
    const std::uint8_t joined = ranks.joined_at(steps.first);
    const CubeCut& plain = cube_cut(inside, joined, false);
    add_discs(steps, int{plain.disc_count});
    if (levels_at == nullptr || plain.hubs.count == 0) continue;
    for (Step step = steps.first; step < steps.last; ++step) {
      const auto hub = tunnel_hub(plain, (*levels_at)(step));
      if (!hub) continue;
      const CubeCut& cut = tunnel_cut(inside, joined, false, *hub).cut;
      add_discs(Steps{step, static_cast<Step>(step + 1)}, cut.disc_count - plain.disc_count);
      add_tunnel(step, tunnel_ends(inside, joined, *hub));
    }
  }
}

}  // namespace isoloop
