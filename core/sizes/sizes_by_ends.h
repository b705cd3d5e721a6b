// Sizes of edges of K by the vertices of M that are closest to their ends.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/sizes/vertex_pairs.h"
#include "core/surface/surface.h"
#include "isoloop/loop.h"

namespace isoloop {

/// Distances along M between vertices of it.
class SizesByEnds {
 public:
  using Ends = std::array<std::uint32_t, 2>;

  /// `for_each_ends` calls its visitor with all ends that of() is to be asked for, in any order,
  /// the same in both of two calls. It may do so from many threads.
  template <class ForEachEnds>
  SizesByEnds(const Surface& surface, GeodesicMode mode, const ForEachEnds& for_each_ends)
      : surface_(surface) {
    PairCollector collector(static_cast<std::uint32_t>(surface.points.size()));
    for_each_ends([&](const Ends& ends) {
      if (are_apart(ends)) collector.count(ends[0], ends[1]);
    });
    collector.end_of_counting();
    for_each_ends([&](const Ends& ends) {
      if (are_apart(ends)) collector.add(ends[0], ends[1]);
    });
    pairs_ = collector.take();
    search(mode);
  }

  /// Unit of the spacing; 0 where both ends are one vertex, infinite where they lie on different
  /// components of M.
  float of(const Ends& ends) const;

 private:
  bool are_on_one_component(const Ends& ends) const {
    const auto& component = surface_.component_of_vertex;
    return component[ends[0]] == component[ends[1]];
  }
  bool are_apart(const Ends& ends) const {
    return ends[0] != ends[1] && are_on_one_component(ends);
  }

  void search(GeodesicMode mode);

  const Surface& surface_;
  VertexPairs pairs_;
  std::vector<float> lengths_;  // by position in pairs_.partner
};

}  // namespace isoloop
