#include "core/sizes/vertex_pairs.h"

#include <utility>

#include "core/base/errors.h"

namespace isoloop {

std::uint32_t VertexPairs::find(std::uint32_t a, std::uint32_t b) const {
  if (a > b) std::swap(a, b);
  const auto begin = partner.begin() + first[a];
  const auto end = partner.begin() + first[a + 1];
  const auto at = std::lower_bound(begin, end, b);
  if (at == end || *at != b)
    throw SelfCheckFailed("the distance of two vertices is asked for that was not looked for");
  return static_cast<std::uint32_t>(at - partner.begin());
}

VertexPairs PairCollector::take() {
  CompressedRows rows = rows_.take();
  return {std::move(rows.first), std::move(rows.values)};
}

}  // namespace isoloop
