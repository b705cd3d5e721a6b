#include "core/z2/label.h"

#include <algorithm>
#include <iterator>

namespace isoloop {
namespace {

std::uint64_t hash_of(std::span<const std::uint32_t> members) {
  std::uint64_t h = members.size();
  for (const std::uint32_t m : members) {
    h = (h ^ m) * 0x9e3779b97f4a7c15U;
    h ^= h >> 32;
  }
  return h;
}

}  // namespace

GeneratorSet sum_of(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
  GeneratorSet sum;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum));
  return sum;
}

LabelPool::LabelPool() : first_{0, 0} { by_hash_.emplace(hash_of({}), 0); }

std::uint32_t LabelPool::intern(std::span<const std::uint32_t> generators) {
  const std::uint64_t hash = hash_of(generators);
  const auto [begin, end] = by_hash_.equal_range(hash);
  for (auto it = begin; it != end; ++it) {
    const auto known = this->generators(it->second);
    if (std::equal(known.begin(), known.end(), generators.begin(), generators.end()))
      return it->second;
  }
  const std::uint32_t label = count();
  members_.insert(members_.end(), generators.begin(), generators.end());
  first_.push_back(members_.size());
  by_hash_.emplace(hash, label);
  return label;
}

std::uint32_t LabelPool::sum_of_distinct(std::uint32_t a, std::uint32_t b) {
  const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  const auto known = sums_.find(key);
  if (known != sums_.end()) return known->second;
  const std::uint32_t label = intern(sum_of(generators(a), generators(b)));
  sums_.emplace(key, label);
  return label;
}

void SparseLabels::relabel(std::span<const std::uint32_t> map) {
  for (auto& chunk : chunks_)
    for (std::uint32_t& label : chunk) label = map[label];
}

}  // namespace isoloop
