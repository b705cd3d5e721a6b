// A queue for Dijkstra's search: takes the least first, where no key exceeds the last one taken by
// more than a step of known length.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <vector>

namespace isoloop {

/// Keys that are not negative, with a value each; of equal keys the lesser value comes first. Lies
/// in buckets (Dial, Communications of the ACM 12, 1969), of which only the one that is being
/// emptied is kept in order: sorted, the least last, while it is short, else as a heap. A bucket is
/// long where most steps are far shorter than the longest, as between voxels that are far taller
/// than wide.
class BucketQueue {
 public:
  struct Item {
    float key = 0.0F;
    std::uint32_t value = 0;
  };

  /// No key pushed may be less than the one taken last, or exceed it by more than `longest_step`.
  explicit BucketQueue(double longest_step)
      : per_bucket_(static_cast<float>((bucket_count - 2) / longest_step)) {}

  bool empty() const { return size_ == 0; }

  void clear() {
    for (auto& bucket : buckets_) bucket.clear();
    size_ = 0;
    current_ = 0;
    is_heap_ = false;
  }

  void push(float key, std::uint32_t value) {
    // Non-negative floats compare as their bit patterns do.
    const std::uint64_t item = std::uint64_t{std::bit_cast<std::uint32_t>(key)} << 32 | value;
    const auto number = static_cast<std::uint64_t>(key * per_bucket_);
    auto& bucket = buckets_[number % bucket_count];
    ++size_;
    if (number != current_) {
      bucket.push_back(item);
    } else if (is_heap_) {
      bucket.push_back(item);
      std::push_heap(bucket.begin(), bucket.end(), std::greater<>{});
    } else {
      bucket.insert(std::upper_bound(bucket.begin(), bucket.end(), item, std::greater<>{}), item);
      if (bucket.size() <= longest_sorted) return;
      std::reverse(bucket.begin(), bucket.end());  // ascending: a heap with the least first
      is_heap_ = true;
    }
  }

  /// Removes the least. The queue must not be empty.
  Item take() {
    if (buckets_[current_ % bucket_count].empty()) {
      while (buckets_[++current_ % bucket_count].empty()) {
      }
      auto& next = buckets_[current_ % bucket_count];
      std::sort(next.begin(), next.end(), std::greater<>{});
      is_heap_ = false;
    }
    auto& bucket = buckets_[current_ % bucket_count];
    if (is_heap_) std::pop_heap(bucket.begin(), bucket.end(), std::greater<>{});
    const std::uint64_t item = bucket.back();
    bucket.pop_back();
    --size_;
    return {std::bit_cast<float>(static_cast<std::uint32_t>(item >> 32)),
            static_cast<std::uint32_t>(item)};
  }

 private:
  static constexpr std::uint64_t bucket_count = 128;
  static constexpr std::size_t longest_sorted = 512;

  std::array<std::vector<std::uint64_t>, bucket_count> buckets_;  // key, then value
  std::uint64_t current_ = 0;  // number of the bucket in order; the others follow it
  bool is_heap_ = false;       // that bucket
  std::size_t size_ = 0;
  float per_bucket_;
};

}  // namespace isoloop
