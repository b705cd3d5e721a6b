// Random volumes of few levels, most voxels at the iso value, through the whole pipeline.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/base/threads.h"
#include "tests/oracles/swept_volume.h"

namespace isoloop::testing {

struct TiedVolume {
  std::vector<std::int16_t> values;
  Index3 dims{};
  Vec3 spacing{};
  IsoLevel level;

  GridView<std::int16_t> view() const { return {values, dims, spacing}; }
};

/// 3 to 12 voxels a side, three to five values round the iso value, any rule and topology, spacings
/// from 10^-3 to 10^3.
inline TiedVolume tied_volume(std::uint32_t seed) {
  std::mt19937 random(seed);
  TiedVolume volume;
  for (std::int64_t& n : volume.dims) n = 3 + random() % 10;
  const auto exponent = [&] { return 6.0 * random() / 4294967295.0 - 3.0; };
  const double all = std::pow(10.0, exponent());
  for (double& length : volume.spacing) length = seed % 3 == 0 ? all : std::pow(10.0, exponent());
  const int values = 3 + static_cast<int>(random() % 3);
  volume.values.resize(static_cast<std::size_t>(volume.dims[0] * volume.dims[1] * volume.dims[2]));
  for (std::int16_t& value : volume.values)
    value = static_cast<std::int16_t>(
        random() % 2 == 0 ? 40 : 40 - values / 2 + static_cast<int>(random() % values));
  volume.level.iso = 40;
  volume.level.inside = random() % 2 == 0 ? InsideRule::above : InsideRule::below;
  constexpr std::array<Topology, 5> topologies{Topology::trilinear, Topology::simple,
                                               Topology::connected_6, Topology::connected_18,
                                               Topology::connected_26};
  volume.level.topology = topologies[random() % topologies.size()];
  return volume;
}

/// By the oracle that goes with the topology.
inline oracle::Betti slow_betti(const TiedVolume& volume) {
  const int sign = volume.level.inside == InsideRule::above ? 1 : -1;
  std::vector<double> levels;
  for (const std::int16_t value : volume.values)
    levels.push_back(sign * (static_cast<double>(value) - volume.level.iso));
  const Topology topology = volume.level.topology;
  if (topology == Topology::trilinear || topology == Topology::simple)
    return oracle::count_by_sweep(levels, volume.dims, topology == Topology::simple, 0x1p-16);
  oracle::Mask mask{.voxels = {}, .dims = {}};
  for (std::size_t a = 0; a < 3; ++a) mask.dims[a] = volume.dims[a] + 2;
  mask.voxels.resize(static_cast<std::size_t>(mask.dims[0] * mask.dims[1] * mask.dims[2]));
  for (std::size_t n = 0; n < levels.size(); ++n) {
    const auto at = static_cast<std::int64_t>(n);
    const std::int64_t i = at % volume.dims[0] + 1;
    const std::int64_t j = at / volume.dims[0] % volume.dims[1] + 1;
    const std::int64_t k = at / volume.dims[0] / volume.dims[1] + 1;
    mask.voxels[static_cast<std::size_t>(i + mask.dims[0] * (j + mask.dims[1] * k))] =
        levels[n] >= 0 ? 1 : 0;
  }
  const int adjacency = topology == Topology::connected_6    ? 6
                        : topology == Topology::connected_18 ? 18
                                                             : 26;
  return oracle::count_betti(mask, adjacency);
}

/// Whether both name the same loops, point by point.
inline bool same_loops(const Analysis& a, const Analysis& b) {
  return std::equal(a.loops.begin(), a.loops.end(), b.loops.begin(), b.loops.end(),
                    [](const Loop& p, const Loop& q) {
                      return p.curves == q.curves && p.length == q.length && p.size == q.size &&
                             p.center_index == q.center_index;
                    });
}

/// What is wrong with the loops and counts of a volume; empty if nothing is. Adds the number of
/// loops to `loops`.
template <class Count>
std::string complaint_about(const TiedVolume& volume, Count& loops) {
  const auto run = [&](int threads) {
    return with_threads(threads, [&] { return analyze(volume.view(), volume.level); });
  };
  try {
    const Analysis analysis = run(1);
    if (!same_loops(analysis, run(4))) return "other loops with four threads";
    const oracle::Betti expected = slow_betti(volume);
    const Betti& found = analysis.betti;
    if (found.b0 != expected.b0 || found.b1 != expected.b1 || found.b2 != expected.b2)
      return "counts " + std::to_string(found.b0) + " " + std::to_string(found.b1) + " " +
             std::to_string(found.b2) + " for " + std::to_string(expected.b0) + " " +
             std::to_string(expected.b1) + " " + std::to_string(expected.b2);
    if (static_cast<std::int64_t>(analysis.loops.size()) != 2 * expected.b1)
      return "not all loops are there";
    for (const Loop& loop : analysis.loops)
      for (const auto& points : drawn_curves(analysis.surface, loop))
        for (const Vec3& p : points)
          for (std::size_t a = 0; a < 3; ++a)
            if (!(p[a] > -1.0 && p[a] < static_cast<double>(volume.dims[a])))
              return "a point off the volume";
    loops += analysis.loops.size();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace isoloop::testing
