#include "core/scan/volume_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <variant>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include "core/base/errors.h"
#include "core/base/memory_budget.h"
#include "core/grid/level.h"

namespace isoloop {
namespace {

void add_to(std::vector<std::int64_t>& differences, Steps steps, std::int64_t amount) {
  differences[steps.first] += amount;
  differences[steps.last] -= amount;
}

Lattice padded_lattice(const Index3& dims) {
  std::array<std::uint32_t, 3> padded{};
  std::uint64_t count = 1;
  for (int a = 0; a < 3; ++a) {
    const auto extent = static_cast<std::uint64_t>(dims[a]) + 2;
    if (extent > max_lattice_vertices || count * extent > max_lattice_vertices)
      throw LimitExceeded(
          {.text = "the volume has more than " + std::to_string(max_lattice_vertices) + " voxels",
           .advice = {Advice::take_part, Advice::halve_resolution}},
          {.unit = Excess::Unit::voxels, .limit = max_lattice_vertices});
    count *= extent;
    padded[a] = static_cast<std::uint32_t>(extent);
  }
  return make_lattice({-1, -1, -1}, padded);
}

/// Number of the first steps at which the value is inside. `isos` by step.
Step rank_of(double value, const std::vector<double>& isos, InsideRule rule) {
  const auto at = rule == InsideRule::above
                      ? std::upper_bound(isos.begin(), isos.end(), value)
                      : std::upper_bound(isos.begin(), isos.end(), value, std::greater<>());
  return static_cast<Step>(at - isos.begin());
}

template <class T>
class Sweeper {
 public:
  Sweeper(const GridView<T>& grid, std::span<const double> iso_values, const ScanOptions& options)
      : grid_(grid), options_(options) {
    std::int64_t count = 1;
    for (const std::int64_t n : grid.dims) count *= n;
    if (count <= 0 || static_cast<std::int64_t>(grid.values.size()) != count)
      throw InvalidArgument({.text = "the grid's dimensions do not fit its number of voxels"},
                            Option::dims);
    ranked_.lattice = padded_lattice(grid.dims);
    constexpr std::uint64_t bytes_per_voxel = 24;
    check_memory("scan", bytes_per_voxel * ranked_.lattice.vertex_count(), options.max_bytes);
    ranked_.isos.assign(iso_values.begin(), iso_values.end());
    if (options.inside == InsideRule::below) std::reverse(ranked_.isos.begin(), ranked_.isos.end());
    rank_vertices();
  }

  /// The scanner is spent.
  VolumeSweep sweep() {
    const std::uint32_t layers = ranked_.lattice.dims[2] - 1;
    std::vector<Joins> joins(layers);
    const StepSums sums = tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(0, layers), StepSums(ranked_.isos.size()),
        [&](const tbb::blocked_range<std::uint32_t>& slab, StepSums sum) {
          for (std::uint32_t z = slab.begin(); z < slab.end(); ++z) sweep_layer(z, sum, joins[z]);
          return sum;
        },
        [](StepSums a, const StepSums& b) {
          a.add(b);
          return a;
        });
    Joins all;
    for (Joins& layer : joins) {
      all.inside.insert(all.inside.end(), layer.inside.begin(), layer.inside.end());
      all.outside.insert(all.outside.end(), layer.outside.begin(), layer.outside.end());
      layer = {};
    }
    return {std::move(ranked_), sums, std::move(all)};
  }

 private:
  void rank_vertices() {
    const Lattice& lattice = ranked_.lattice;
    ranked_.rank.assign(lattice.vertex_count(), 0);
    constexpr std::int64_t none = -1;
    std::vector<std::int64_t> first_nan(static_cast<std::size_t>(grid_.dims[2]), none);
    tbb::parallel_for(std::int64_t{0}, grid_.dims[2], [&](std::int64_t z) {
      for (std::int64_t y = 0; y < grid_.dims[1]; ++y) {
        const std::int64_t row = grid_.dims[0] * (y + grid_.dims[1] * z);
        Step* const to = ranked_.rank.data() + lattice.vertex(1, static_cast<std::uint32_t>(y + 1),
                                                              static_cast<std::uint32_t>(z + 1));
        for (std::int64_t x = 0; x < grid_.dims[0]; ++x) {
          const auto value = static_cast<double>(grid_.values[row + x]);
          std::int64_t& nan = first_nan[static_cast<std::size_t>(z)];
          if (std::isnan(value) && nan == none) nan = x + grid_.dims[0] * y;
          to[x] = rank_of(value, ranked_.isos, options_.inside);
        }
      }
    });
    for (std::size_t z = 0; z < first_nan.size(); ++z)
      if (first_nan[z] != none)
        throw InvalidInput(
            {.place = "voxel (" + std::to_string(first_nan[z] % grid_.dims[0]) + ", " +
                      std::to_string(first_nan[z] / grid_.dims[0]) + ", " + std::to_string(z) + ")",
             .text = "NaN",
             .advice = {Advice::replace_nan}},
            Fault::not_finite);
  }

  IsoLevel level_at(Step step) const {
    return {ranked_.isos[step], options_.inside, options_.topology};
  }

  T value_at(std::uint32_t vertex) const {
    const Index3 voxel = ranked_.lattice.voxel_at(vertex);
    return grid_.values[voxel[0] + grid_.dims[0] * (voxel[1] + grid_.dims[1] * voxel[2])];
  }

