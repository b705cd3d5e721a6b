// The distinct pairs of surface vertices whose distance along M is asked for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/base/compressed_rows.h"
#include "core/base/unset_vector.h"

namespace isoloop {

/// Pairs {a, b}, a < b, grouped by a: the partners of a are partner[first[a]] ..
/// partner[first[a+1]-1], ascending and distinct.
struct VertexPairs {
  std::vector<std::uint32_t> first;  // size: vertices + 1
  UnsetVector<std::uint32_t> partner;

  std::uint32_t source_count() const { return static_cast<std::uint32_t>(first.size() - 1); }

  /// Position of {a, b} in partner; a != b. Throws SelfCheckFailed where it is not there.
  std::uint32_t find(std::uint32_t a, std::uint32_t b) const;
};

/// Collects pairs in two rounds, as RowCollector does.
class PairCollector {
 public:
  explicit PairCollector(std::uint32_t vertices) : rows_(vertices) {}
  void count(std::uint32_t a, std::uint32_t b) { rows_.count(std::min(a, b)); }
  void end_of_counting() { rows_.end_of_counting(); }
  void add(std::uint32_t a, std::uint32_t b) { rows_.add(std::min(a, b), std::max(a, b)); }
  VertexPairs take();  // drops repetitions; the collector is spent

 private:
  RowCollector rows_;
};

}  // namespace isoloop
