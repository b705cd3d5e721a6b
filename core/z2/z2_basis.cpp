#include "core/z2/z2_basis.h"

#include <utility>

namespace isoloop {

Z2Basis::Row Z2Basis::reduce(std::span<const std::uint32_t> vector) const {
  Row rest{{vector.begin(), vector.end()}, {}};
  while (!rest.vector.empty()) {
    const auto found = row_of_pivot_.find(rest.vector.back());
    if (found == row_of_pivot_.end()) break;
    rest.vector = sum_of(rest.vector, rows_[found->second].vector);
    rest.combination = sum_of(rest.combination, rows_[found->second].combination);
  }
  return rest;
}

bool Z2Basis::add(std::span<const std::uint32_t> vector) {
  Row row = reduce(vector);
  if (row.vector.empty()) return false;
  const std::uint32_t number = rank();
  row.combination = sum_of(row.combination, {&number, 1});
  row_of_pivot_.emplace(row.vector.back(), number);
  rows_.push_back(std::move(row));
  return true;
}

std::optional<GeneratorSet> Z2Basis::coordinates(std::span<const std::uint32_t> vector) const {
  Row rest = reduce(vector);
  if (!rest.vector.empty()) return std::nullopt;
  return std::move(rest.combination);
}

}  // namespace isoloop
