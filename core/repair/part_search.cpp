#include "core/repair/part_search.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "core/base/disjoint_sets.h"

namespace isoloop {

std::int64_t PartSearch::parts_among(std::span<const VertexGroup> groups) {
  const auto count = static_cast<std::uint32_t>(groups.size());
  if (count < 2) return count;
  if (first_ > std::numeric_limits<std::uint32_t>::max() - count) {
    std::fill(met_by_.begin(), met_by_.end(), 0U);
    first_ = 1;
  }
  const std::uint32_t beyond = count;  // the number of the group that beyond_box is
  DisjointSets met(count + 1);
  std::int64_t parts = count;
  std::vector<VertexGroup> waiting(count);
  std::vector<std::size_t> next(count);
  bool has_met_beyond = false;
  bool may_be_done = true;  // a part has come to an end, or met another
  const auto meet = [&](std::uint32_t vertex, std::uint32_t group) {
    std::uint32_t other = beyond;
    if (vertex != beyond_box) {
      if (met_by_[vertex] < first_) {
        met_by_[vertex] = first_ + group;
        waiting[group].push_back(vertex);
        return;
      }
      other = met_by_[vertex] - first_;
    }
    if (!met.unite(group, other)) return;
    may_be_done = true;
    if (other == beyond && !has_met_beyond)
      has_met_beyond = true;
    else
      --parts;
  };
  for (std::uint32_t g = 0; g < count; ++g)
    for (const std::uint32_t vertex : groups[g]) meet(vertex, g);
  // A part is at its end when none of its groups waits, unless it goes on beyond the box.
  const auto open_parts = [&] {
    may_be_done = false;
    std::vector<bool> is_open(count + 1);
    for (std::uint32_t g = 0; g < count; ++g)
      if (next[g] < waiting[g].size()) is_open[met.find(g)] = true;
    if (has_met_beyond) is_open[met.find(beyond)] = true;
    return std::count(is_open.begin(), is_open.end(), true);
  };
  while (parts > 1 && (!may_be_done || open_parts() > 1))
    for (std::uint32_t g = 0; g < count; ++g)
      if (next[g] < waiting[g].size()) {
        const std::uint32_t vertex = waiting[g][next[g]++];
        volume_.for_each_joined(vertex, [&](std::uint32_t other) { meet(other, g); });
        may_be_done = may_be_done || next[g] == waiting[g].size();
      }
  first_ += count;
  return parts;
}

}  // namespace isoloop
