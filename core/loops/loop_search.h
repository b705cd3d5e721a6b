// The shortest loops through a vertex of M whose classes are of use.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/loops/certificate.h"
#include "core/sizes/bucket_queue.h"
#include "core/surface/surface.h"
#include "core/z2/class_print.h"
#include "core/z2/label.h"

namespace isoloop {

struct FoundLoop {
  std::vector<Curve> curves;  // none visits a vertex twice; no two have an edge in common
  double length = 0.0;        // of all curves; unit of the spacing
  GeneratorSet other;         // its class in the homology of the other side, as in SplitClass
};

/// What loops a search is for, by class (see SplitClass): those whose part in the homology of their
/// own side is `own`, and how short one must be, by its part in the other side's homology, to be of
/// use (unit of the spacing; 0: never). Never asked about the class 0, once about any other.
struct WantedLoops {
  GeneratorSet own;
  std::function<double(std::span<const std::uint32_t> other)> useful_length;
};

struct SearchLimits {
  double longest = std::numeric_limits<double>::infinity();  // of a closed walk, with its stem
  std::uint32_t sheets = 1;  // classes of paths kept at each vertex, those of the shortest paths
  std::uint64_t most_settled = std::numeric_limits<std::uint64_t>::max();  // paths
};

/// What a search from one vertex came to.
struct SearchResult {
  std::vector<FoundLoop> loops;    // in the order in which their classes are met
  double shortest_crossing = 0.0;  // see LoopSearch::shortest_of_each_class
  std::uint64_t settled = 0;       // paths: what the search cost
  double searched = 0.0;           // limits.longest, or less if it gave up: how far it came
};

/// Dijkstra's search on M that carries classes: a path, an edge and a path back close a loop, and
/// the labels at the edge's ends say which (Erickson and Whittlesey, SODA 2005). With one sheet the
/// paths form a tree on M. With more the search runs on the homology cover of M, whose vertices are
/// pairs of a vertex of M and the class of a path to it; with all sheets it meets the shortest
/// closed walk of every class through its base. Written out rather than left to Boost.Graph, whose
/// search sets up arrays of M's size at each call. Keeps its arrays between searches: one object a
/// thread.
class LoopSearch {
 public:
  /// For loops of one side of M.
  LoopSearch(const Surface& surface, const SurfaceClasses& classes, Side side);

  /// To be called before the first search.
  void look_for(WantedLoops wanted);

  /// The shortest useful loop that runs through `base`, or on a stem from it, at most
  /// limits.longest long with the stem; returned without it. On one sheet. Nothing where there is
  /// none, or none was met before the search gave up.
  std::optional<FoundLoop> shortest(std::uint32_t base, const SearchLimits& limits);

  /// Whether the last search gave up, with limits.most_settled paths settled.
  bool gave_up() const { return gave_up_; }

  /// How far `vertex` is from the last search's base, along M; infinite where it did not come.
  double distance_to(std::uint32_t vertex) const;

  /// From here on searches meet only walks no farther than `edges` edges from `curve`; all walks
  /// again if it is empty.
  void stay_near(const Curve& curve, std::size_t edges);

  /// Returns, for every class met, the loop of the shortest closed walk through `base`, without its
  /// stem, if it is of use. `shortest_crossing` is the length of the shortest closed walk of any
  /// class, useful or not, whose part in the other side's homology has an odd number of the
  /// generators `crossing`; it equals `searched` where no walk is as short as that. One sheet is
  /// enough for this length.
  SearchResult shortest_of_each_class(std::uint32_t base, const SearchLimits& limits,
                                      std::span<const std::uint32_t> crossing = {});

 private:
  struct Label {
    ClassPrint own = 0;
    ClassPrint other = 0;
    bool operator==(const Label&) const = default;
  };
  /// A path from the base to a vertex: the shortest of its class.
  struct Path {
    float distance = 0.0F;
    std::uint32_t vertex = 0;
    Label label;
    std::uint32_t parent = 0;  // the path without its last edge
    std::uint32_t next = 0;    // another path to the same vertex
    bool is_odd = false;       // number of generators of the label that are counted as crossings
    bool is_settled = false;
  };
  struct EdgeClass {  // along an edge: what its label comes to for this object
    Label label;
    bool is_odd = false;
    std::uint32_t odd_for = 0;  // the search that is_odd is for
  };
  struct Reached {
    std::uint32_t search = 0;  // that last reached the vertex
    std::uint32_t first = 0;   // path to it
  };
  struct Closing {
    std::uint32_t from = 0;  // paths
    std::uint32_t to = 0;
    ClassPrint other = 0;
    double length = 0.0;  // with the stem
  };
  struct Met {  // a class, as its walk's labels sum to it
    GeneratorSet own;
    GeneratorSet other;
    double useful_length = 0.0;
    std::uint32_t asked = 0;  // the call of look_for() that it answers
  };

  template <class Close>
  void explore(std::uint32_t base, double& bound, const SearchLimits& limits, const Close& close);
  template <class Close>
  void extend(const Path& path, const double& bound, std::uint32_t sheets, const Close& close);
  void begin(std::uint32_t base);
  bool may_settle(const Path& path, std::uint32_t sheets) const;
  std::uint32_t first_path(std::uint32_t vertex) const;
  double useful_length(const Closing& closing);
  Curve walk_of(const Closing& closing) const;
  const EdgeClass& class_of_edge(std::uint32_t label);
  FoundLoop loop_of(const Closing& closing) const;

  const Surface& surface_;
  const SurfaceClasses& classes_;
  Side side_;
  WantedLoops wanted_;
  std::uint32_t asked_ = 0;  // calls of look_for()
  ClassPrint wanted_own_ = 0;
  std::unordered_map<ClassPrint, Met> met_;  // by the print of own and other
  std::vector<EdgeClass> edge_classes_;      // by number in classes_.pool
  std::span<const std::uint32_t> crossing_;
  std::vector<std::uint32_t> near_;  // by vertex: the call of stay_near() that last allowed it
  std::uint32_t stays_ = 0;          // calls of stay_near()
  bool is_bounded_ = false;          // by the last of them
  std::vector<Reached> reached_;     // by vertex
  std::vector<Path> paths_;
  BucketQueue queue_;  // paths by distance
  std::uint32_t current_ = 0;
  std::uint64_t settled_ = 0;  // in this search
  bool gave_up_ = false;       // this search
  double searched_ = 0.0;      // see SearchResult
  double shortest_crossing_ = 0.0;
};

}  // namespace isoloop
