#include "core/loops.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "core/errors.h"
#include "core/killing_border.h"
#include "core/loop_search.h"
#include "core/z2_basis.h"

namespace isoloop {
namespace {

constexpr std::size_t starts_per_curve = 8;  // searches that try to shorten a curve

/// Splits a class into its part on the loops' own side, which must vanish, and on the other side.
struct SplitClass {
  GeneratorSet own;
  GeneratorSet other;
};

SplitClass split(const SurfaceClasses& classes, LoopKind kind, std::span<const std::uint32_t> set) {
  SplitClass parts{inside_part(classes, set), outside_part(classes, set)};
  if (kind == LoopKind::tunnel) std::swap(parts.own, parts.other);
  return parts;
}

std::string name_of(LoopKind kind) { return kind == LoopKind::handle ? "handle" : "tunnel"; }

Vec3 center_of(const Surface& surface, std::span<const Curve> curves) {
  Vec3 sum{};
  double weight = 0.0;
  for (const Curve& curve : curves)
    for (std::size_t k = 0; k < curve.size(); ++k) {
      const std::uint32_t u = curve[k];
      const std::uint32_t v = curve[(k + 1) % curve.size()];
      const double length = distance(scaled_point(surface, u), scaled_point(surface, v));
      weight += length;
      for (int a = 0; a < 3; ++a)
        sum[a] += length * (surface.points[u][a] + surface.points[v][a]) / 2;
    }
  for (double& x : sum) x /= weight;
  return sum;
}

class LoopFinder {
 public:
  LoopFinder(const Surface& surface, const SurfaceClasses& classes, const SolvedSide& side,
             const std::vector<std::uint32_t>& closest)
      : surface_(surface),
        classes_(classes),
        side_(side),
        closest_(closest),
        kind_(side.complex.side() == Side::inside ? LoopKind::handle : LoopKind::tunnel),
        borders_(killing_borders(side.complex, side.pass)) {
    for (std::uint32_t i = 0; i < side.pass.killing.size(); ++i) add_border_class(i);
  }

  Loop find(std::uint32_t i, LoopSearch& search) const {
    std::vector<Curve> curves = single_curve(i, search);
    if (curves.empty()) curves = tightened_border(i, search);
    return measured_loop(surface_, kind_, static_cast<int>(i) + 1, side_.pass.killing[i].size,
                         std::move(curves));
  }

 private:
  void add_border_class(std::uint32_t i) {
    const std::vector<Curve> curves = closed_curves(borders_.of(i));
    const SplitClass border = split(classes_, kind_, class_of(surface_, classes_, curves));
    if (!border.own.empty() || !border_classes_.add(border.other))
      throw SelfCheckFailed("the border of the surface across " + name_of(kind_) + " " +
                            std::to_string(i + 1) + " is not a cycle of its kind");
  }

  /// Whether killing piece i is what makes the class trivial: of the handles (or tunnels) that it
  /// closes, i dies last.
  bool dies_at(std::uint32_t i, std::span<const std::uint32_t> set) const {
    const SplitClass parts = split(classes_, kind_, set);
    if (!parts.own.empty()) return false;
    const auto closes = border_classes_.coordinates(parts.other);
    return closes && !closes->empty() && closes->back() == i;
  }

