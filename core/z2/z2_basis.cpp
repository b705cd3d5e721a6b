#include "core/z2/z2_basis.h"

#include <utility>

namespace isoloop {

Z2Basis::Row Z2Basis::reduce(std::span<const std::uint32_t> vector) const {
  Row rest{Z2Vector(vector), {}};
  for (auto at = rest.vector.greatest(); at; at = rest.vector.greatest_below(*at)) {
    const auto found = row_of_pivot_.find(*at);
    if (found == row_of_pivot_.end()) continue;
    // The row holds nothing above its pivot: what lies above it stays as it is.
    rest.vector.add(rows_[found->second].vector);
    rest.combination.add(rows_[found->second].combination);
  }
  return rest;
}

std::optional<std::uint32_t> Z2Basis::add(std::span<const std::uint32_t> vector) {
  Row row = reduce(vector);
  const auto pivot = row.vector.greatest();
  if (!pivot) return std::nullopt;
  const std::uint32_t number = rank();
  row.combination.add(Z2Vector(std::span(&number, 1)));
  row_of_pivot_.emplace(*pivot, number);
  rows_.push_back(std::move(row));
  return pivot;
}

std::optional<GeneratorSet> Z2Basis::coordinates(std::span<const std::uint32_t> vector) const {
  const Row rest = reduce(vector);
  if (rest.vector.greatest()) return std::nullopt;
  return rest.combination.ones();
}

}  // namespace isoloop
