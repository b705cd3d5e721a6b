#include "core/z2/z2_basis.h"

#include <algorithm>
#include <utility>

namespace isoloop {

Z2Basis::Row Z2Basis::reduce(std::span<const std::uint32_t> vector) const {
  Row rest{{vector.begin(), vector.end()}, {}};
  for (std::size_t i = rest.vector.size(); i-- > 0;) {
    const auto found = row_of_pivot_.find(rest.vector[i]);
    if (found == row_of_pivot_.end()) continue;
    // The row holds nothing above its pivot: what lies above position i stays as it is.
    const std::uint32_t pivot = rest.vector[i];
    rest.vector = sum_of(rest.vector, rows_[found->second].vector);
    rest.combination = sum_of(rest.combination, rows_[found->second].combination);
    i = static_cast<std::size_t>(std::lower_bound(rest.vector.begin(), rest.vector.end(), pivot) -
                                 rest.vector.begin());
  }
  return rest;
}

std::optional<std::uint32_t> Z2Basis::add(std::span<const std::uint32_t> vector) {
  Row row = reduce(vector);
  if (row.vector.empty()) return std::nullopt;
  const std::uint32_t number = rank();
  row.combination = sum_of(row.combination, {&number, 1});
  const std::uint32_t pivot = row.vector.back();
  row_of_pivot_.emplace(pivot, number);
  rows_.push_back(std::move(row));
  return pivot;
}

std::optional<GeneratorSet> Z2Basis::coordinates(std::span<const std::uint32_t> vector) const {
  Row rest = reduce(vector);
  if (!rest.vector.empty()) return std::nullopt;
  return std::move(rest.combination);
}

}  // namespace isoloop
