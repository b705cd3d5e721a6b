#include "core/repair/loop_remover.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "core/grid/level.h"
#include "core/loops/certificate.h"

namespace isoloop {
namespace {

constexpr int value_styles = 3;
constexpr double next_to_iso = 0.01;      // of a distance from iso that is usual, or the voxel's
constexpr std::size_t most_shifted = 24;  // voxels beside a loop
constexpr std::size_t few = 27;         // voxels that each severed part may have more than the cut
constexpr std::size_t patience = 6000;  // voxels of the sets that may fail before the last resort

}  // namespace

LoopSite site_of(const Workings& workings, const Loop& loop) {
  const Surface& surface = workings.analysis.surface;
  const Side side = side_of(loop.kind);
  LoopSite site;
  site.kind = loop.kind;
  site.other = loop.generators;
  site.crossing = workings.on(side).border_classes.coordinates(site.other).value();
  site.length = loop.length;
  for (const std::vector<Vec3>& points : drawn_curves(surface, loop))
    for (std::size_t i = 0; i < points.size(); ++i)
      site.steps += distance(points[i], points[(i + 1) % points.size()]);
  std::map<std::uint32_t, std::vector<Curve>> by_component;
  for (const Curve& curve : loop.curves)
    by_component[surface.component_of_vertex[curve.front()]].push_back(curve);
  std::size_t nontrivial = 0;
  for (const auto& [component, curves] : by_component)
    if (!class_of(surface, workings.classes, curves).empty()) ++nontrivial;
  site.spans_components = nontrivial > 1;
  for (const Curve& curve : loop.curves)
    for (const std::uint32_t vertex : curve)
      if (vertex < surface.grid_edges.size()) site.edges.push_back(surface.grid_edges[vertex]);
  return site;
}

std::uint32_t vertex_of(std::size_t voxel, const Index3& dims, const Lattice& lattice) {
  const auto at = static_cast<std::int64_t>(voxel);
  return *lattice.vertex_at({at % dims[0], at / dims[0] % dims[1], at / dims[0] / dims[1]});
}

bool cross_oddly(const LoopSite& a, const LoopSite& b) {
  GeneratorSet both;
  std::set_intersection(a.crossing.begin(), a.crossing.end(), b.other.begin(), b.other.end(),
                        std::back_inserter(both));
  return both.size() % 2 == 1;
}

LoopRemover::LoopRemover(const Workings& workings, const IsoLevel& level, VoxelValues& values,
                         std::uint64_t max_bytes)
    : workings_(workings),
      level_(level),
      values_(values),
      max_bytes_(max_bytes),
      genus_(workings.analysis.surface.genus()),
      betti_(workings.analysis.betti),
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

std::optional<std::vector<VoxelChange>> LoopRemover::propose(const LoopSite& loop) {
  if (loop.spans_components) return std::nullopt;
  const Side side = side_of(loop.kind);
  const MembraneQuery query{loop.crossing, loop.edges, fixed_, changed_};
  if (auto change = thin_change(side, query, reaches_for(loop.steps))) return change;
  std::vector<std::uint32_t> spanned = finder(side).spanned(query);
  for (int dilations = 0; dilations < 2; ++dilations) {
    if (auto change = passing(side, spanned)) return change;
    spanned = dilated(side, spanned);
  }
  return shift(loop);
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

std::optional<std::vector<VoxelChange>> LoopRemover::thin_change(
    Side side, const MembraneQuery& query, std::vector<std::uint32_t> reaches) {
  std::optional<std::vector<VoxelChange>> change;
  std::set<std::vector<std::uint32_t>> tried;
  std::size_t spent = 0;
  const auto is_done = [&](const std::vector<std::uint32_t>& thin) {
    if (!tried.insert(thin).second) return false;
    spent += thin.size();
    change = passing(side, thin);
    if (!change) {
      const auto more = finder(side).with_severed(query, thin, thin.size() + few);
      if (tried.insert(more).second) change = passing(side, more);
    }
    return change || spent > patience;
  };
  for (const bool clear_islands : {false, true}) {
    std::vector<std::uint32_t> sufficient;
    for (const std::uint32_t reach : reaches) {
      const auto is_found = finder(side).thin(query, {reach, clear_islands}, is_done);
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

std::optional<std::vector<VoxelChange>> LoopRemover::passing(
    Side side, const std::vector<std::uint32_t>& vertices) {
  if (vertices.empty()) return std::nullopt;
  for (int style = 0; style < value_styles; ++style) {
    auto change = values_for(side, vertices, style);
    if (change && removes_one(*change)) return change;
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

/// One voxel beside the loop stays on its side, but next to iso, or as far off as any near by.
/// Where M runs through a cube in several sheets, that decides how they join.
std::optional<std::vector<VoxelChange>> LoopRemover::shift(const LoopSite& loop) {
  const bool values_decide =
      level_.topology == Topology::trilinear || level_.topology == Topology::simple;
  if (!values_decide) return std::nullopt;
  std::vector<std::uint32_t> beside;
  for (const std::uint32_t edge : loop.edges)
    for (const std::uint32_t end : {edge / 3, edge / 3 + workings_.sides->lattice.stride[edge % 3]})
      if (!fixed_[end]) beside.push_back(end);
  std::sort(beside.begin(), beside.end());
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  if (beside.size() > most_shifted) return std::nullopt;
  for (const std::uint32_t vertex : beside) {
    const std::size_t voxel = voxel_of(vertex);
    const double most = greatest_magnitude(voxels_near({&vertex, 1}));
    for (const double magnitude : {next_to_iso * magnitude_of(voxel), most}) {
      const auto after = values_.nearest(magnitude, is_inside(voxel), level_);
      if (!after || *after == values_.at(voxel)) continue;
      std::vector<VoxelChange> change{{voxel, values_.at(voxel), *after}};
      if (removes_one(change)) return change;
    }
  }
  return std::nullopt;
}

bool LoopRemover::removes_one(const std::vector<VoxelChange>& change) {
  for (const VoxelChange& voxel : change) values_.set(voxel.voxel, voxel.after);
  const Analysis counted = count_topology(values_.view(), level_, {.max_bytes = max_bytes_});
  for (const VoxelChange& voxel : change) values_.set(voxel.voxel, voxel.before);
  return counted.surface.genus() == genus_ - 1 && counted.betti.b0 == betti_.b0 &&
         counted.betti.b2 == betti_.b2;
}

void LoopRemover::apply(const std::vector<VoxelChange>& change) {
  for (const VoxelChange& voxel : change) {
    const bool was_inside = is_inside(voxel.voxel);
    values_.set(voxel.voxel, voxel.after);
    if (is_inside(voxel.voxel) != was_inside)
      changed_[vertex_of(voxel.voxel, values_.dims(), workings_.sides->lattice)] = true;
  }
  --genus_;
}

}  // namespace isoloop
