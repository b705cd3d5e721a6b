#include "core/z2/bit_column.h"

namespace isoloop {

BitColumn::BitColumn(std::uint32_t bound) {
  std::size_t words = bound;
  do {
    words = words / 64 + 1;
    levels_.emplace_back(words);
  } while (words > 1);
}

void BitColumn::drain(std::vector<std::uint32_t>& rows) {
  while (!empty()) {
    rows.push_back(youngest());
    flip(rows.back());
  }
}

}  // namespace isoloop
