#include "core/loop_search.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace isoloop {

LoopSearch::LoopSearch(const Surface& surface, const SurfaceClasses& classes)
    : surface_(surface), classes_(classes) {
  const std::size_t count = surface.points.size();
  round_.resize(count, 0);
  settled_.resize(count);
  distance_.resize(count);
  parent_.resize(count);
  label_.resize(count);
}

void LoopSearch::begin() {
  if (++current_ == 0) {  // after 2^32 searches: no stale entry may look current
    std::fill(round_.begin(), round_.end(), 0U);
    current_ = 1;
  }
  queue_.clear();
  verdict_.clear();
}

void LoopSearch::reach(std::uint32_t vertex, float distance, std::uint32_t parent,
                       std::uint32_t label) {
  round_[vertex] = current_;
  settled_[vertex] = 0;
  distance_[vertex] = distance;
  parent_[vertex] = parent;
  label_[vertex] = label;
  queue_.emplace_back(distance, vertex);
  std::push_heap(queue_.begin(), queue_.end(), std::greater<>{});
}

std::uint32_t LoopSearch::local(std::uint32_t label) {
  if (label == 0) return 0;
  const auto [at, is_new] = local_.try_emplace(label, 0);
  if (is_new) at->second = pool_.intern(classes_.pool.generators(label));
  return at->second;
}

bool LoopSearch::is_wanted(std::uint32_t label, const WantedClass& wanted) {
  if (label == 0) return false;
  const auto [at, is_new] = verdict_.try_emplace(label, false);
  if (is_new) at->second = wanted(pool_.generators(label));
  return at->second;
}

std::optional<FoundLoop> LoopSearch::run(std::uint32_t base, double longest,
                                         const WantedClass& wanted) {
  begin();
  reach(base, 0.0F, base, 0);
  double bound = longest;
  std::optional<FoundLoop> best;
  const auto try_closing = [&](const Closing& closing, std::uint32_t edge_label) {
    const double with_stem =
        double{distance_[closing.from]} + closing.length + distance_[closing.to];
    if (with_stem > longest) return;
    if (edge_label == 0 && label_[closing.from] == label_[closing.to]) return;
    const std::uint32_t label =
        pool_.sum(pool_.sum(label_[closing.from], label_[closing.to]), local(edge_label));
    if (!is_wanted(label, wanted)) return;
    bound = std::min(bound, with_stem);
    FoundLoop found = loop_through(closing);
    if (!best || found.length < best->length) best = std::move(found);
  };
  while (!queue_.empty() && 2.0 * queue_.front().first <= bound) {
    const auto vertex = queue_.front().second;
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>{});
    queue_.pop_back();
    if (settled_[vertex] != 0) continue;
    settled_[vertex] = 1;
    surface_.graph.for_each_out_edge(vertex, [&](std::uint32_t next, std::uint32_t edge) {
      const float length = surface_.graph.lengths[edge];
      const std::uint32_t edge_label = classes_.of_edge[edge];
      if (is_reached(next) && settled_[next] != 0) {
        try_closing({vertex, next, length}, edge_label);
        return;
      }
      const float through = distance_[vertex] + length;
      if (is_reached(next) && through >= distance_[next]) return;
      reach(next, through, vertex, pool_.sum(label_[vertex], local(edge_label)));
    });
  }
  return best;
}

FoundLoop LoopSearch::loop_through(const Closing& closing) const {
  // Walk both ends up to where their tree paths meet; the farther end first.
  Curve there{closing.from};
  Curve back{closing.to};
  while (there.back() != back.back()) {
    Curve& farther = distance_[there.back()] >= distance_[back.back()] ? there : back;
    farther.push_back(parent_[farther.back()]);
  }
  const double stem = distance_[there.back()];
  FoundLoop found;
  found.length =
      double{distance_[closing.from]} + closing.length + distance_[closing.to] - 2 * stem;
  back.pop_back();
  found.curve = std::move(there);
  found.curve.insert(found.curve.end(), back.rbegin(), back.rend());
  return found;
}

}  // namespace isoloop
