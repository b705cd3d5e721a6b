#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <tbb/parallel_for.h>

#include "core/sizes/closest.h"
#include "core/sizes/point_tree.h"

namespace isoloop {
namespace {

constexpr std::uint32_t largest_side = 16;  // of a block, lattice vertices
constexpr std::uint32_t least_side = 4;
constexpr std::size_t few = 24;  // vertices: for so many no smaller block pays

/// A vertex of the octree.
struct Place {
  std::uint32_t vertex;
  std::array<std::uint8_t, 3> at;  // from the lowest vertex of the largest block
};

/// Some vertices of M as seen from there, in single precision; units of length.
struct Rivals {
  std::vector<std::uint32_t> vertices;   // of M; ascending
  std::array<std::vector<float>, 3> at;  // by axis, then rival
  std::vector<std::int32_t> squared{};   // distances, as bits: they compare as these do

  std::size_t nearest(const std::array<float, 3>& place) {
    std::int32_t least = std::numeric_limits<std::int32_t>::max();
    squared.resize(vertices.size());
    for (std::size_t i = 0; i < squared.size(); ++i) {
      const float x = at[0][i] - place[0];
      const float y = at[1][i] - place[1];
      const float z = at[2][i] - place[2];
      squared[i] = std::bit_cast<std::int32_t>(x * x + y * y + z * z);
      least = std::min(least, squared[i]);
    }
    return static_cast<std::size_t>(std::find(squared.begin(), squared.end(), least) -
                                    squared.begin());
  }

  /// Those of `all` that may be nearest to a place within `half` of `center`, of which `nearest`
  /// is the nearest to the center itself: see PointTree::find_rivals().
  void filter(const Rivals& all, const std::array<float, 3>& center,
              const std::array<float, 3>& half, std::size_t nearest) {
    constexpr float rounding = 1e-4F;  // of the terms: far more than there is
    const auto from_center = [&](std::size_t i) {
      const float x = all.at[0][i] - center[0];
      const float y = all.at[1][i] - center[1];
      const float z = all.at[2][i] - center[2];
      return x * x + y * y + z * z;
    };
    const float least = from_center(nearest);
    vertices.clear();
    for (std::vector<float>& along : at) along.clear();
    for (std::size_t i = 0; i < all.vertices.size(); ++i) {
      float gain = least;
      for (std::size_t a = 0; a < 3; ++a)
        gain += 2.0F * half[a] * std::abs(all.at[a][i] - all.at[a][nearest]);
      if (from_center(i) * (1.0F - rounding) > gain * (1.0F + rounding)) continue;
      vertices.push_back(all.vertices[i]);
      for (std::size_t a = 0; a < 3; ++a) at[a].push_back(all.at[a][i]);
    }
  }
};

/// A layer of the largest blocks, one after another.
class LayerOfBlocks {
 public:
  LayerOfBlocks(const Octree& octree, const Surface& surface, const PointTree& tree,
                std::uint32_t layer, std::span<std::uint32_t> closest)
      : octree_(octree), surface_(surface), tree_(tree), closest_(closest) {
    const auto& dims = octree_.lattice().dims;
    first_[2] = layer * largest_side;
    for (first_[1] = 0; first_[1] < dims[1]; first_[1] += largest_side)
      for (first_[0] = 0; first_[0] < dims[0]; first_[0] += largest_side) run();
  }

 private:
  /// Of the largest block.
  void run() {
    std::vector<Place>& places = tiers_[0].places;
    gather(places);
    if (places.empty()) return;
    constexpr double half = (largest_side - 1) / 2.0;
    Vec3 center{};
    for (std::size_t a = 0; a < 3; ++a) center[a] = origin(a) + half;
    guess_ = tree_.nearest(center, guess_);
    Rivals& rivals = tiers_[0].rivals;
    tree_.find_rivals(center, {half, half, half}, guess_, rivals.vertices);
    for (std::size_t a = 0; a < 3; ++a) {
      rivals.at[a].clear();
      for (const std::uint32_t vertex : rivals.vertices)
        rivals.at[a].push_back(
            static_cast<float>(surface_.spacing[a] * (surface_.points[vertex][a] - origin(a))));
    }
    settle(0, {0, 0, 0}, largest_side);
  }

