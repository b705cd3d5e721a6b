#include "core/loops/loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/base/errors.h"
#include "core/base/per_thread.h"
#include "core/loops/killing_border.h"
#include "core/loops/loop_search.h"
#include "core/z2/z2_basis.h"

namespace isoloop {
namespace {

constexpr double any_length = std::numeric_limits<double>::infinity();
constexpr double noticeable = 0.95;             // gains of less are left to shortening
constexpr double pays = 0.99;                   // what is left by a band that is worth a wider one
constexpr std::size_t starts_per_curve = 8;     // searches that try to shorten a curve
constexpr std::size_t edges_per_band = 16;      // of a curve, to one edge of the band's half width
constexpr std::size_t least_band = 2;           // edges, likewise
constexpr std::uint64_t settled_nearby = 3000;  // paths, by a search near a killing piece
constexpr std::uint64_t settled_per_edge_squared = 2;  // paths, by one that goes farther

/// CPU time of the calling thread so far; a look at it takes less than a microsecond.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Vec3 center_of(const Surface& surface, const Loop& loop) {
  Vec3 sum{};
  double weight = 0.0;
  for (const std::vector<Vec3>& points : drawn_curves(surface, loop))
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Vec3& p = points[k];
      const Vec3& q = points[(k + 1) % points.size()];
      const double length = scaled_distance(surface, p, q);
      weight += length;
      for (std::size_t a = 0; a < 3; ++a) sum[a] += length * (p[a] + q[a]) / 2;
    }
  for (double& x : sum) x /= weight;
  return sum;
}

class LoopFinder {
 public:
  LoopFinder(const Surface& surface, const SurfaceClasses& classes, const KilledOnSide& killed)
      : surface_(surface),
        classes_(classes),
        side_(killed),
        kind_(kind_on(surface.boundary, killed.side)) {}

  Loop find(std::uint32_t i, LoopSearch& search) const {
    return measured_loop(surface_, kind_, static_cast<int>(i) + 1, side_.killing[i].size,
                         curves_of(i, search));
  }

 private:
  /// Whether killing piece i is what makes the class trivial: of the handles (or tunnels) that it
  /// closes, i dies last.
  bool dies_at(std::uint32_t i, std::span<const std::uint32_t> other) const {
    const auto closes = side_.border_classes.coordinates(other);
    return closes && !closes->empty() && closes->back() == i;
  }

  /// Near the killing piece first. What is not found there may be long, or of several curves: the
  /// border of the labels' surface, shortened, then says how far a search has to go.
  std::vector<Curve> curves_of(std::uint32_t i, LoopSearch& search) const {
    const double longest = length_of(surface_, closed_curves(side_.borders.of(i)));
    look_for_loops_of(i, search);
    Attempt near = single_curve(i, {longest, 1, settled_nearby}, search);
    if (!near.gave_up && near.curve) return {shortened(*near.curve, search)};
    std::vector<Curve> border = tightened_border(i, search);
    if (!near.gave_up) return border;
    look_for_loops_of(i, search);
    const double bound = std::min(noticeable * length_of(surface_, border), side_.shorten_below);
    const Attempt far = single_curve(i, {bound, 1, most_settled(border)}, search);
    if (far.curve) return {shortened(*far.curve, search)};
    return border;
  }

  void look_for_loops_of(std::uint32_t i, LoopSearch& search) const {
    search.look_for({{}, [this, i](std::span<const std::uint32_t> other) {
                       return dies_at(i, other) ? any_length : 0.0;
                     }});
  }

  /// For a search that is to find a shorter loop than these curves. A disc as wide as they are long
  /// has about so many vertices on a plane, and more where M is rough.
  static std::uint64_t most_settled(std::span<const Curve> curves) {
    std::uint64_t edges = 0;
    for (const Curve& curve : curves) edges += curve.size();
    return std::max(settled_nearby, settled_per_edge_squared * edges * edges);
  }

  struct Attempt {
    std::optional<Curve> curve;
    bool gave_up = false;  // one of the searches
  };

