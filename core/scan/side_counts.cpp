#include "core/scan/side_counts.h"

#include <numeric>

#include "core/scan/sized_sets.h"

namespace isoloop {
namespace {

template <class StepOf>
ByStep sorted_by_step(std::size_t count, std::size_t steps, const StepOf& step_of) {
  ByStep sorted{std::vector<std::uint32_t>(count), std::vector<std::size_t>(steps + 1)};
  for (std::size_t i = 0; i < count; ++i) ++sorted.first[step_of(i)];
  std::partial_sum(sorted.first.begin(), sorted.first.end(), sorted.first.begin());
  for (std::size_t i = count; i-- > 0;)
    sorted.list[--sorted.first[step_of(i)]] = static_cast<std::uint32_t>(i);
  return sorted;
}

}  // namespace

ByStep vertices_by_step(const RankedGrid& grid) {
  return sorted_by_step(grid.rank.size(), grid.isos.size(),
                        [&](std::size_t v) { return grid.rank[v]; });
}

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

}  // namespace isoloop
