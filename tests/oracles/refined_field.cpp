#include "tests/oracles/refined_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "tests/oracles/refined_cube.h"
#include "tests/oracles/swept_cube.h"

namespace isoloop::testing {
namespace {

/// Smooths along one axis; periodic.
void smooth(SmallVolume& volume, int axis, const std::vector<double>& weights) {
  const std::int64_t n = volume.dims[axis];
  std::int64_t step = 1;
  for (int a = 0; a < axis; ++a) step *= volume.dims[a];
  const auto reach = static_cast<std::int64_t>(weights.size()) - 1;
  std::vector<double> line(static_cast<std::size_t>(n));
  for (std::int64_t start = 0; start < static_cast<std::int64_t>(volume.values.size()); ++start) {
    if (start / step % n != 0) continue;
    double* values = volume.values.data() + start;
    for (std::int64_t i = 0; i < n; ++i) {
      double sum = 0.0;
      for (std::int64_t d = -reach; d <= reach; ++d)
        sum +=
            weights[static_cast<std::size_t>(std::abs(d))] * values[((i + d) % n + n) % n * step];
      line[static_cast<std::size_t>(i)] = sum;
    }
    for (std::int64_t i = 0; i < n; ++i) values[i * step] = line[static_cast<std::size_t>(i)];
  }
}

class Field {
 public:
  explicit Field(const SmallVolume& volume) : volume_(volume) {}

  RefinedEuler layer(std::int64_t z) const {
    RefinedEuler sum;
    for (std::int64_t y = -1; y < volume_.dims[1]; ++y)
      for (std::int64_t x = -1; x < volume_.dims[0]; ++x) add({x, y, z}, sum);
    return sum;
  }

 private:
  double value(const Index3& p) const {
    for (int a = 0; a < 3; ++a)
      if (p[a] < 0 || p[a] >= volume_.dims[a]) return -1.0;
    return volume_
        .values[static_cast<std::size_t>(p[0] + volume_.dims[0] * (p[1] + volume_.dims[1] * p[2]))];
  }

  /// The cube, face, edge or vertex at p that spans the axes of `span`, as a cube constant along
  /// the others.
  std::array<double, 8> values(const Index3& p, unsigned span) const {
    std::array<double, 8> corners{};
    for (unsigned c = 0; c < 8; ++c) {
      Index3 q = p;
      for (unsigned a = 0; a < 3; ++a) q[a] += c >> a & span >> a & 1U;
      corners[c] = value(q);
    }
    return corners;
  }

  static std::int64_t euler_of(const std::array<double, 8>& corners, bool& resolved) {
    for (const int steps : {8, 16, 31})
      if (const auto euler = oracle::converged_euler(corners, steps)) return *euler;
    resolved = false;
    const oracle::SweptCube swept = oracle::sweep(corners);
    return swept.parts[1] - swept.cycles[1];
  }

  void add(const Index3& p, RefinedEuler& sum) const {
    for (unsigned span = 0; span < 8; ++span) {
      const std::array<double, 8> corners = values(p, span);
      const auto inside =
          std::count_if(corners.begin(), corners.end(), [](double v) { return v >= 0; });
      if (inside == 0) continue;
      const bool is_ambiguous_face = [&] {
        if (span != 3 && span != 5 && span != 6) return false;
        const unsigned a = span & (~span + 1U);
        const unsigned b = span ^ a;
        const auto is_in = [&](unsigned c) { return corners[c] >= 0; };
        return is_in(0) == is_in(span) && is_in(a) == is_in(b) && is_in(0) != is_in(a);
      }();
      std::int64_t euler = 1;
      bool resolved = true;
      if (is_ambiguous_face || (span == 7 && inside < 8)) euler = euler_of(corners, resolved);
      if (span == 7 && inside < 8) {
        ++sum.cubes;
        sum.unresolved += resolved ? 0 : 1;
      }
      const bool odd = span == 1 || span == 2 || span == 4 || span == 7;
      sum.euler += odd ? -euler : euler;
    }
  }

  const SmallVolume& volume_;
};

}  // namespace

SmallVolume gaussian_field(const Index3& dims, double sigma, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  SmallVolume volume{std::vector<double>(static_cast<std::size_t>(dims[0] * dims[1] * dims[2])),
                     dims};
  for (double& value : volume.values) value = normal(random);
  std::vector<double> weights;
  for (int d = 0; d <= std::ceil(4 * sigma); ++d)
    weights.push_back(std::exp(-d * d / (2 * sigma * sigma)));
  for (int axis = 0; axis < 3; ++axis) smooth(volume, axis, weights);
  const double mean = std::accumulate(volume.values.begin(), volume.values.end(), 0.0) /
                      static_cast<double>(volume.values.size());
  double largest = 0.0;
  for (double& value : volume.values) largest = std::max(largest, std::abs(value -= mean));
  for (double& value : volume.values) value /= largest;
  return volume;
}

RefinedEuler refined_euler(const SmallVolume& volume) {
  const Field field(volume);
  RefinedEuler sum = tbb::parallel_reduce(
      tbb::blocked_range<std::int64_t>(-1, volume.dims[2]), RefinedEuler{},
      [&](const tbb::blocked_range<std::int64_t>& layers, RefinedEuler part) {
        for (std::int64_t z = layers.begin(); z < layers.end(); ++z) {
          const RefinedEuler layer = field.layer(z);
          part = {part.euler + layer.euler, part.cubes + layer.cubes,
                  part.unresolved + layer.unresolved};
        }
        return part;
      },
      [](const RefinedEuler& a, const RefinedEuler& b) {
        return RefinedEuler{a.euler + b.euler, a.cubes + b.cubes, a.unresolved + b.unresolved};
      });
  // Open cells summed with sign (-1)^dimension: cubes come out negative in three dimensions.
  sum.euler = -sum.euler;
  return sum;
}

}  // namespace isoloop::testing
