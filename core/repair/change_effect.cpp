#include "core/repair/change_effect.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/base/disjoint_sets.h"

namespace isoloop {
namespace {

/// Where a change is: the cubes at its voxels, by their lowest corners, and their vertices.
struct Place {
  std::vector<Index3> voxels;
  std::vector<Index3> cubes;
  VertexGroup around;  // ascending; beyond_box at the end if there

  std::uint32_t number_of(std::uint32_t vertex) const {
    return static_cast<std::uint32_t>(std::lower_bound(around.begin(), around.end(), vertex) -
                                      around.begin());
  }
};

template <class Item>
void sort_unique(std::vector<Item>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

Index3 corner_voxel(const Index3& lowest, unsigned corner) {
  return {lowest[0] + (corner & 1U), lowest[1] + (corner >> 1 & 1U),
          lowest[2] + (corner >> 2 & 1U)};
}

Place place_of(const std::vector<VoxelChange>& change, const CurrentVolume& volume) {
  Place place;
  for (const VoxelChange& voxel : change) {
    const Index3 at = voxel_index(voxel.voxel, volume.values().dims());
    place.voxels.push_back(at);
    for (unsigned c = 0; c < 8; ++c)
      place.cubes.push_back(corner_voxel({at[0] - 1, at[1] - 1, at[2] - 1}, c));
  }
  sort_unique(place.cubes);
  for (const Index3& cube : place.cubes)
    for (unsigned c = 0; c < 8; ++c)
      place.around.push_back(volume.vertex_at(corner_voxel(cube, c)));
  sort_unique(place.around);
  return place;
}

/// How a place is cut at one time.
struct Look {
  std::int64_t euler = 0;    // the share of M's that may change
  std::vector<bool> inside;  // by number
  DisjointSets joined;       // numbers, by the cubes of the place
};

std::int64_t cut_edges_at(const Place& place, const CurrentVolume& volume) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> cut;
  for (const Index3& voxel : place.voxels) {
    const std::uint32_t vertex = volume.vertex_at(voxel);
    for (std::size_t a = 0; a < 3; ++a)
      for (const int step : {-1, 1}) {
        Index3 neighbour = voxel;
        neighbour[a] += step;
        const std::uint32_t end = volume.vertex_at(neighbour);
        if (volume.is_inside(vertex) == volume.is_inside(end)) continue;
        // An edge that leaves the box has one end in it and goes by that one's way out.
        const std::uint32_t other =
            end == beyond_box ? beyond_box - static_cast<std::uint32_t>(2 * a + (step + 1) / 2)
                              : end;
        cut.insert(std::minmax(vertex, other));
      }
  }
  return static_cast<std::int64_t>(cut.size());
}

Look look_at(const Place& place, const CurrentVolume& volume) {
  Look look{-cut_edges_at(place, volume),
            {},
            DisjointSets(static_cast<std::uint32_t>(place.around.size()))};
  for (const std::uint32_t vertex : place.around) look.inside.push_back(volume.is_inside(vertex));
  for (const Index3& cube : place.cubes) {
    const CubeCut& cut = *volume.cube_at(cube).cut;
    look.euler += cut.disc_count;
    std::array<std::uint32_t, 8> corners{};
    for (unsigned c = 0; c < 8; ++c)
      corners[c] = place.number_of(volume.vertex_at(corner_voxel(cube, c)));
    for (unsigned a = 0; a < 8; ++a)
      for (unsigned b = 0; b < a; ++b)
        if (look.inside[corners[a]] == look.inside[corners[b]] &&
            cut.cell_of_corner[a] == cut.cell_of_corner[b])
          look.joined.unite(corners[a], corners[b]);
  }
  return look;
}

/// The parts of one side that a place joins at one of two times alone.
struct Parts {
  std::vector<VertexGroup> before;
  std::vector<VertexGroup> after;
  std::int64_t vanished = 0;  // parts of changed vertices alone
  std::int64_t appeared = 0;
};

/// Parts of `look` on a side, by their roots, as the vertices that stay on it. Those without any
/// are counted.
std::map<std::uint32_t, VertexGroup> parts_on(bool inside, const Place& place, Look& look,
                                              const std::vector<bool>& stays, std::int64_t& alone) {
  std::map<std::uint32_t, VertexGroup> parts;
  for (std::uint32_t n = 0; n < place.around.size(); ++n) {
    if (look.inside[n] != inside) continue;
    VertexGroup& part = parts[look.joined.find(n)];
    if (stays[n]) part.push_back(place.around[n]);
  }
  alone = std::erase_if(parts, [](const auto& part) { return part.second.empty(); });
  return parts;
}

Parts parts_that_differ(bool inside, const Place& place, Look& before, Look& after) {
  const auto count = static_cast<std::uint32_t>(place.around.size());
  std::vector<bool> stays(count);
  DisjointSets either(count);
  for (std::uint32_t n = 0; n < count; ++n) stays[n] = before.inside[n] == after.inside[n];
  Parts parts;
  auto parts_before = parts_on(inside, place, before, stays, parts.vanished);
  auto parts_after = parts_on(inside, place, after, stays, parts.appeared);
  std::map<std::uint32_t, std::size_t> of_either_before;
  std::map<std::uint32_t, std::size_t> of_either_after;
  for (const auto* list : {&parts_before, &parts_after})
    for (const auto& [root, part] : *list)
      for (const std::uint32_t vertex : part)
        either.unite(place.number_of(part.front()), place.number_of(vertex));
  const auto root_of = [&](const VertexGroup& part) {
    return either.find(place.number_of(part.front()));
  };
  for (const auto& [root, part] : parts_before) ++of_either_before[root_of(part)];
  for (const auto& [root, part] : parts_after) ++of_either_after[root_of(part)];
  const auto differs = [&](const VertexGroup& part) {
    const std::uint32_t root = root_of(part);
    return of_either_before[root] != 1 || of_either_after[root] != 1;
  };
  for (auto& [root, part] : parts_before)
    if (differs(part)) parts.before.push_back(std::move(part));
  for (auto& [root, part] : parts_after)
    if (differs(part)) parts.after.push_back(std::move(part));
  return parts;
}

}  // namespace

std::int64_t euler_effect(const std::vector<VoxelChange>& change, CurrentVolume& volume) {
  const Place place = place_of(change, volume);
  const std::int64_t before = look_at(place, volume).euler;
  for (const VoxelChange& voxel : change) volume.set(voxel.voxel, voxel.after);
  const std::int64_t after = look_at(place, volume).euler;
  for (const VoxelChange& voxel : change) volume.set(voxel.voxel, voxel.before);
  return after - before;
}

ChangeEffect effect_of(const std::vector<VoxelChange>& change, CurrentVolume& volume,
                       PartSearch& search) {
  const Place place = place_of(change, volume);
  Look before = look_at(place, volume);
  for (const VoxelChange& voxel : change) volume.set(voxel.voxel, voxel.after);
  Look after = look_at(place, volume);
  const Parts inside = parts_that_differ(true, place, before, after);
  const Parts outside = parts_that_differ(false, place, before, after);
  ChangeEffect effect{after.euler - before.euler, inside.appeared - inside.vanished,
                      outside.appeared - outside.vanished};
  effect.inside_parts += search.parts_among(inside.after);
  effect.outside_parts += search.parts_among(outside.after);
  for (const VoxelChange& voxel : change) volume.set(voxel.voxel, voxel.before);
  effect.inside_parts -= search.parts_among(inside.before);
  effect.outside_parts -= search.parts_among(outside.before);
  return effect;
}

}  // namespace isoloop