  /// The surface vertices closest to the killing piece's corners, and those on its border.
  std::vector<std::uint32_t> bases(std::uint32_t i) const {
    const std::uint32_t piece = side_.pass.killing[i].piece;
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t corner : side_.complex.corners(piece))
      vertices.push_back(closest_[corner]);
    for (const auto& segment : side_.complex.segments(piece))
      vertices.insert(vertices.end(), segment.begin(), segment.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  /// The shortest curve found near killing piece i; empty where there is none that is shorter than
  /// what the border of its surface comes to at the most.
  std::vector<Curve> single_curve(std::uint32_t i, LoopSearch& search) const {
    const WantedClass wanted = [&](std::span<const std::uint32_t> set) { return dies_at(i, set); };
    double longest = length_of(surface_, closed_curves(borders_.of(i)));
    std::optional<FoundLoop> best;
    for (const std::uint32_t base : bases(i)) {
      std::optional<FoundLoop> found = search.run(base, longest, wanted);
      if (!found || (best && found->length >= best->length)) continue;
      best = std::move(found);
      longest = best->length;
    }
    if (!best) return {};
    shorten(*best, search, wanted);
    return {best->curve};
  }

  /// Searches again from vertices of the loop itself.
  static void shorten(FoundLoop& loop, LoopSearch& search, const WantedClass& wanted) {
    const Curve starts = loop.curve;
    const std::size_t count = std::min(starts.size(), starts_per_curve);
    for (std::size_t k = 0; k < count; ++k) {
      std::optional<FoundLoop> found =
          search.run(starts[k * starts.size() / count], loop.length, wanted);
      if (found && found->length < loop.length) loop = std::move(*found);
    }
  }

  std::vector<Curve> tightened_border(std::uint32_t i, LoopSearch& search) const {
    std::vector<Curve> tight;
    for (const Curve& curve : closed_curves(borders_.of(i))) {
      const GeneratorSet own_class = class_of(surface_, classes_, {&curve, 1});
      if (own_class.empty()) continue;
      FoundLoop loop{curve, length_of(surface_, {&curve, 1})};
      shorten(loop, search, [&](std::span<const std::uint32_t> set) {
        return std::equal(set.begin(), set.end(), own_class.begin(), own_class.end());
      });
      tight.push_back(std::move(loop.curve));
    }
    return tight;
  }

  const Surface& surface_;
  const SurfaceClasses& classes_;
  SolvedSide side_;
  const std::vector<std::uint32_t>& closest_;
  LoopKind kind_;
  KillingBorders borders_;
  Z2Basis border_classes_;  // in the other side's homology; vector i is the border of surface i
};

}  // namespace

Loop measured_loop(const Surface& surface, LoopKind kind, int id, double size,
                   std::vector<Curve> curves) {
  Loop loop;
  loop.kind = kind;
  loop.id = id;
  loop.size = size;
  loop.curves = std::move(curves);
  loop.length = length_of(surface, loop.curves);
  loop.component = surface.component_of_vertex[loop.curves.front().front()];
  loop.center_index = center_of(surface, loop.curves);
  return loop;
}

std::vector<Loop> loops_of_side(const Surface& surface, const SurfaceClasses& classes,
                                const SolvedSide& side, const std::vector<std::uint32_t>& closest) {
  const LoopFinder finder(surface, classes, side, closest);
  std::vector<Loop> loops(side.pass.killing.size());
  tbb::enumerable_thread_specific<LoopSearch> searches(
      [&] { return LoopSearch(surface, classes); });
  // Large sizes search far: taken first and one by one, they do not wait at the end.
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, loops.size(), 1), [&](const auto& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k) {
      const std::size_t i = loops.size() - 1 - k;
      loops[i] = finder.find(static_cast<std::uint32_t>(i), searches.local());
    }
  });
  return loops;
}

void certify(const Surface& surface, const SurfaceClasses& classes, std::vector<Loop>& loops) {
  Z2Basis handles;
  Z2Basis tunnels;
  for (Loop& loop : loops) {
    const SplitClass parts = split(classes, loop.kind, class_of(surface, classes, loop.curves));
    Z2Basis& basis = loop.kind == LoopKind::handle ? handles : tunnels;
    const std::string name = name_of(loop.kind) + " loop " + std::to_string(loop.id);
    if (loop.curves.empty() || !parts.own.empty() || parts.other.empty())
      throw SelfCheckFailed(name + " does not bound on its own side alone");
    if (!basis.add(parts.other)) throw SelfCheckFailed(name + " depends on the loops before it");
    loop.certificate.trivial_inside = loop.kind == LoopKind::handle;
    loop.certificate.trivial_outside = loop.kind == LoopKind::tunnel;
  }
  const std::int64_t genus = surface.genus();
  if (handles.rank() != genus || tunnels.rank() != genus)
    throw SelfCheckFailed("the surface has genus " + std::to_string(genus) + ", but " +
                          std::to_string(handles.rank()) + " handle loops and " +
                          std::to_string(tunnels.rank()) + " tunnel loops were proved");
}

}  // namespace isoloop