  void gather(std::vector<Place>& places) const {
    places.clear();
    const Lattice& lattice = octree_.lattice();
    std::array<std::uint32_t, 3> count{};
    for (std::size_t a = 0; a < 3; ++a)
      count[a] = std::min(largest_side, lattice.dims[a] - first_[a]);
    for (std::uint32_t z = 0; z < count[2]; ++z)
      for (std::uint32_t y = 0; y < count[1]; ++y) {
        const std::uint32_t row = lattice.vertex(first_[0], first_[1] + y, first_[2] + z);
        std::uint64_t bits = octree_.corner_bits(row) & ((1U << count[0]) - 1);
        if (bits == 0) continue;
        std::uint32_t vertex = octree_.vertex_at(row);
        for (; bits != 0; bits &= bits - 1)
          places.push_back({vertex++,
                            {static_cast<std::uint8_t>(std::countr_zero(bits)),
                             static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(z)}});
      }
  }

  /// Voxel index of the lowest vertex of the largest block.
  double origin(std::size_t axis) const {
    return static_cast<double>(octree_.lattice().first[axis]) + first_[axis];
  }

  std::array<float, 3> scaled(const std::array<float, 3>& at) const {
    std::array<float, 3> point{};
    for (std::size_t a = 0; a < 3; ++a) point[a] = static_cast<float>(surface_.spacing[a] * at[a]);
    return point;
  }

  /// All places of a tier, which lie in a block that begins at `first`.
  void settle(std::size_t tier, const std::array<std::uint32_t, 3>& first, std::uint32_t side) {
    auto& [places, rivals] = tiers_[tier];
    if (places.size() <= few || side == least_side) {
      for (const auto& [vertex, at] : places)
        closest_[vertex] = rivals.vertices[rivals.nearest(scaled(
            {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])}))];
      return;
    }
    const std::uint32_t half_side = side / 2;
    const float half = static_cast<float>(half_side - 1) / 2.0F;
    for (std::uint32_t child = 0; child < 8; ++child) {
      std::array<std::uint32_t, 3> begin{};
      std::array<float, 3> center{};
      for (std::size_t a = 0; a < 3; ++a) {
        begin[a] = first[a] + (child >> a & 1U) * half_side;
        center[a] = static_cast<float>(begin[a]) + half;
      }
      auto& [some, their_rivals] = tiers_[tier + 1];
      some.clear();
      for (const Place& place : places)
        if (place.at[0] - begin[0] < half_side && place.at[1] - begin[1] < half_side &&
            place.at[2] - begin[2] < half_side)
          some.push_back(place);
      if (some.empty()) continue;
      their_rivals.filter(rivals, scaled(center), scaled({half, half, half}),
                          rivals.nearest(scaled(center)));
      settle(tier + 1, begin, half_side);
    }
  }

  /// A block's vertices, and the vertices of M that come into question for them.
  struct Tier {
    std::vector<Place> places;
    Rivals rivals;
  };

  const Octree& octree_;
  const Surface& surface_;
  const PointTree& tree_;
  std::span<std::uint32_t> closest_;
  std::array<std::uint32_t, 3> first_{};  // of the largest block at hand
  std::array<Tier, 3> tiers_;             // of it and the smaller blocks within
  std::uint32_t guess_ = 0;               // the nearest to the last one's center
};

}  // namespace

UnsetVector<std::uint32_t> closest_surface_vertices(const Octree& octree, const Surface& surface) {
  // The rings round tunnels are no vertices on grid edges.
  const PointTree tree(std::span(surface.points).first(surface.grid_edges.size()), surface.spacing);
  UnsetVector<std::uint32_t> closest(octree.vertex_count());
  const std::uint32_t layers = (octree.lattice().dims[2] + largest_side - 1) / largest_side;
  tbb::parallel_for(std::uint32_t{0}, layers, [&](std::uint32_t layer) {
    const LayerOfBlocks blocks(octree, surface, tree, layer, closest);
  });
  return closest;
}

}  // namespace isoloop
