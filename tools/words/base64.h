// Bytes as text.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace isoloop {

/// RFC 4648, with padding.
std::string base64(std::span<const std::uint8_t> bytes);

/// Appends an unsigned integer, its low byte first.
template <class Number>
void append_little_endian(std::vector<std::uint8_t>& bytes, Number number) {
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i) & 0xFFU));
}

}  // namespace isoloop
