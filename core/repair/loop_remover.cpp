#include "core/repair/loop_remover.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "core/grid/level.h"
#include "core/loops/certificate.h"
#include "core/repair/change_effect.h"
#include "core/repair/local_surface.h"

namespace isoloop {
namespace {

constexpr int value_styles = 3;
constexpr double next_to_iso = 0.01;     // of a distance from iso that is usual, or the voxel's
constexpr std::size_t most_beside = 24;  // voxels beside a loop that are tried one by one
constexpr double tiny = 12.0;            // steps of a loop that is one of thousands
constexpr std::size_t most_near = 16;    // changes that are looked at with one beside them
constexpr std::size_t few = 27;          // voxels that each severed part may have more than the cut
constexpr std::size_t patience = 6000;   // voxels of the sets that may fail before the last resort

/// Whether what bounded within B before does so now: the parts now are shares of those before.
bool refines(const LocalSurface& now, const LocalSurface& before) {
  std::map<std::uint32_t, std::uint32_t> whole;
  for (std::size_t i = 0; i < now.part_of_segment.size(); ++i)
    if (whole.try_emplace(now.part_of_segment[i], before.part_of_segment[i]).first->second !=
        before.part_of_segment[i])
      return false;
  return true;
}

}  // namespace

LoopRemover::LoopRemover(const Workings& workings, const IsoLevel& level, VoxelValues& values)
    : workings_(workings),
      level_(level),
      values_(values),
      volume_(*workings.sides, level, values),
      search_(volume_),
      changed_(workings.sides->lattice.vertex_count()),
      fixed_(workings.sides->lattice.vertex_count()) {
  const Lattice& lattice = workings.sides->lattice;
  for (std::uint32_t v = 0; v < lattice.vertex_count(); ++v) {
    if ((workings.sides->cubes[v] & VoxelSides::on_border) == 0) continue;
    const Index3 voxel = lattice.voxel_at(v);
    for (std::size_t a = 0; a < 3; ++a)
      if (voxel[a] < 0 || voxel[a] >= values.dims()[a]) fixed_[v] = true;
  }
}

MembraneFinder<GridComplex>& LoopRemover::finder(Side side) {
  std::optional<MembraneFinder<GridComplex>>& made = side == Side::inside ? inside_ : outside_;
  if (!made) {
    const WorkedSide& worked = workings_.on(side);
    made.emplace(*workings_.sides, *worked.complex, worked.pass);
  }
  return *made;
}

std::size_t LoopRemover::voxel_of(std::uint32_t vertex) const {
  const Index3 voxel = workings_.sides->lattice.voxel_at(vertex);
  const Index3& dims = values_.dims();
  return static_cast<std::size_t>(voxel[0] + dims[0] * (voxel[1] + dims[1] * voxel[2]));
}

double LoopRemover::magnitude_of(std::size_t voxel) const {
  return std::abs(level_of(values_.at(voxel), level_));
}

bool LoopRemover::is_inside(std::size_t voxel) const {
  return level_of(values_.at(voxel), level_) >= 0.0;
}

std::optional<std::vector<VoxelChange>> LoopRemover::propose(const LoopSite& loop, Effort effort) {
  if (loop.spans_components) return std::nullopt;
  const Side side = side_of(loop.kind);
  const MembraneQuery query{loop.crossing, loop.edges, fixed_, changed_};
  std::vector<std::uint32_t> spanned = finder(side).spanned(query);
  if (effort == Effort::few_voxels) {
    auto change = small_change(loop, spanned);
    return change ? change : shift(loop, true);
  }
  const bool surely = effort == Effort::membranes;
  if (auto change = thin_change(loop, query, surely)) return change;
  for (int dilations = 0; dilations < 2; ++dilations) {
    if (auto change = passing(loop, spanned, surely)) return change;
    spanned = dilated(side, spanned);
  }
  return surely ? std::nullopt : shift(loop, false);
}

/// The changes whose cubes meet those at the vertices, those whose cubes meet these, and so on;
/// nothing where they are many, or some lie on the border of the box.
std::optional<std::vector<std::uint32_t>> LoopRemover::earlier_near(
    const std::vector<std::uint32_t>& vertices) const {
  const Lattice& lattice = workings_.sides->lattice;
  std::vector<std::uint32_t> found;
  std::vector<std::uint32_t> to_see = vertices;
  while (!to_see.empty()) {
    const std::uint32_t vertex = to_see.back();
    to_see.pop_back();
    if ((workings_.sides->cubes[vertex] & VoxelSides::on_border) != 0) return std::nullopt;
    const Index3 voxel = lattice.voxel_at(vertex);
    for (int n = 0; n < 125; ++n) {
      const auto beside = lattice.vertex_at(
          {voxel[0] + n % 5 - 2, voxel[1] + n / 5 % 5 - 2, voxel[2] + n / 25 - 2});
      const auto at = beside ? changer_.find(*beside) : changer_.end();
      if (at == changer_.end() || std::find(found.begin(), found.end(), at->second) != found.end())
        continue;
      found.push_back(at->second);
      if (found.size() > most_near) return std::nullopt;
      const std::vector<std::uint32_t>& others = earlier_[at->second].vertices;
      to_see.insert(to_see.end(), others.begin(), others.end());
    }
  }
  return found;
}

/// Whether the change, at those vertices, removes the loop for sure: HomologyMap will say so.
///
/// With the changes near by it lies within cubes B, where all is removed, and no more: M is spheres
/// less discs there, shares of the parts that it was, whatever crosses B's border bounds now, and
/// its classes are sums of the loops' that were removed. So these are as many as the genus fell by,
/// and half of what B held.
bool LoopRemover::removes_surely(const LoopSite& loop, const std::vector<std::uint32_t>& vertices,
                                 const std::vector<VoxelChange>& change) {
  const auto near = earlier_near(vertices);
  if (!near) return false;
  std::vector<std::uint32_t> all = vertices;
  for (const std::uint32_t n : *near)
    all.insert(all.end(), earlier_[n].vertices.begin(), earlier_[n].vertices.end());
  for (const VoxelChange& voxel : change) volume_.set(voxel.voxel, voxel.after);
  const LocalSurface local = local_surface(workings_, volume_, all);
  for (const VoxelChange& voxel : change) volume_.set(voxel.voxel, voxel.before);
  if (local.has_handle || !refines(local, local_surface(workings_, all))) return false;
  const GeneratorSet own = joint_class(workings_, loop);
  Z2Basis removed;
  removed.add(own);
  for (const std::uint32_t n : *near)
    if (!earlier_[n].is_sure || !removed.add(earlier_[n].removed)) return false;
  Z2Basis bounding;
  for (const GeneratorSet& part : local.parts) bounding.add(part);
  for (const GeneratorSet& curve : local.curves)
    if (!bounding.remainder(curve).empty() || !removed.remainder(curve).empty()) return false;
  return bounding.remainder(own).empty() || lies_within(loop, local.cubes);
}

/// Whether the loop runs through no cube but these, which ascend: all that its vertices lie in are
/// among them.
bool LoopRemover::lies_within(const LoopSite& loop, const std::vector<std::uint32_t>& cubes) const {
  const Lattice& lattice = workings_.sides->lattice;
  const auto is_inner = [&](std::uint32_t edge) {
    const auto [b, c] = cross_axes(static_cast<int>(edge % 3));
    const std::uint32_t along_b = lattice.stride[static_cast<std::size_t>(b)];
    const std::uint32_t along_c = lattice.stride[static_cast<std::size_t>(c)];
    for (const std::uint32_t back : {0U, along_b, along_c, along_b + along_c})
      if (!std::binary_search(cubes.begin(), cubes.end(), edge / 3 - back)) return false;
    return true;
  };
  return std::all_of(loop.edges.begin(), loop.edges.end(), is_inner) &&
         std::all_of(loop.cubes.begin(), loop.cubes.end(), [&](std::uint32_t cube) {
           return std::binary_search(cubes.begin(), cubes.end(), cube);
         });
}

/// One voxel beside the loop, or among the corners of the surface that the labels span, or a step
/// from these; or two in one cube.
std::optional<std::vector<VoxelChange>> LoopRemover::small_change(
    const LoopSite& loop, const std::vector<std::uint32_t>& spanned) {
  const Side side = side_of(loop.kind);
  std::vector<std::uint32_t> beside = vertices_beside(loop, side);
  if (beside.size() > most_beside) return std::nullopt;
  if (spanned.size() <= most_beside) beside.insert(beside.end(), spanned.begin(), spanned.end());
  std::sort(beside.begin(), beside.end());
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  std::erase_if(beside, [&](std::uint32_t vertex) { return changed_[vertex]; });
  for (const std::uint32_t vertex : beside)
    if (auto change = passing(loop, {vertex}, true)) return change;
  for (const std::uint32_t vertex : dilated(side, beside))
    if (auto change = passing(loop, {vertex}, true)) return change;
  const Lattice& lattice = workings_.sides->lattice;
  for (std::size_t i = 0; i < beside.size(); ++i)
    for (std::size_t j = i + 1; j < beside.size(); ++j) {
      const auto p = lattice.position(beside[i]);
      const auto q = lattice.position(beside[j]);
      bool share_cube = true;
      for (std::size_t a = 0; a < 3; ++a)
        share_cube = share_cube && std::max(p[a], q[a]) - std::min(p[a], q[a]) <= 1;
      if (!share_cube) continue;
      if (auto change = passing(loop, {beside[i], beside[j]}, true)) return change;
    }
  return std::nullopt;
}

/// How far to look for membranes from a loop of so many steps, in the order to be tried.
std::vector<std::uint32_t> LoopRemover::reaches_for(double steps) const {
  // No point of a disc that spans a round loop is farther from it than this.
  const double round = steps / (2.0 * std::numbers::pi);
  const auto& dims = workings_.sides->lattice.dims;
  const double farthest = static_cast<double>(dims[0]) + dims[1] + dims[2];
  std::vector<std::uint32_t> distinct;
  for (const double share : {1.0, 1.6, 0.6, 0.3}) {
    const auto reach = static_cast<std::uint32_t>(std::ceil(std::min(share * round, farthest))) + 1;
    if (std::find(distinct.begin(), distinct.end(), reach) == distinct.end())
      distinct.push_back(reach);
  }
  return distinct;
}

std::optional<std::vector<VoxelChange>> LoopRemover::thin_change(const LoopSite& loop,
                                                                 const MembraneQuery& query,
                                                                 bool surely) {
  const Side side = side_of(loop.kind);
  std::vector<std::uint32_t> reaches = reaches_for(loop.steps);
  const bool is_tiny = surely && loop.steps < tiny;
  std::optional<std::vector<VoxelChange>> change;
  std::set<std::vector<std::uint32_t>> tried;
  std::size_t spent = 0;
  const auto is_done = [&](const std::vector<std::uint32_t>& thin) {
    if (!tried.insert(thin).second) return false;
    spent += thin.size();
    change = passing(loop, thin, surely);
    if (!change) {
      const auto more = finder(side).with_severed(query, thin, thin.size() + few);
      if (tried.insert(more).second) change = passing(loop, more, surely);
    }
    return change || spent > patience;
  };
  for (const bool clear_islands : {false, true}) {
    std::vector<std::uint32_t> sufficient;
    for (const std::uint32_t reach : reaches) {
      const auto is_found = finder(side).thin(query, {reach, is_tiny, clear_islands}, is_done);
      if (!is_found) continue;
      if (*is_found) return change;
      sufficient.push_back(reach);
    }
    reaches = std::move(sufficient);
  }
  return std::nullopt;
}

/// The vertices and their neighbours on the side.
std::vector<std::uint32_t> LoopRemover::dilated(Side side,
                                                const std::vector<std::uint32_t>& vertices) const {
  const Lattice& lattice = workings_.sides->lattice;
  std::vector<std::uint32_t> all = vertices;
  for (const std::uint32_t vertex : vertices) {
    const auto p = lattice.position(vertex);
    for (std::size_t a = 0; a < 3; ++a)
      for (const bool forward : {false, true}) {
        if (forward ? p[a] + 1 == lattice.dims[a] : p[a] == 0) continue;
        const std::uint32_t next =
            forward ? vertex + lattice.stride[a] : vertex - lattice.stride[a];
        if (workings_.sides->is_on(side, next) && !changed_[next] && !fixed_[next])
          all.push_back(next);
      }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// The vertices on the other side, if that removes the loop: `surely`, as removes_surely() tells.
std::optional<std::vector<VoxelChange>> LoopRemover::passing(
    const LoopSite& loop, const std::vector<std::uint32_t>& vertices, bool surely) {
  if (vertices.empty()) return std::nullopt;
  for (int style = 0; style < value_styles; ++style) {
    auto change = values_for(side_of(loop.kind), vertices, style);
    if (change && removes_one(*change) && (!surely || removes_surely(loop, vertices, *change)))
      return change;
  }
  return std::nullopt;
}

/// Those within one step of the vertices: of several, once for each.
std::vector<std::size_t> LoopRemover::voxels_near(std::span<const std::uint32_t> vertices) const {
  const Lattice& lattice = workings_.sides->lattice;
  const Index3& dims = values_.dims();
  std::vector<std::size_t> near;
  for (const std::uint32_t vertex : vertices) {
    const auto p = lattice.position(vertex);
    for (int n = 0; n < 27; ++n) {
      const Index3 q{lattice.first[0] + p[0] + n % 3 - 1, lattice.first[1] + p[1] + n / 3 % 3 - 1,
                     lattice.first[2] + p[2] + n / 9 - 1};
      if (q[0] < 0 || q[1] < 0 || q[2] < 0 || q[0] >= dims[0] || q[1] >= dims[1] || q[2] >= dims[2])
        continue;
      near.push_back(static_cast<std::size_t>(q[0] + dims[0] * (q[1] + dims[1] * q[2])));
    }
  }
  return near;
}

double LoopRemover::greatest_magnitude(const std::vector<std::size_t>& voxels) const {
  double greatest = 0.0;
  for (const std::size_t voxel : voxels) greatest = std::max(greatest, magnitude_of(voxel));
  return greatest;
}

/// The median of those on `side`; nothing where none is.
std::optional<double> LoopRemover::usual_magnitude(const std::vector<std::size_t>& voxels,
                                                   Side side) const {
  std::vector<double> magnitudes;
  for (const std::size_t voxel : voxels)
    if (is_inside(voxel) == (side == Side::inside)) magnitudes.push_back(magnitude_of(voxel));
  if (magnitudes.empty()) return std::nullopt;
  const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
  std::nth_element(magnitudes.begin(), middle, magnitudes.end());
  return *middle;
}

/// Values on the other side. Style 0: mirrored about iso, but no farther off than is usual for the
/// other side's voxels near by; 1: as far off as any voxel near by; 2: next to iso.
std::optional<std::vector<VoxelChange>> LoopRemover::values_for(
    Side side, const std::vector<std::uint32_t>& vertices, int style) const {
  const Side other = side == Side::inside ? Side::outside : Side::inside;
  const std::vector<std::size_t> near = voxels_near(vertices);
  const double most = greatest_magnitude(near);
  const double usual = usual_magnitude(near, other).value_or(most);
  std::vector<VoxelChange> change;
  for (const std::uint32_t vertex : vertices) {
    const std::size_t voxel = voxel_of(vertex);
    const double mirrored = std::clamp(magnitude_of(voxel), 0.1 * usual, usual);
    const double magnitude = style == 0 ? mirrored : style == 1 ? most : next_to_iso * usual;
    const auto after = values_.nearest(magnitude, other == Side::inside, level_);
    if (!after) return std::nullopt;
    change.push_back({voxel, values_.at(voxel), *after});
  }
  return change;
}

/// The ends, on that side before all changes, of the grid edges that the loop runs over, and the
/// corners of its cubes. Ascending.
std::vector<std::uint32_t> LoopRemover::vertices_beside(const LoopSite& loop, Side side) const {
  const Lattice& lattice = workings_.sides->lattice;
  std::vector<std::uint32_t> beside;
  for (const std::uint32_t edge : loop.edges)
    beside.insert(beside.end(), {edge / 3, edge / 3 + lattice.stride[edge % 3]});
  for (const std::uint32_t cube : loop.cubes)
    for (unsigned c = 0; c < 8; ++c) beside.push_back(lattice.corner(cube, c));
  std::erase_if(beside, [&](std::uint32_t vertex) {
    return fixed_[vertex] || !workings_.sides->is_on(side, vertex);
  });
  std::sort(beside.begin(), beside.end());
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  return beside;
}

/// One voxel beside the loop stays on its side, but next to iso, or as far off as any near by.
/// Where M runs through a cube in several sheets, that decides how they join. `surely`: as
/// removes_surely() tells.
std::optional<std::vector<VoxelChange>> LoopRemover::shift(const LoopSite& loop, bool surely) {
  const bool values_decide =
      level_.topology == Topology::trilinear || level_.topology == Topology::simple;
  if (!values_decide) return std::nullopt;
  std::vector<std::uint32_t> beside = vertices_beside(loop, Side::inside);
  const std::vector<std::uint32_t> outside = vertices_beside(loop, Side::outside);
  beside.insert(beside.end(), outside.begin(), outside.end());
  std::sort(beside.begin(), beside.end());
  if (beside.size() > most_beside) return std::nullopt;
  for (const std::uint32_t vertex : beside) {
    const std::size_t voxel = voxel_of(vertex);
    const double most = greatest_magnitude(voxels_near({&vertex, 1}));
    for (const double magnitude : {next_to_iso * magnitude_of(voxel), most}) {
      const auto after = values_.nearest(magnitude, is_inside(voxel), level_);
      if (!after || *after == values_.at(voxel)) continue;
      std::vector<VoxelChange> change{{voxel, values_.at(voxel), *after}};
      if (removes_one(change) && (!surely || removes_surely(loop, {vertex}, change))) return change;
    }
  }
  return std::nullopt;
}

bool LoopRemover::removes_one(const std::vector<VoxelChange>& change) {
  if (euler_effect(change, volume_) != 2) return false;
  // M's components, one less than the parts of both sides, stay as many: so the genus falls by one.
  return effect_of(change, volume_, search_) == ChangeEffect{.euler = 2};
}

void LoopRemover::apply(const LoopSite& loop, const std::vector<VoxelChange>& change) {
  Earlier made{{}, joint_class(workings_, loop), false};
  for (const VoxelChange& voxel : change)
    made.vertices.push_back(vertex_of(voxel.voxel, values_.dims(), workings_.sides->lattice));
  made.is_sure = removes_surely(loop, made.vertices, change);
  for (const VoxelChange& voxel : change) {
    const std::uint32_t vertex = vertex_of(voxel.voxel, values_.dims(), workings_.sides->lattice);
    const bool was_inside = volume_.is_inside(vertex);
    volume_.set(voxel.voxel, voxel.after);
    if (volume_.is_inside(vertex) != was_inside) changed_[vertex] = true;
    changer_[vertex] = static_cast<std::uint32_t>(earlier_.size());
  }
  earlier_.push_back(std::move(made));
}

}  // namespace isoloop
