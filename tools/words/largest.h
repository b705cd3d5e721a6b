// The largest items of a list, for tables and pages that have no room for all.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace isoloop {

/// The places of the items, the largest by `key` first; of equal ones the first.
template <class Item, class Key>
std::vector<std::size_t> largest_first(const std::vector<Item>& items, const Key& key) {
  std::vector<std::size_t> places(items.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::stable_sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) {
    return std::invoke(key, items[a]) > std::invoke(key, items[b]);
  });
  return places;
}

/// The items of a table's rows: all in their order or, with `most_rows` above 0, so many of the
/// largest, these first.
template <class Item, class Key>
std::vector<const Item*> items_in_rows(const std::vector<Item>& items, std::size_t most_rows,
                                       const Key& key) {
  std::vector<const Item*> chosen;
  chosen.reserve(items.size());
  if (most_rows == 0) {
    for (const Item& item : items) chosen.push_back(&item);
    return chosen;
  }
  for (const std::size_t place : largest_first(items, key)) {
    if (chosen.size() == most_rows) break;
    chosen.push_back(&items[place]);
  }
  return chosen;
}

}  // namespace isoloop
