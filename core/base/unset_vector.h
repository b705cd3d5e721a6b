// Large arrays that many threads fill.
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace isoloop {

/// Leaves new elements unset where the vector would make them 0.
template <class T>
struct UnsetAllocator : std::allocator<T> {
  template <class U>
  void construct(U* place) noexcept {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    std::construct_at(place, std::forward<Arguments>(arguments)...);
  }
};

/// UnsetVector<T>(n) costs nothing but the addresses: the operating system makes each page when the
/// thread that fills it gets there.
template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace isoloop
