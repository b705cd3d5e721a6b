// The distinct pairs of surface vertices whose distance along M is asked for.
#pragma once

#include <cstdint>
#include <vector>

namespace isoloop {

/// Pairs {a, b}, a < b, grouped by a: the partners of a are partner[first[a]] ..
/// partner[first[a+1]-1], ascending and distinct.
struct VertexPairs {
  std::vector<std::uint32_t> first;  // size: vertices + 1
  std::vector<std::uint32_t> partner;

  std::uint32_t source_count() const { return static_cast<std::uint32_t>(first.size() - 1); }

  /// Position of {a, b} in partner. It must be there; a != b.
  std::uint32_t find(std::uint32_t a, std::uint32_t b) const;
};

/// Collects pairs in two rounds over the same sequence: first count() each, then add() each.
/// Both may be called from many threads at once; the result does not depend on their order.
class PairCollector {
 public:
  explicit PairCollector(std::uint32_t vertices);
  void count(std::uint32_t a, std::uint32_t b);
  void end_of_counting();
  void add(std::uint32_t a, std::uint32_t b);
  VertexPairs take();  // sorts and drops repetitions; the collector is spent

 private:
  std::vector<std::uint32_t> first_;   // while counting: at a + 1, the pairs of a
  std::vector<std::uint32_t> cursor_;  // where the next partner of a goes
  std::vector<std::uint32_t> partner_;
};

}  // namespace isoloop