  /// Corners of the face with this lowest corner, in ring order.
  std::array<std::uint32_t, 4> face_ring_at(std::uint32_t vertex, int axis) const {
    const auto [b, c] = cross_axes(axis);
    const std::uint32_t db = ranked_.lattice.stride[b];
    const std::uint32_t dc = ranked_.lattice.stride[c];
    return {vertex, vertex + db, vertex + db + dc, vertex + dc};
  }

  /// Steps at which the face is ambiguous and which of its diagonals then is inside: 0 or 1.
  struct Alternation {
    Steps steps;
    int inside_diagonal = 0;
  };

  Alternation alternation(const std::array<std::uint32_t, 4>& ring) const {
    const auto rank = [&](int i) { return ranked_.rank[ring[i]]; };
    const int diagonal = std::min(rank(0), rank(2)) > std::min(rank(1), rank(3)) ? 0 : 1;
    return {{std::max(rank(1 - diagonal), rank(3 - diagonal)),
             std::min(rank(diagonal), rank(diagonal + 2))},
            diagonal};
  }

  /// The share of the steps at which the inside corners are joined: its first ones.
  Steps joined_steps(const std::array<std::uint32_t, 4>& ring, Steps steps) const {
    std::array<T, 4> values{};
    for (int i = 0; i < 4; ++i) values[i] = value_at(ring[i]);
    const auto joined = [&](Step step) {
      std::array<double, 4> levels{};
      for (int i = 0; i < 4; ++i)
        levels[i] = deciding_level(level_of(values[i], level_at(step)), options_.topology);
      return inside_is_joined(levels);
    };
    Steps found{steps.first, steps.last};
    for (Step low = steps.first; low < found.last;) {
      const auto middle = static_cast<Step>(low + (found.last - low) / 2);
      if (joined(middle)) {
        low = static_cast<Step>(middle + 1);
      } else {
        found.last = middle;
      }
    }
    return found;
  }

  void sweep_layer(std::uint32_t z, StepSums& sums, Joins& joins) const {
    const Lattice& lattice = ranked_.lattice;
    for (std::uint32_t y = 0; y + 1 < lattice.dims[1]; ++y)
      for (std::uint32_t x = 0; x + 1 < lattice.dims[0]; ++x)
        sweep_vertex(lattice.vertex(x, y, z), sums, joins);
  }

  /// The cube at a vertex, and the three edges that leave the vertex. Those on the box's far faces
  /// lead from no vertex here; they are never cut.
  void sweep_vertex(std::uint32_t v, StepSums& sums, Joins& joins) const {
    const auto& stride = ranked_.lattice.stride;
    CubeRanks ranks;
    bool is_cut = false;
    for (unsigned c = 0; c < 8; ++c) {
      ranks.corner[c] = ranked_.rank[ranked_.lattice.corner(v, c)];
      is_cut = is_cut || ranks.corner[c] != ranks.corner[0];
    }
    if (!is_cut) return;
    for (int a = 0; a < 3; ++a) {
      const auto [low, high] = std::minmax(ranks.corner[0], ranks.corner[std::size_t{1} << a]);
      if (low < high) add_to(sums.cut_edges, {low, high}, 1);
    }
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2;
      const auto ring = face_ring_at(face % 2 == 0 ? v : v + stride[axis], axis);
      const Alternation ambiguous = alternation(ring);
      if (ambiguous.steps.empty()) continue;
      const Steps joined = joined_steps(ring, ambiguous.steps);
      ranks.face_joined[face] = joined;
      if (face % 2 != 0) continue;  // the next cube's lower face
      const int in = ambiguous.inside_diagonal;
      if (!joined.empty())
        joins.inside.push_back({ring[in], ring[in + 2], static_cast<Step>(joined.last - 1)});
      if (joined.last < ambiguous.steps.last)
        joins.outside.push_back({ring[1 - in], ring[3 - in], joined.last});
    }
    sweep_cut(v, ranks, sums, joins);
  }

  void sweep_cut(std::uint32_t v, const CubeRanks& ranks, StepSums& sums, Joins& joins) const {
    // Asked only where the cube lies within the grid: elsewhere there is no room for a tunnel.
    const auto levels_at = [&](Step step) {
      return corner_levels(grid_, level_at(step), ranked_.lattice.voxel_at(v));
    };
    sweep_cube(
        ranks, options_.topology == Topology::simple ? nullptr : &levels_at,
        [&](Steps steps, int discs) { add_to(sums.discs, steps, discs); },
        [&](Step step, const TunnelEnds& ends) {
          auto& list = ends.side == Side::inside ? joins.inside : joins.outside;
          list.push_back(
              {ranked_.lattice.corner(v, ends.hub), ranked_.lattice.corner(v, ends.partner), step});
        });
  }

  const GridView<T>& grid_;
  const ScanOptions& options_;
  RankedGrid ranked_;
};

}  // namespace

VolumeSweep sweep_volume(const AnyGridView& grid, std::span<const double> iso_values,
                         const ScanOptions& options) {
  const auto tell = [&](const char* stage, double share) {
    if (options.progress) options.progress(stage, share);
  };
  return std::visit(
      [&]<class T>(const GridView<T>& view) {
        tell("values", 0.0);
        Sweeper<T> sweeper(view, iso_values, options);
        tell("cubes", 0.1);
        return sweeper.sweep();
      },
      grid);
}

}  // namespace isoloop
