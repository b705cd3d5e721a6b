// A basis of loops that gives up a loop whenever a shorter one can take its place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/per_thread.h"
#include "core/loops/certificate.h"
#include "core/loops/loop_search.h"
#include "core/surface/surface.h"
#include "core/z2/z2_basis.h"

namespace isoloop {

/// A cycle that bounds on the basis's own side.
struct BasisMember {
  std::vector<Curve> curves;
  double length = 0.0;           // unit of the spacing
  GeneratorSet other;            // its class in the homology of the other side
  std::uint32_t loop = no_loop;  // the loop that it is, unless a search has found it

  static constexpr auto no_loop = static_cast<std::uint32_t>(-1);
};

/// A search for loops that can take a member's place, through a vertex of M.
struct SearchStart {
  std::uint32_t vertex = 0;
  SearchLimits limits;
  std::span<const std::uint32_t> crossing;  // see LoopSearch::shortest_of_each_class
};

struct SearchCost {
  std::uint64_t settled = 0;       // paths
  double shortest_crossing = 0.0;  // see LoopSearch::shortest_of_each_class
  double searched = 0.0;           // the longest loops that it can have met
};

/// Always holds the shortest basis that can be made of the members it began with and the loops that
/// its searches have met: the greedy algorithm of a matroid, kept up to date.
class BasisExchange {
 public:
  /// `members`: independent, and a basis of what bounds on `side`.
  BasisExchange(const Surface& surface, const SurfaceClasses& classes, Side side,
                std::vector<BasisMember> members);

  const std::vector<BasisMember>& members() const { return members_; }  // by length

  /// Searches from every start, in parallel, and makes the exchanges. The outcome depends on the
  /// starts and their order alone.
  std::vector<SearchCost> search(std::span<const SearchStart> starts);

 private:
  LoopSearch new_search() const;
  void look_for_exchanges(LoopSearch& search) const;
  void keep_shortest();

  std::vector<BasisMember> members_;
  Z2Basis basis_;  // vector k is the class of members_[k]
  const Surface& surface_;
  const SurfaceClasses& classes_;
  Side side_;
  PerThread<LoopSearch> searches_;
};

}  // namespace isoloop
