#include "core/loops/loop_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <unordered_map>

#include "core/base/errors.h"

namespace isoloop {
namespace {

constexpr auto none = static_cast<std::uint32_t>(-1);

bool visits_twice(Curve curve) {
  std::sort(curve.begin(), curve.end());
  return std::adjacent_find(curve.begin(), curve.end()) != curve.end();
}

/// What is left of a closed walk over Z2, where an edge taken twice is not taken at all.
std::vector<Curve> without_repeated_edges(const Curve& walk) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for_each_edge(walk, [&](std::uint32_t u, std::uint32_t v) {
    edges.push_back({std::min(u, v), std::max(u, v)});
  });
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<std::uint32_t, 2>> odd;
  for (const auto& edge : edges) {
    if (!odd.empty() && odd.back() == edge)
      odd.pop_back();
    else
      odd.push_back(edge);
  }
  return closed_curves(odd);
}

/// Apart from the print of the same set as the other part of a class.
constexpr ClassPrint rotated(ClassPrint print) { return std::rotl(print, 32); }

/// No edge of M leaves its cube.
double longest_edge(const Surface& surface) {
  constexpr double rounding = 1e-3;
  return (1.0 + rounding) * distance({0.0, 0.0, 0.0}, surface.spacing);
}

}  // namespace

LoopSearch::LoopSearch(const Surface& surface, const SurfaceClasses& classes, Side side)
    : surface_(surface),
      classes_(classes),
      side_(side),
      edge_classes_(classes.pool.count()),
      reached_(surface.points.size()),
      queue_(longest_edge(surface)) {}

void LoopSearch::look_for(WantedLoops wanted) {
  wanted_ = std::move(wanted);
  wanted_own_ = print_of(wanted_.own);
  ++asked_;
}

void LoopSearch::stay_near(const Curve& curve, std::size_t edges) {
  is_bounded_ = !curve.empty();
  near_.resize(reached_.size());
  ++stays_;
  Curve inner = curve;
  for (const std::uint32_t vertex : inner) near_[vertex] = stays_;
  for (std::size_t i = 0; i < edges; ++i) {
    Curve outer;
    for (const std::uint32_t vertex : inner)
      surface_.graph.for_each_out_edge(vertex, [&](std::uint32_t next, std::uint32_t) {
        if (near_[next] == stays_) return;
        near_[next] = stays_;
        outer.push_back(next);
      });
    inner = std::move(outer);
  }
}

void LoopSearch::begin(std::uint32_t base) {
  if (++current_ == 0) {  // after 2^32 searches: no stale entry may look current
    for (Reached& vertex : reached_) vertex.search = 0;
    for (EdgeClass& along : edge_classes_) along.odd_for = 0;
    current_ = 1;
  }
  settled_ = 0;
  gave_up_ = false;
  queue_.clear();
  paths_.assign(1, {0.0F, base, {}, none, none, false, false});
  reached_[base] = {current_, 0};
  queue_.push(0.0F, 0);
}

std::uint32_t LoopSearch::first_path(std::uint32_t vertex) const {
  return reached_[vertex].search == current_ ? reached_[vertex].first : none;
}

double LoopSearch::distance_to(std::uint32_t vertex) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t p = first_path(vertex); p != none; p = paths_[p].next)
    least = std::min(least, double{paths_[p].distance});
  return least;
}

/// Not if it is settled already, or as many others to its vertex are as there may be.
bool LoopSearch::may_settle(const Path& path, std::uint32_t sheets) const {
  if (path.is_settled) return false;
  std::uint32_t others = 0;
  for (std::uint32_t p = first_path(path.vertex); p != none; p = paths_[p].next)
    if (paths_[p].is_settled && ++others == sheets) return false;
  return true;
}

const LoopSearch::EdgeClass& LoopSearch::class_of_edge(std::uint32_t label) {
  EdgeClass& along = edge_classes_[label];
  if (along.odd_for == current_) return along;
  if (along.odd_for == 0) {  // a label that is met for the first time
    const SplitClass parts = split_class(classes_, side_, classes_.pool.generators(label));
    along.label = {print_of(parts.own), print_of(parts.other)};
  }
  along.odd_for = current_;
  along.is_odd = false;
  if (crossing_.empty()) return along;
  const SplitClass parts = split_class(classes_, side_, classes_.pool.generators(label));
  for (const std::uint32_t generator : parts.other)
    if (std::binary_search(crossing_.begin(), crossing_.end(), generator))
      along.is_odd = !along.is_odd;
  return along;
}

double LoopSearch::useful_length(const Closing& closing) {
  const auto [at, is_new] = met_.try_emplace(closing.other ^ rotated(wanted_own_));
  Met& met = at->second;
  if (is_new) {
    const Curve walk = walk_of(closing);
    SplitClass parts = split_class(classes_, side_, class_of(surface_, classes_, {&walk, 1}));
    met = {std::move(parts.own), std::move(parts.other), 0.0, 0};
  }
  if (met.asked != asked_) {
    met.useful_length = met.own == wanted_.own ? wanted_.useful_length(met.other) : 0.0;
    met.asked = asked_;
  }
  return met.useful_length;
}