  /// The shortest curve found near killing piece i within the limits of each search.
  Attempt single_curve(std::uint32_t i, SearchLimits limits, LoopSearch& search) const {
    Attempt attempt;
    const std::vector<std::uint32_t>& starts = side_.starts[i];
    std::vector<double> least(starts.size());  // length of a loop through each
    for (std::size_t s = 0; s < starts.size(); ++s) {
      if (least[s] >= noticeable * limits.longest) continue;
      std::optional<FoundLoop> found = search.shortest(starts[s], limits);
      if (search.gave_up()) {
        attempt.gave_up = true;
        break;
      }
      const double through = found ? found->length : limits.longest;
      for (std::size_t t = s + 1; t < starts.size(); ++t)
        least[t] = std::max(least[t], through - 2.0 * search.distance_to(starts[t]));
      if (!found || (attempt.curve && found->length >= limits.longest)) continue;
      limits.longest = found->length;
      attempt.curve = std::move(found->curves.front());
    }
    return attempt;
  }

  /// Searches again from vertices of the curve itself, in a band about it that grows while it pays.
  Curve shortened(const Curve& curve, LoopSearch& search) const {
    FoundLoop best{{curve}, length_of(surface_, {&curve, 1}), {}};
    for (std::size_t band = least_band;; band *= 2) {
      const double before = best.length;
      search.stay_near(best.curves.front(), band);
      for (std::size_t k = 0; k < starts_per_curve; ++k) {
        const Curve& now = best.curves.front();
        if (k >= now.size()) break;
        std::optional<FoundLoop> found = search.shortest(
            now[k * now.size() / std::min(starts_per_curve, now.size())], {best.length});
        if (!found || found->length >= best.length) continue;
        best = std::move(*found);
        search.stay_near(best.curves.front(), band);
      }
      if (best.length > pays * before || band * edges_per_band > best.curves.front().size()) break;
    }
    search.stay_near({}, 0);
    return best.curves.front();
  }

  std::vector<Curve> tightened_border(std::uint32_t i, LoopSearch& search) const {
    std::vector<Curve> tight;
    for (const Curve& curve : closed_curves(side_.borders.of(i))) {
      const SplitClass wanted =
          split_class(classes_, side_of(kind_), class_of(surface_, classes_, {&curve, 1}));
      if (wanted.own.empty() && wanted.other.empty()) continue;
      search.look_for({wanted.own, [&](std::span<const std::uint32_t> other) {
                         return std::equal(other.begin(), other.end(), wanted.other.begin(),
                                           wanted.other.end())
                                    ? any_length
                                    : 0.0;
                       }});
      tight.push_back(shortened(curve, search));
    }
    return tight;
  }

  const Surface& surface_;
  const SurfaceClasses& classes_;
  KilledOnSide side_;
  LoopKind kind_;
};

}  // namespace

std::string name_of(LoopKind kind) {
  switch (kind) {
    case LoopKind::handle:
      return "handle loop";
    case LoopKind::tunnel:
      return "tunnel loop";
    case LoopKind::loop:
      return "loop";
  }
  return "loop";
}

Loop measured_loop(const Surface& surface, LoopKind kind, int id, double size,
                   std::vector<Curve> curves) {
  Loop loop;
  loop.kind = kind;
  loop.id = id;
  loop.size = size;
  loop.curves = std::move(curves);
  loop.length = length_of(surface, loop.curves);
  loop.found_length = loop.length;
  loop.component = surface.component_of_vertex[loop.curves.front().front()];
  loop.center_index = center_of(surface, loop);
  return loop;
}

void set_geodesics(const Surface& surface, Loop& loop, std::vector<Geodesic> geodesics) {
  loop.geodesics = std::move(geodesics);
  loop.length = 0.0;
  for (const Geodesic& geodesic : loop.geodesics) loop.length += length_of(surface, geodesic);
  loop.center_index = center_of(surface, loop);
}

std::vector<std::vector<Vec3>> drawn_curves(const SurfaceMesh& surface, const Loop& loop) {
  std::vector<std::vector<Vec3>> drawn;
  for (const Geodesic& geodesic : loop.geodesics) {
    drawn.emplace_back();
    for (const SurfacePoint& point : geodesic) drawn.back().push_back(index_point(surface, point));
  }
  if (!drawn.empty()) return drawn;
  for (const Curve& curve : loop.curves) {
    drawn.emplace_back();
    for (const std::uint32_t vertex : curve) {
      const auto& point = surface.points[vertex];
      drawn.back().push_back({point[0], point[1], point[2]});
    }
  }
  return drawn;
}

