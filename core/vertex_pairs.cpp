#include "core/vertex_pairs.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include <tbb/parallel_for.h>

namespace isoloop {

std::uint32_t VertexPairs::find(std::uint32_t a, std::uint32_t b) const {
  if (a > b) std::swap(a, b);
  const auto begin = partner.begin() + first[a];
  const auto end = partner.begin() + first[a + 1];
  return static_cast<std::uint32_t>(std::lower_bound(begin, end, b) - partner.begin());
}

PairCollector::PairCollector(std::uint32_t vertices) : first_(std::size_t{vertices} + 1) {}

void PairCollector::count(std::uint32_t a, std::uint32_t b) {
  std::atomic_ref(first_[std::min(a, b) + 1]).fetch_add(1, std::memory_order_relaxed);
}

void PairCollector::end_of_counting() {
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  cursor_.assign(first_.begin(), first_.end() - 1);
  partner_.resize(first_.back());
}

void PairCollector::add(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t at =
      std::atomic_ref(cursor_[std::min(a, b)]).fetch_add(1, std::memory_order_relaxed);
  partner_[at] = std::max(a, b);
}

VertexPairs PairCollector::take() {
  const auto sources = static_cast<std::uint32_t>(cursor_.size());
  tbb::parallel_for(std::uint32_t{0}, sources, [&](std::uint32_t a) {
    const auto begin = partner_.begin() + first_[a];
    std::sort(begin, partner_.begin() + first_[a + 1]);
    cursor_[a] =
        static_cast<std::uint32_t>(std::unique(begin, partner_.begin() + first_[a + 1]) - begin);
  });
  VertexPairs pairs;
  pairs.first.resize(std::size_t{sources} + 1);
  std::partial_sum(cursor_.begin(), cursor_.end(), pairs.first.begin() + 1);
  pairs.partner.resize(pairs.first.back());
  for (std::uint32_t a = 0; a < sources; ++a)
    std::copy_n(partner_.begin() + first_[a], cursor_[a], pairs.partner.begin() + pairs.first[a]);
  return pairs;
}

}  // namespace isoloop
