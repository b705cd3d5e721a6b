#include "core/base/memory_budget.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/errors.h"

namespace isoloop {

std::string bytes_text(std::uint64_t bytes) {
  constexpr std::array<const char*, 5> units{"bytes", "KiB", "MiB", "GiB", "TiB"};
  double amount = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; amount >= 1024.0 && unit + 1 < units.size(); ++unit) amount /= 1024.0;
  if (unit == 0) return std::to_string(bytes) + (bytes == 1 ? " byte" : " bytes");
  const auto tenths = std::llround(10.0 * amount);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " " + units[unit];
}

void check_memory(const char* stage, std::uint64_t needed, std::uint64_t limit) {
  if (needed <= limit) return;
  throw LimitExceeded(
      {.text = std::string("the stage '") + stage + "' needs " + bytes_text(needed) +
               " beside the volume, and the limit leaves " + bytes_text(limit),
       .advice = {Advice::raise_memory_limit, Advice::take_part}},
      {.unit = Excess::Unit::bytes, .needed = needed, .limit = limit, .stage = stage});
}

int threads_within(const char* stage, std::uint64_t shared, std::uint64_t each, std::uint64_t limit,
                   std::size_t threads) {
  check_memory(stage, shared + each, limit);
  return static_cast<int>(std::min<std::uint64_t>(threads, (limit - shared) / each));
}

// What one stage leaves to the next: for each lattice vertex 2.5 bytes of sides, 4 of closest
// vertices and at most 12.5 of sizes; for each vertex of M about 110 bytes of M and its graph. A
// pass takes 6 bytes more for each lattice vertex and side, for its trees and their open pieces.
// Searches for loops can seldom use the memory that the pass gives back, so it counts as held. An
// octree takes two bits of each lattice vertex and 8 bytes of each of its own, 4 of closest
// vertices and at most 18 of sizes; a pass takes 28 bytes more for each and side, 24 of them to
// count pieces round edges.

std::uint64_t surface_bytes(std::uint64_t lattice, std::uint64_t surface) {
  return 5 * lattice / 2 + 170 * surface;
}

std::uint64_t bare_surface_bytes(std::uint64_t lattice, std::uint64_t surface) {
  return 5 * lattice / 2 + 75 * surface;
}

std::uint64_t closest_bytes(const Extent& extent) {
  const auto& [lattice, surface, octree] = extent;
  if (octree != 0) return 11 * lattice / 4 + 12 * octree + 115 * surface;  // a tree of boxes
  return 21 * lattice / 2 + 110 * surface;                                 // a field of 8
}

std::uint64_t sizes_bytes(const Extent& extent) {
  const auto& [lattice, surface, octree] = extent;
  if (octree != 0) return 11 * lattice / 4 + 30 * octree + 192 * surface;
  return 19 * lattice + 192 * surface;
}

std::uint64_t pass_bytes(const Extent& extent, std::uint64_t sizes, std::uint64_t sides_at_once) {
  const auto& [lattice, surface, octree] = extent;
  const std::uint64_t held = 130 * surface + sizes;
  if (octree != 0) return 11 * lattice / 4 + (12 + 28 * sides_at_once) * octree + held;
  return (13 + 12 * sides_at_once) * lattice / 2 + held;
}

std::uint64_t loops_bytes(const Extent& extent) {
  const auto& [lattice, surface, octree] = extent;
  if (octree != 0) return 11 * lattice / 4 + 14 * octree + 174 * surface;
  return 17 * lattice + 174 * surface;
}

std::uint64_t held_bytes(std::uint64_t lattice, std::uint64_t surface) {
  return 5 * lattice / 2 + 200 * surface;
}

std::uint64_t remaining_bytes(std::uint64_t limit, std::uint64_t held) {
  return limit == unlimited_bytes ? limit : limit - std::min(limit, held);
}

std::uint64_t size_search_bytes(std::uint64_t surface) { return 8 * surface; }

std::uint64_t loop_search_bytes(std::uint64_t surface) { return 56 * surface; }

}  // namespace isoloop