SearchedLoops loops_of_side(const Surface& surface, const SurfaceClasses& classes,
                            const KilledOnSide& killed) {
  const LoopFinder finder(surface, classes, killed);
  const std::size_t count = killed.killing.size();
  SearchedLoops found{std::vector<Loop>(count), std::vector<double>(count)};
  const Side seen_from = side_of(kind_on(surface.boundary, killed.side));
  PerThread<LoopSearch> searches;
  // Large sizes search far: taken first and one by one, they do not wait at the end.
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), [&](const auto& range) {
    LoopSearch& search = searches.local([&] { return LoopSearch(surface, classes, seen_from); });
    for (std::size_t k = range.begin(); k < range.end(); ++k) {
      const std::size_t i = count - 1 - k;
      const double start = thread_seconds();
      found.loops[i] = finder.find(static_cast<std::uint32_t>(i), search);
      found.seconds[i] = thread_seconds() - start;
    }
  });
  return found;
}

double slowest_hundredth(std::vector<double> seconds) {
  const std::size_t count = (seconds.size() + 99) / 100;
  const auto end = seconds.begin() + static_cast<std::ptrdiff_t>(count);
  std::partial_sort(seconds.begin(), end, seconds.end(), std::greater<>());
  return std::accumulate(seconds.begin(), end, 0.0);
}

std::vector<Loop> merged_by_size(std::vector<Loop> inside, std::vector<Loop> outside) {
  std::vector<Loop> loops = std::move(inside);
  std::move(outside.begin(), outside.end(), std::back_inserter(loops));
  std::stable_sort(loops.begin(), loops.end(),
                   [](const Loop& a, const Loop& b) { return a.size < b.size; });
  for (std::size_t i = 0; i < loops.size(); ++i) loops[i].id = static_cast<int>(i) + 1;
  return loops;
}

std::span<const Loop> loops_of_kind(std::span<const Loop> loops, LoopKind kind) {
  const auto begin_of = [&](auto is_before) {
    return std::partition_point(loops.begin(), loops.end(), is_before);
  };
  return {begin_of([&](const Loop& loop) { return loop.kind < kind; }),
          begin_of([&](const Loop& loop) { return loop.kind <= kind; })};
}

void check_measures(std::span<const Loop> loops) {
  const auto is_length = [](double length) { return length > 0.0 && std::isfinite(length); };
  for (const Loop& loop : loops) {
    const bool placed = std::all_of(loop.center_index.begin(), loop.center_index.end(),
                                    [](double x) { return std::isfinite(x); });
    if (is_length(loop.length) && is_length(loop.found_length) && loop.size >= 0.0 && placed)
      continue;
    throw SelfCheckFailed("the measures of " + name_of(loop.kind) + " " + std::to_string(loop.id) +
                          " are no numbers: length " + std::to_string(loop.length) + ", size " +
                          std::to_string(loop.size));
  }
}

std::vector<Loop> certified(const Surface& surface, const SurfaceClasses& classes,
                            std::vector<Loop> loops) {
  std::array<Z2Basis, 3> bases;  // by kind
  for (Loop& loop : loops) {
    SplitClass parts =
        split_class(classes, side_of(loop.kind), class_of(surface, classes, loop.curves));
    const std::string name = name_of(loop.kind) + " " + std::to_string(loop.id);
    if (loop.curves.empty() || !parts.own.empty() || parts.other.empty())
      throw SelfCheckFailed(name + (loop.kind == LoopKind::loop
                                        ? " bounds on the surface"
                                        : " does not bound on its own side alone"));
    if (!bases[static_cast<std::size_t>(loop.kind)].add(parts.other))
      throw SelfCheckFailed(name + " depends on the loops before it");
    loop.certificate.nontrivial_on_surface = true;
    loop.certificate.trivial_inside = loop.kind == LoopKind::handle;
    loop.certificate.trivial_outside = loop.kind == LoopKind::tunnel;
    loop.generators = std::move(parts.other);
  }
  const bool open = surface.boundary == Boundary::open;
  const std::int64_t each = open ? 0 : surface.genus();
  const std::array<std::int64_t, 3> wanted{each, each, open ? surface.betti1() : 0};
  for (const LoopKind kind : {LoopKind::handle, LoopKind::tunnel, LoopKind::loop}) {
    const auto k = static_cast<std::size_t>(kind);
    if (bases[k].rank() != wanted[k])
      throw SelfCheckFailed("the surface asks for " + std::to_string(wanted[k]) + " " +
                            name_of(kind) + "s, but " + std::to_string(bases[k].rank()) +
                            " were proved");
  }
  return loops;
}

}  // namespace isoloop
