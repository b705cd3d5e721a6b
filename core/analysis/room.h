// How many threads, and sides at a time, the memory has room for.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/analysis/workings.h"
#include "core/base/memory_budget.h"
#include "core/base/threads.h"
#include "core/engines/spanning_forest.h"

namespace isoloop {

/// Each of its functions throws LimitExceeded, naming the stage, if not for the least.
class Room {
 public:
  Room(const Workings& workings, std::uint64_t limit)
      : extent_{workings.sides->lattice.vertex_count(), workings.analysis.surface.points.size()},
        cells_(extent_.lattice),
        layers_(workings.sides->lattice.dims[2] + 1),
        limit_(limit) {
    if (!workings.octree) return;
    extent_.octree = workings.octree->vertex_count();
    cells_ = extent_.octree;
    layers_ = workings.octree->layer_count() + 1;
  }

  void check_closest() const { check_memory("closest", closest_bytes(extent_), limit_); }

  /// Threads at a time.
  int size_searches() const {
    return threads_within("sizes", sizes_bytes(extent_), size_search_bytes(extent_.surface), limit_,
                          thread_count());
  }
  int loop_searches() const {
    return threads_within("loops", loops_bytes(extent_), loop_search_bytes(extent_.surface), limit_,
                          thread_count());
  }

  struct Passes {
    int threads = 1;
    bool both_sides_at_once = false;
  };
  Passes passes(std::uint64_t sizes) const {
    const auto needed = [&](std::size_t threads, std::uint64_t sides) {
      return pass_bytes(extent_, sizes, sides) + slab_bytes(cells_, layers_, threads);
    };
    std::size_t threads = thread_count();
    while (threads > 1 && needed(threads, 1) > limit_) --threads;
    check_memory("pass", needed(threads, 1), limit_);
    return {static_cast<int>(threads), needed(threads, 2) <= limit_};
  }

 private:
  Extent extent_;
  std::uint64_t cells_;   // of the complex, about
  std::uint32_t layers_;  // of pieces
  std::uint64_t limit_;   // bytes
};

}  // namespace isoloop
