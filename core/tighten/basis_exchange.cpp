#include "core/tighten/basis_exchange.h"

#include <algorithm>
#include <utility>

#include <tbb/parallel_for.h>

namespace isoloop {

BasisExchange::BasisExchange(const Surface& surface, const SurfaceClasses& classes, Side side,
                             std::vector<BasisMember> members)
    : members_(std::move(members)), surface_(surface), classes_(classes), side_(side) {
  keep_shortest();
}

std::vector<SearchCost> BasisExchange::search(std::span<const SearchStart> starts) {
  searches_.for_each([&](LoopSearch& search) { look_for_exchanges(search); });
  std::vector<SearchResult> results(starts.size());
  tbb::parallel_for(std::size_t{0}, starts.size(), [&](std::size_t s) {
    LoopSearch& search = searches_.local([&] { return new_search(); });
    const SearchStart& start = starts[s];
    results[s] = search.shortest_of_each_class(start.vertex, start.limits, start.crossing);
  });
  std::vector<SearchCost> costs;
  const std::size_t rank = members_.size();
  for (SearchResult& result : results) {
    costs.push_back({result.settled, result.shortest_crossing, result.searched});
    for (FoundLoop& loop : result.loops)
      members_.push_back({std::move(loop.curves), loop.length, std::move(loop.other)});
  }
  if (members_.size() > rank) keep_shortest();
  return costs;
}

LoopSearch BasisExchange::new_search() const {
  LoopSearch search(surface_, classes_, side_);
  look_for_exchanges(search);
  return search;
}

/// A loop can take the place of any of the members that sum to its class; of the longest, best.
void BasisExchange::look_for_exchanges(LoopSearch& search) const {
  constexpr double noticeably = 1.0 - 1e-9;  // a mere difference in rounding is no gain
  search.look_for({{}, [this](std::span<const std::uint32_t> other) {
                     const auto sum = basis_.coordinates(other);
                     return members_[sum->back()].length * noticeably;
                   }});
}

/// The shortest first, as long as they are independent.
void BasisExchange::keep_shortest() {
  std::stable_sort(members_.begin(), members_.end(),
                   [](const BasisMember& a, const BasisMember& b) { return a.length < b.length; });
  basis_ = {};
  std::vector<BasisMember> kept;
  for (BasisMember& member : members_)
    if (basis_.add(member.other)) kept.push_back(std::move(member));
  members_ = std::move(kept);
}

}  // namespace isoloop
