#include "core/scan/scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include "core/base/errors.h"
#include "core/base/memory_budget.h"
#include "core/base/run_both.h"
#include "core/grid/lattice.h"
#include "core/grid/level.h"
#include "core/scan/cube_sweep.h"
#include "core/scan/sized_sets.h"

namespace isoloop {
namespace {

/// The grid with one outside layer round it, and at which steps each vertex is inside.
struct RankedGrid {
  Lattice lattice;
  std::vector<Step> rank;    // inside at the steps before; 0 in the outside layer
  std::vector<double> isos;  // by step
};

/// Two vertices that are joined at all steps on one side of `step`.
struct Join {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  Step step = 0;
};

/// Joins other than those along grid edges: of the inside at the steps up to `step`, of the outside
/// from `step` on.
struct Joins {
  std::vector<Join> inside;
  std::vector<Join> outside;
};

/// Sums over cubes, as differences from one step to the next.
struct StepSums {
  std::vector<std::int64_t> discs;
  std::vector<std::int64_t> cut_edges;

  explicit StepSums(std::size_t steps) : discs(steps + 1), cut_edges(steps + 1) {}

  void add(const StepSums& other) {
    for (std::size_t i = 0; i < discs.size(); ++i) {
      discs[i] += other.discs[i];
      cut_edges[i] += other.cut_edges[i];
    }
  }
};

struct Sweep {
  StepSums sums;
  Joins joins;
};

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

void check_iso_values(std::span<const double> values) {
  if (values.empty() || values.size() > max_scan_values)
    throw InvalidArgument({.text = "a scan takes 1 to " + std::to_string(max_scan_values) +
                                   " iso values, not " + std::to_string(values.size())},
                          Option::iso);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]) || (i > 0 && values[i] <= values[i - 1]))
      throw InvalidArgument({.text = "the iso values of a scan must be finite and ascend"},
                            Option::iso);
}

/// Number of the first steps at which the value is inside. `isos` by step.
Step rank_of(double value, const std::vector<double>& isos, InsideRule rule) {
  const auto at = rule == InsideRule::above
                      ? std::upper_bound(isos.begin(), isos.end(), value)
                      : std::upper_bound(isos.begin(), isos.end(), value, std::greater<>());
  return static_cast<Step>(at - isos.begin());
}

template <class T>
class Scanner {
 public:
  Scanner(const GridView<T>& grid, std::span<const double> iso_values, const ScanOptions& options)
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

  const RankedGrid& ranked() const { return ranked_; }

