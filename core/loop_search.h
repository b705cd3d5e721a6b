// The shortest loop through a vertex of M whose class is wanted.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/certificate.h"
#include "core/label.h"
#include "core/surface.h"

namespace isoloop {

struct FoundLoop {
  Curve curve;
  double length = 0.0;  // unit of the spacing
};

/// Says of a class (generators as in SurfaceClasses; never the empty one) whether it is wanted.
using WantedClass = std::function<bool(std::span<const std::uint32_t>)>;

/// Dijkstra's search on M that carries classes: a tree path, an edge and a tree path back close a
/// loop, and the labels at the edge's ends say which (Erickson and Whittlesey, SODA 2005). Written
/// out rather than left to Boost.Graph, whose search sets up arrays of M's size at each call.
/// Keeps its arrays between searches: one object a thread.
class LoopSearch {
 public:
  LoopSearch(const Surface& surface, const SurfaceClasses& classes);

  /// Among the loops of a wanted class that run through `base`, or on a stem from it, at most
  /// `longest` long with the stem: the shortest without its stem. Nothing where there is none.
  std::optional<FoundLoop> run(std::uint32_t base, double longest, const WantedClass& wanted);

 private:
  struct Closing {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    float length = 0.0F;  // of the edge
  };

  void begin();
  void reach(std::uint32_t vertex, float distance, std::uint32_t parent, std::uint32_t label);
  bool is_reached(std::uint32_t vertex) const { return round_[vertex] == current_; }
  bool is_wanted(std::uint32_t label, const WantedClass& wanted);
  std::uint32_t local(std::uint32_t label);
  FoundLoop loop_through(const Closing& closing) const;

  const Surface& surface_;
  const SurfaceClasses& classes_;
  LabelPool pool_;                                          // labels met so far, by this object
  std::unordered_map<std::uint32_t, std::uint32_t> local_;  // their numbers in classes_.pool
  std::unordered_map<std::uint32_t, bool> verdict_;         // of wanted(), in this search
  std::vector<std::uint32_t> round_;  // the search that last reached each vertex
  std::vector<std::uint8_t> settled_;
  std::vector<float> distance_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> label_;  // of the tree path; numbers in pool_
  std::vector<std::pair<float, std::uint32_t>> queue_;
  std::uint32_t current_ = 0;
};

}  // namespace isoloop
