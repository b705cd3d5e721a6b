// How much memory the pipeline may hold, asked before each stage that takes much.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "isoloop/run.h"

namespace isoloop {

/// "2.0 GiB", "512.0 MiB", "50 bytes".
std::string bytes_text(std::uint64_t bytes);

/// Throws LimitExceeded, naming the stage and both figures, if it needs more than `limit` bytes.
void check_memory(const char* stage, std::uint64_t needed, std::uint64_t limit);

/// How many of `threads` there is room for at a time, each of which takes `each` bytes, at least 1,
/// beside `shared`. Throws as check_memory() does if not for one.
int threads_within(const char* stage, std::uint64_t shared, std::uint64_t each, std::uint64_t limit,
                   std::size_t threads);

/// What a pipeline takes depends on: vertices of the box round the solid, of M, and of the octree
/// if there is one.
struct Extent {
  std::uint64_t lattice = 0;
  std::uint64_t surface = 0;
  std::uint64_t octree = 0;
};

/// Bytes that the pipeline holds at most during each stage, the grid's voxels not among them, with
/// `sizes` bytes of sizes: fitted to peaks that were measured on thick parts, thin vessels and
/// lattices of tubes.
std::uint64_t surface_bytes(std::uint64_t lattice, std::uint64_t surface);
std::uint64_t bare_surface_bytes(std::uint64_t lattice, std::uint64_t surface);  // no edge graph
std::uint64_t closest_bytes(const Extent& extent);
std::uint64_t sizes_bytes(const Extent& extent);  // but for searches
std::uint64_t pass_bytes(const Extent& extent, std::uint64_t sizes,
                         std::uint64_t sides_at_once);  // but for the slabs of largest_forest()
std::uint64_t loops_bytes(const Extent& extent);        // but for searches

/// Bytes that an analysis holds once it is made.
std::uint64_t held_bytes(std::uint64_t lattice, std::uint64_t surface);

/// What is left of `limit` beside `held` bytes; unlimited_bytes remains.
std::uint64_t remaining_bytes(std::uint64_t limit, std::uint64_t held);

/// Bytes that each thread takes for its searches on M.
std::uint64_t size_search_bytes(std::uint64_t surface);
std::uint64_t loop_search_bytes(std::uint64_t surface);

}  // namespace isoloop