/// Settles paths up to half of `bound` and calls close(closing) for every way to close a loop of
/// the wanted own class, but not of class 0, no longer than `bound` at that time; `close` may lower
/// it. The middle of a shortest walk lies on an edge whose ends are both settled by then.
template <class Close>
void LoopSearch::explore(std::uint32_t base, double& bound, const SearchLimits& limits,
                         const Close& close) {
  begin(base);
  const std::uint32_t sheets = limits.sheets;
  searched_ = limits.longest;
  while (!queue_.empty()) {
    const BucketQueue::Item nearest = queue_.take();
    if (2.0 * nearest.key > bound) break;
    if (settled_ >= limits.most_settled) {
      gave_up_ = true;
      searched_ = 2.0 * nearest.key;
      break;
    }
    const std::uint32_t number = nearest.value;
    if (!may_settle(paths_[number], sheets)) continue;
    paths_[number].is_settled = true;
    ++settled_;
    const Path here = paths_[number];
    surface_.graph.for_each_out_edge(here.vertex, [&](std::uint32_t next, std::uint32_t edge) {
      if (is_bounded_ && near_[next] != stays_) return;
      Path path{here.distance + surface_.graph.lengths[edge],
                next,
                here.label,
                number,
                none,
                here.is_odd,
                false};
      if (const std::uint32_t label = classes_.of_edge[edge]; label != 0) {
        const EdgeClass& along = class_of_edge(label);
        path.label.own ^= along.label.own;
        path.label.other ^= along.label.other;
        path.is_odd = path.is_odd != along.is_odd;
      }
      extend(path, bound, sheets, close);
    });
  }
}

/// Closes loops with the settled paths to the same vertex. Keeps the path unless a shorter one of
/// its class is known, or `sheets` shorter ones of others.
template <class Close>
void LoopSearch::extend(const Path& path, const double& bound, std::uint32_t sheets,
                        const Close& close) {
  const ClassPrint own_back = path.label.own ^ wanted_own_;
  std::uint32_t same = none;
  std::uint32_t shorter = 0;
  const std::uint32_t first = first_path(path.vertex);
  for (std::uint32_t p = first; p != none; p = paths_[p].next) {
    const Path& known = paths_[p];
    if (known.distance <= path.distance) ++shorter;
    if (known.label == path.label) {
      if (known.distance <= path.distance) shorter = sheets;
      same = p;
    } else if (known.is_settled) {
      const double length = double{path.distance} + known.distance;
      if (known.is_odd != path.is_odd) shortest_crossing_ = std::min(shortest_crossing_, length);
      if (known.label.own == own_back && length <= bound)
        close(Closing{path.parent, p, path.label.other ^ known.label.other, length});
    }
  }
  if (shorter >= sheets || 2.0 * path.distance > bound) return;
  if (same == none) {
    // Of each sheet every edge is walked once: more cannot be where lengths are numbers.
    if (paths_.size() > sheets * surface_.graph.lengths.size() + 1)
      throw SelfCheckFailed("a search for loops takes more paths than the surface has edges");
    same = static_cast<std::uint32_t>(paths_.size());
    paths_.push_back(path);
    paths_.back().next = first;
    reached_[path.vertex] = {current_, same};
  } else {
    paths_[same].distance = path.distance;
    paths_[same].parent = path.parent;
  }
  queue_.push(path.distance, same);
}

std::optional<FoundLoop> LoopSearch::shortest(std::uint32_t base, const SearchLimits& limits) {
  std::optional<FoundLoop> best;
  double bound = limits.longest;
  crossing_ = {};
  explore(base, bound, limits, [&](const Closing& closing) {
    if (closing.length >= useful_length(closing)) return;
    bound = std::min(bound, closing.length);
    FoundLoop found = loop_of(closing);
    if (!best || found.length < best->length) best = std::move(found);
  });
  return best;
}

SearchResult LoopSearch::shortest_of_each_class(std::uint32_t base, const SearchLimits& limits,
                                                std::span<const std::uint32_t> crossing) {
  crossing_ = crossing;
  shortest_crossing_ = limits.longest;
  std::vector<Closing> closings;
  std::unordered_map<ClassPrint, std::size_t> number;  // of each label's closing
  double bound = limits.longest;
  explore(base, bound, limits, [&](const Closing& closing) {
    if (useful_length(closing) == 0.0) return;
    const auto [at, is_new] = number.try_emplace(closing.other, closings.size());
    if (is_new)
      closings.push_back(closing);
    else if (closing.length < closings[at->second].length)
      closings[at->second] = closing;
  });
  SearchResult result{{}, std::min(shortest_crossing_, searched_), settled_, searched_};
  for (const Closing& closing : closings) {
    FoundLoop loop = loop_of(closing);
    if (loop.length < useful_length(closing)) result.loops.push_back(std::move(loop));
  }
  return result;
}

Curve LoopSearch::walk_of(const Closing& closing) const {
  // Walk both ends up to where their paths meet; the farther end first.
  std::uint32_t from = closing.from;
  std::uint32_t to = closing.to;
  Curve there{paths_[from].vertex};
  Curve back{paths_[to].vertex};
  while (from != to) {
    const bool first = paths_[from].distance >= paths_[to].distance;
    std::uint32_t& farther = first ? from : to;
    farther = paths_[farther].parent;
    (first ? there : back).push_back(paths_[farther].vertex);
  }
  back.pop_back();
  there.insert(there.end(), back.rbegin(), back.rend());
  return there;
}

FoundLoop LoopSearch::loop_of(const Closing& closing) const {
  Curve walk = walk_of(closing);
  FoundLoop found;
  found.other = met_.at(closing.other ^ rotated(wanted_own_)).other;
  if (visits_twice(walk))
    found.curves = without_repeated_edges(walk);
  else
    found.curves.push_back(std::move(walk));
  found.length = length_of(surface_, found.curves);
  return found;
}

}  // namespace isoloop