  /// The sums over all cubes, and the joins that edges do not make.
  Sweep sweep() const {
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
    return {sums, std::move(all)};
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
    const auto [x, y, z] = ranked_.lattice.position(vertex);
    return grid_.values[x - 1 + grid_.dims[0] * (y - 1 + grid_.dims[1] * (z - std::int64_t{1}))];
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
      ranks.corner[c] = ranked_.rank[corner_of(v, static_cast<int>(c))];
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

  std::uint32_t corner_of(std::uint32_t v, int corner) const {
    const auto& stride = ranked_.lattice.stride;
    return v + (corner & 1) * stride[0] + (corner >> 1 & 1) * stride[1] +
           (corner >> 2 & 1) * stride[2];
  }

  void sweep_cut(std::uint32_t v, const CubeRanks& ranks, StepSums& sums, Joins& joins) const {
    // Asked only where the cube lies within the grid: elsewhere there is no room for a tunnel.
    const auto levels_at = [&](Step step) {
      const auto [x, y, z] = ranked_.lattice.position(v);
      return corner_levels(grid_, level_at(step),
                           {std::int64_t{x} - 1, std::int64_t{y} - 1, std::int64_t{z} - 1});
    };
    sweep_cube(
        ranks, options_.topology == Topology::simple ? nullptr : &levels_at,
        [&](Steps steps, int discs) { add_to(sums.discs, steps, discs); },
        [&](Step step, const TunnelEnds& ends) {
          auto& list = ends.side == Side::inside ? joins.inside : joins.outside;
          list.push_back({corner_of(v, ends.hub), corner_of(v, ends.partner), step});
        });
  }

  const GridView<T>& grid_;
  const ScanOptions& options_;
  RankedGrid ranked_;
};

/// Items by step: list[first[s]] ... list[first[s + 1] - 1].
struct ByStep {
  std::vector<std::uint32_t> list;
  std::vector<std::size_t> first;
};

template <class StepOf>
ByStep sorted_by_step(std::size_t count, std::size_t steps, const StepOf& step_of) {
  ByStep sorted{std::vector<std::uint32_t>(count), std::vector<std::size_t>(steps + 1)};
  for (std::size_t i = 0; i < count; ++i) ++sorted.first[step_of(i)];
  std::partial_sum(sorted.first.begin(), sorted.first.end(), sorted.first.begin());
  for (std::size_t i = count; i-- > 0;)
    sorted.list[--sorted.first[step_of(i)]] = static_cast<std::uint32_t>(i);
  return sorted;
}

/// Components of one side, by step.
struct SideCounts {
  std::vector<std::int64_t> all;
  std::vector<std::vector<std::int64_t>> large;  // by size, then by step
  std::vector<std::int64_t> largest;             // voxels
};

/// Vertices come in as the side grows: the inside from the last step to the first, the outside the
/// other way. What lies round the grid counts as large.
SideCounts component_counts(const RankedGrid& grid, const ByStep& vertices,
                            const std::vector<Join>& joins, Side side,
                            std::span<const std::int64_t> sizes) {
  const std::size_t steps = grid.isos.size();
  const auto& stride = grid.lattice.stride;
  const ByStep extra =
      sorted_by_step(joins.size(), steps, [&](std::size_t i) { return joins[i].step; });
  SizedSets sets(grid.lattice.vertex_count(), sizes);
  SideCounts counts{std::vector<std::int64_t>(steps),
                    std::vector(sizes.size(), std::vector<std::int64_t>(steps)),
                    std::vector<std::int64_t>(steps)};
  const bool inside = side == Side::inside;
  const auto enter = [&](std::uint32_t v) {
    constexpr std::uint32_t round_the_grid = 1U << 31U;  // more than the vertices of any lattice
    const Step rank = grid.rank[v];
    const auto p = grid.lattice.position(v);
    sets.enter(v, v == 0 ? round_the_grid : 1);
    for (int a = 0; a < 3; ++a) {
      if (p[a] > 0) {
        const Step other = grid.rank[v - stride[a]];
        if (inside ? other >= rank : other <= rank) sets.unite(v, v - stride[a]);
      }
      if (p[a] + 1 < grid.lattice.dims[a]) {
        const Step other = grid.rank[v + stride[a]];
        if (inside ? other > rank : other < rank) sets.unite(v, v + stride[a]);
      }
    }
  };
  for (std::size_t i = 0; i < steps; ++i) {
    const std::size_t s = inside ? steps - 1 - i : i;
    const std::size_t rank = inside ? s + 1 : s;
    for (std::size_t k = vertices.first[rank];
         k < (rank == steps ? vertices.list.size() : vertices.first[rank + 1]); ++k)
      enter(vertices.list[k]);
    for (std::size_t k = extra.first[s]; k < extra.first[s + 1]; ++k)
      sets.unite(joins[extra.list[k]].a, joins[extra.list[k]].b);
    counts.all[s] = sets.all();
    counts.largest[s] = sets.largest();
    for (std::size_t size = 0; size < sizes.size(); ++size)
      counts.large[size][s] = sets.of_size()[size];
  }
  return counts;
}

template <class T>
SizedScan scan_grid(const GridView<T>& grid, std::span<const double> iso_values,
                    std::span<const std::int64_t> sizes, const ScanOptions& options) {
  check_iso_values(iso_values);
  const auto tell = [&](const char* stage, double share) {
    if (options.progress) options.progress(stage, share);
  };
  tell("values", 0.0);
  const Scanner<T> scanner(grid, iso_values, options);
  const RankedGrid& ranked = scanner.ranked();
  const std::size_t steps = iso_values.size();
  tell("cubes", 0.1);
  const Sweep sweep = scanner.sweep();
  tell("components", 0.5);
  const ByStep vertices =
      sorted_by_step(ranked.rank.size(), steps, [&](std::size_t v) { return ranked.rank[v]; });
  SideCounts inside;
  SideCounts outside;
  run_both(
      [&] { inside = component_counts(ranked, vertices, sweep.joins.inside, Side::inside, sizes); },
      [&] {
        outside = component_counts(ranked, vertices, sweep.joins.outside, Side::outside, sizes);
      });
  SizedScan found{std::vector<ScanRow>(steps), std::vector(sizes.size(), std::vector<Betti>(steps)),
                  std::vector<std::int64_t>(steps)};
  std::int64_t discs = 0;
  std::int64_t cut_edges = 0;
  for (std::size_t s = 0; s < steps; ++s) {
    discs += sweep.sums.discs[s];
    cut_edges += sweep.sums.cut_edges[s];
    const std::size_t r = options.inside == InsideRule::above ? s : steps - 1 - s;
    ScanRow& row = found.rows[r];
    row.iso = ranked.isos[s];
    row.euler = discs - cut_edges;
    row.betti = {inside.all[s], 0, outside.all[s] - 1};
    row.betti.b1 = row.betti.b0 + row.betti.b2 - row.euler / 2;
    row.genus = row.betti.b1;
    row.inside_voxels = static_cast<std::int64_t>(ranked.rank.size() - vertices.first[s + 1]);
    found.largest[r] = inside.largest[s];
    for (std::size_t i = 0; i < sizes.size(); ++i)
      found.large[i][r] = {inside.large[i][s], 0, outside.large[i][s] - 1};
    if (row.euler % 2 != 0 || row.betti.b1 < 0)
      throw SelfCheckFailed("the components and the Euler characteristic contradict each other");
  }
  return found;
}

}  // namespace

SizedScan scan_sizes(const AnyGridView& grid, std::span<const double> iso_values,
                     std::span<const std::int64_t> sizes, const ScanOptions& options) {
  return std::visit([&](const auto& view) { return scan_grid(view, iso_values, sizes, options); },
                    grid);
}

std::vector<ScanRow> scan_topology(const AnyGridView& grid, std::span<const double> iso_values,
                                   const ScanOptions& options) {
  return scan_sizes(grid, iso_values, {}, options).rows;
}

}  // namespace isoloop
