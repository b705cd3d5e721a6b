#include "core/repair/homology_map.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/base/potentials.h"

namespace isoloop {
namespace {

/// Finds, for vertices of one surface, those of another one that lie at the same places.
class SameVertices {
 public:
  SameVertices(const Workings& from, const Workings& to) : from_(from), to_(to) {}

  /// For a vertex of a cube without a changed corner.
  std::uint32_t of(std::uint32_t vertex) const {
    const std::uint32_t on_edges = from_.edges->count();
    if (vertex < on_edges) return *on_same_edge(vertex);
    const std::uint32_t ring = vertex - on_edges;
    const std::uint32_t cube = from_.sides->tunnels[ring / ring_size].cube;
    return ring_vertex(*to_.edges, tunnel_in(*to_.sides, moved(cube)),
                       static_cast<int>(ring % ring_size));
  }

  /// The edge of the other surface between the same places, beside changed voxels.
  std::uint32_t edge_at(std::uint32_t a, std::uint32_t b) const {
    if (std::max(a, b) >= from_.edges->count()) return no_edge;
    const auto from = on_same_edge(a);
    const auto to = on_same_edge(b);
    return from && to ? edge_between(to_.analysis.surface.graph, *from, *to) : no_edge;
  }

 private:
  std::optional<std::uint32_t> on_same_edge(std::uint32_t vertex) const {
    const std::uint32_t edge = from_.analysis.surface.grid_edges[vertex];
    const auto end = to_.sides->lattice.vertex_at(from_.sides->lattice.voxel_at(edge / 3));
    if (!end || !to_.edges->is_cut(3 * *end + edge % 3)) return std::nullopt;
    return to_.edges->vertex_on(3 * *end + edge % 3);
  }

  std::uint32_t moved(std::uint32_t lattice_vertex) const {
    return *to_.sides->lattice.vertex_at(from_.sides->lattice.voxel_at(lattice_vertex));
  }

  const Workings& from_;
  const Workings& to_;
};

/// The classes of a walk before and after, as numbers in the pools of a SumOfClasses.
struct WalkClasses {
  std::uint32_t before = 0;
  std::uint32_t after = 0;
  auto operator<=>(const WalkClasses&) const = default;
};

struct SumOfClasses {
  LabelPool before;
  LabelPool after;

  WalkClasses operator()(const WalkClasses& a, const WalkClasses& b) {
    return {before.sum(a.before, b.before), after.sum(a.after, b.after)};
  }
};

using WalkForest = Potentials<WalkClasses, SumOfClasses>;  // over the vertices before

/// The classes before and after of closed walks that generate all common ones.
std::set<WalkClasses> common_walks(WalkForest& forest, const Workings& before,
                                   const Workings& after, const std::vector<bool>& changed,
                                   CommonWalks common) {
  std::set<WalkClasses> found;
  const Surface& surface = before.analysis.surface;
  const Lattice& lattice = before.sides->lattice;
  const SameVertices same(before, after);
  const auto is_common = [&](std::uint32_t cube) {
    for (unsigned c = 0; c < 8; ++c)
      if (changed[lattice.corner(cube, c)]) return false;
    return true;
  };
  const auto class_after = [&](std::uint32_t edge) {
    return after.classes.of_edge.empty() ? 0U : after.classes.of_edge[edge];
  };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const bool is_whole = is_common(surface.triangle_cubes[t]);
    if (!is_whole && common == CommonWalks::in_cubes) continue;
    const auto& corners = surface.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = corners[i];
      const std::uint32_t b = corners[(i + 1) % 3];
      const std::uint32_t there =
          is_whole ? edge_between(after.analysis.surface.graph, same.of(a), same.of(b))
                   : same.edge_at(a, b);
      if (there == no_edge) continue;
      const std::uint32_t step = before.classes.of_edge[edge_between(surface.graph, a, b)];
      const WalkClasses closed = forest.join(a, b, {step, class_after(there)});
      if (closed != WalkClasses{}) found.insert(closed);
    }
  }
  return found;
}

GeneratorSet set_of(const LabelPool& pool, std::uint32_t label) {
  const auto generators = pool.generators(label);
  return {generators.begin(), generators.end()};
}

}  // namespace

HomologyMap::HomologyMap(const Workings& before, const Workings& after,
                         const std::vector<bool>& changed, std::span<const GeneratorSet> removed,
                         CommonWalks common)
    : before_inside_(before.classes.inside_rank),
      before_rank_(before.classes.inside_rank + before.classes.outside_rank),
      after_inside_(after.classes.inside_rank),
      after_rank_(after.classes.inside_rank + after.classes.outside_rank),
      removed_(removed.size()) {
  WalkForest forest(SumOfClasses{before.classes.pool, after.classes.pool});
  for (std::size_t v = 0; v < before.analysis.surface.points.size(); ++v) forest.add();
  const auto walks = common_walks(forest, before, after, changed, common);
  for (const GeneratorSet& cycle : removed) add({cycle, {}});
  for (const WalkClasses& walk : walks)
    add({set_of(forest.sum.before, walk.before), set_of(forest.sum.after, walk.after)});
}

void HomologyMap::add(ClassPair pair) {
  if (basis_.add(pair.before)) {
    pairs_.push_back(std::move(pair));
  } else if (image(pair.before) != pair.after) {
    is_map_ = false;
  }
}

bool HomologyMap::keeps_kind(Side bounding) const {
  // Of each pair, what tells it from a class that bounds on that side: after the change at its own
  // number, before it at higher ones. A row of the basis with nothing of the higher ones is the
  // pair of a class that bounded there.
  const auto tells = [&](std::uint32_t generator, std::uint32_t inside_rank) {
    return (generator < inside_rank) == (bounding == Side::inside);
  };
  Z2Basis basis;
  for (const ClassPair& pair : pairs_) {
    GeneratorSet telling;
    for (const std::uint32_t generator : pair.after)
      if (tells(generator, after_inside_)) telling.push_back(generator);
    for (const std::uint32_t generator : pair.before)
      if (tells(generator, before_inside_)) telling.push_back(after_rank_ + generator);
    const auto pivot = basis.add(telling);
    if (pivot && *pivot < after_rank_) return false;
  }
  return true;
}

std::optional<std::string> HomologyMap::check() const {
  if (!is_map_) return "a loop that bounded before no longer does";
  if (after_rank_ + 2 * removed_ != before_rank_)
    return "the genus dropped by " + std::to_string((before_rank_ - after_rank_) / 2) + ", not " +
           std::to_string(removed_);
  if (pairs_.size() + removed_ != before_rank_)
    return "walks apart from what changed reach " + std::to_string(pairs_.size()) +
           " independent classes, not " + std::to_string(before_rank_ - removed_);
  Z2Basis reached;
  for (const ClassPair& pair : pairs_) reached.add(pair.after);
  if (reached.rank() != after_rank_)
    return "of " + std::to_string(after_rank_) + " independent loops only " +
           std::to_string(reached.rank()) + " were there before";
  if (!keeps_kind(Side::inside)) return "a handle loop no longer is one";
  if (!keeps_kind(Side::outside)) return "a tunnel loop no longer is one";
  return std::nullopt;
}

std::optional<GeneratorSet> HomologyMap::image(const GeneratorSet& before) const {
  const auto pairs = basis_.coordinates(before);
  if (!pairs) return std::nullopt;
  GeneratorSet after;
  for (const std::uint32_t k : *pairs) after = sum_of(after, pairs_[k].after);
  return after;
}

}  // namespace isoloop
