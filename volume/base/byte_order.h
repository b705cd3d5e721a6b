// Byte orders of stored numbers.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>

#include "isoloop/read.h"

namespace isoloop {

inline constexpr Endian native_endian =
    std::endian::native == std::endian::big ? Endian::big : Endian::little;

/// Turns every value from one byte order to the other.
template <class T>
void swap_bytes(std::span<T> values) {
  if constexpr (sizeof(T) > 1) {
    for (T& value : values) {
      const auto bytes = std::as_writable_bytes(std::span<T, 1>(&value, 1));
      std::reverse(bytes.begin(), bytes.end());
    }
  }
}

/// The number whose bytes begin at `at`; `bytes` must hold all of them.
template <class T>
T load(std::span<const std::byte> bytes, std::size_t at, Endian endian) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  if (endian != native_endian) swap_bytes(std::span(&value, 1));
  return value;
}

}  // namespace isoloop
