// Union-find on 32-bit numbers.
#pragma once

#include <atomic>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace isoloop {

/// Links the larger root below the smaller and halves paths: the roots are the least members, so
/// they do not depend on the order of the unions.
class DisjointSets {
 public:
  explicit DisjointSets(std::uint32_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::uint32_t find(std::uint32_t member) {
    while (parent_[member] != member) {
      parent_[member] = parent_[parent_[member]];
      member = parent_[member];
    }
    return member;
  }

  /// False if both were in one set already.
  bool unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (a > b) std::swap(a, b);
    parent_[b] = a;
    return true;
  }

  /// find() that other threads may call at the same time, beside unite_shared(). By the time that
  /// it returns, another thread may have linked the root below a smaller one. Several threads may
  /// halve one path: what each of them stores for a member is an ancestor of it.
  std::uint32_t find_shared(std::uint32_t member) {
    for (;;) {
      const std::atomic_ref entry(parent_[member]);
      const std::uint32_t parent = entry.load(std::memory_order_relaxed);
      if (parent == member) return member;
      const std::uint32_t above = std::atomic_ref(parent_[parent]).load(std::memory_order_relaxed);
      if (above != parent) entry.store(above, std::memory_order_relaxed);
      member = parent;
    }
  }

  /// unite() that other threads may call at the same time, with other members or the same; true for
  /// one of the calls that make two sets one.
  bool unite_shared(std::uint32_t a, std::uint32_t b) {
    for (;;) {
      a = find_shared(a);
      b = find_shared(b);
      if (a == b) return false;
      if (a > b) std::swap(a, b);
      std::uint32_t root = b;
      // Fails if another thread has linked b since.
      if (std::atomic_ref(parent_[b]).compare_exchange_strong(root, a, std::memory_order_relaxed))
        return true;
    }
  }

  /// Makes root() valid for all members, until the next union; linear, one pass.
  void flatten() {
    for (std::uint32_t& parent : parent_) parent = parent_[parent];  // parents come first
  }

  /// find() after flatten(); may be called from many threads.
  std::uint32_t root(std::uint32_t member) const { return parent_[member]; }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace isoloop
