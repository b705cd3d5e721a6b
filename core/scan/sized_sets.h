// Sets of vertices that grow together, and how many of them hold so many vertices or more.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/disjoint_sets.h"

namespace isoloop {

/// Vertices enter as sets of their own and are then united.
class SizedSets {
 public:
  /// `sizes`: at which to count, each at least 1.
  SizedSets(std::uint32_t vertices, std::span<const std::int64_t> sizes)
      : sets_(vertices),
        weight_(vertices),
        sizes_(sizes.begin(), sizes.end()),
        of_size_(sizes.size()) {}

  /// `weight`: the vertices that it counts for; all of them together fit 32 bits.
  void enter(std::uint32_t vertex, std::uint32_t weight = 1) {
    weight_[vertex] = weight;
    count(weight, 1);
  }

  void unite(std::uint32_t a, std::uint32_t b) {
    a = sets_.find(a);
    b = sets_.find(b);
    if (a == b) return;
    count(weight_[a], -1);
    count(weight_[b], -1);
    const std::uint32_t both = weight_[a] + weight_[b];
    sets_.unite(a, b);
    weight_[std::min(a, b)] = both;
    count(both, 1);
  }

  std::int64_t all() const { return all_; }

  /// Sets of at least so many vertices, by size.
  const std::vector<std::int64_t>& of_size() const { return of_size_; }

  /// Vertices of the largest set so far.
  std::uint32_t largest() const { return largest_; }

 private:
  void count(std::uint32_t weight, std::int64_t sign) {
    all_ += sign;
    largest_ = std::max(largest_, weight);
    for (std::size_t i = 0; i < sizes_.size(); ++i) of_size_[i] += weight >= sizes_[i] ? sign : 0;
  }

  DisjointSets sets_;
  std::vector<std::uint32_t> weight_;  // of roots
  std::vector<std::int64_t> sizes_;
  std::int64_t all_ = 0;
  std::vector<std::int64_t> of_size_;
  std::uint32_t largest_ = 0;
};

}  // namespace isoloop
