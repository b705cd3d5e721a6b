#include "tests/oracles/random_volumes.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace isoloop::testing {
namespace {

std::size_t voxel_count(const Index3& dims) {
  return static_cast<std::size_t>(dims[0] * dims[1] * dims[2]);
}

/// Distance from a circle of radius `ring` about `center` in the plane of axes (a, b).
double from_circle(const Vec3& p, const Vec3& center, int a, int b, double ring) {
  const int c = 3 - a - b;
  const double radial = std::hypot(p[a] - center[a], p[b] - center[b]) - ring;
  return std::hypot(radial, p[c] - center[c]);
}

Vec3 middle(const Index3& dims) {
  // Off the grid's own symmetry, so that few sizes are equal.
  return {static_cast<double>(dims[0] - 1) / 2 + 0.03, static_cast<double>(dims[1] - 1) / 2 - 0.04,
          static_cast<double>(dims[2] - 1) / 2 + 0.05};
}

double least_extent(const Index3& dims) {
  return static_cast<double>(*std::min_element(dims.begin(), dims.end()));
}

}  // namespace

SmallVolume sampled(const Index3& dims,
                    const std::function<double(double, double, double)>& value) {
  SmallVolume volume{{}, dims};
  for (std::int64_t z = 0; z < dims[2]; ++z)
    for (std::int64_t y = 0; y < dims[1]; ++y)
      for (std::int64_t x = 0; x < dims[0]; ++x)
        volume.values.push_back(
            value(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)));
  return volume;
}

SmallVolume white_noise(const Index3& dims, std::uint32_t seed) {
  std::mt19937 random(seed);
  SmallVolume volume{std::vector<double>(voxel_count(dims)), dims};
  for (double& value : volume.values) value = 2.0 * random() / 4294967295.0 - 1.0;
  return volume;
}

SmallVolume smooth_noise(const Index3& dims, std::uint32_t seed, int rounds) {
  SmallVolume volume = white_noise(dims, seed);
  for (int round = 0; round < rounds; ++round) {
    const SmallVolume before = volume;
    volume = sampled(dims, [&](double x, double y, double z) {
      double sum = 0.0;
      for (int d = 0; d < 27; ++d) {
        Index3 p{static_cast<std::int64_t>(x) + d % 3 - 1,
                 static_cast<std::int64_t>(y) + d / 3 % 3 - 1,
                 static_cast<std::int64_t>(z) + d / 9 - 1};
        for (int a = 0; a < 3; ++a) p[a] = std::clamp<std::int64_t>(p[a], 0, dims[a] - 1);
        sum += before.values[static_cast<std::size_t>(p[0] + dims[0] * (p[1] + dims[1] * p[2]))];
      }
      return sum;
    });
  }
  std::vector<double> sorted = volume.values;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  for (double& value : volume.values) value -= sorted[sorted.size() / 2] + 1e-9;
  return volume;
}

SmallVolume noise_of_some_size(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto length = [&] { return static_cast<std::int64_t>(16 + random() % 9); };
  const Index3 dims{length(), length(), length()};
  return smooth_noise(dims, seed, 1 + static_cast<int>(random() % 3));
}

SmallVolume torus(const Index3& dims, double ring, double tube) {
  const double n = least_extent(dims);
  return sampled(dims, [&](double x, double y, double z) {
    return tube * n - from_circle({x, y, z}, middle(dims), 0, 1, ring * n);
  });
}

SmallVolume torus_shell(const Index3& dims) {
  const double n = least_extent(dims);
  return sampled(dims, [&](double x, double y, double z) {
    const double r = from_circle({x, y, z}, middle(dims), 0, 1, 0.26 * n);
    return std::min(0.2 * n - r, r - 0.08 * n);
  });
}

SmallVolume linked_tori(const Index3& dims) {
  const double n = least_extent(dims);
  const double ring = 0.2 * n;
  Vec3 left = middle(dims);
  Vec3 right = left;
  left[0] -= ring / 2;
  right[0] += ring / 2;
  return sampled(dims, [&](double x, double y, double z) {
    const Vec3 p{x, y, z};
    return 0.07 * n - std::min(from_circle(p, left, 0, 1, ring), from_circle(p, right, 0, 2, ring));
  });
}

SmallVolume from_bits(const Index3& dims, std::uint32_t bits) {
  SmallVolume volume{std::vector<double>(voxel_count(dims)), dims};
  for (std::size_t n = 0; n < volume.values.size(); ++n)
    volume.values[n] = (bits >> n & 1U) != 0 ? 1.0 : -1.0;
  return volume;
}

SmallVolume transformed(const SmallVolume& volume, const std::array<int, 3>& permutation,
                        const std::array<bool, 3>& flip) {
  Index3 dims{};
  for (int a = 0; a < 3; ++a) dims[a] = volume.dims[permutation[a]];
  return sampled(dims, [&](double x, double y, double z) {
    const std::array<double, 3> q{x, y, z};
    Index3 p{};
    for (int a = 0; a < 3; ++a) {
      const auto i = static_cast<std::int64_t>(q[a]);
      p[permutation[a]] = flip[a] ? dims[a] - 1 - i : i;
    }
    return volume
        .values[static_cast<std::size_t>(p[0] + volume.dims[0] * (p[1] + volume.dims[1] * p[2]))];
  });
}

}  // namespace isoloop::testing
