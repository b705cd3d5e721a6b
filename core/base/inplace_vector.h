// A list of few items, without an allocation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace isoloop {

/// At most N items, in place.
template <class T, std::size_t N>
struct InplaceVector {
  std::array<T, N> items{};
  std::uint32_t count = 0;

  void push_back(T item) { items[count++] = item; }
  const T* begin() const { return items.data(); }
  const T* end() const { return items.data() + count; }
  T operator[](std::size_t i) const { return items[i]; }
};

}  // namespace isoloop
