// What becomes of the classes of loops when voxels change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/workings.h"
#include "core/z2/label.h"
#include "core/z2/z2_basis.h"

namespace isoloop {

/// Which walks are on both surfaces.
enum class CommonWalks {
  in_cubes,  // along triangles in cubes without a changed corner, which are the same in both
  on_edges   // and along those edges in other cubes that join the same grid edges in both
};

/// Compares H1 of M before and after a change of voxels, by the closed walks on what the two
/// surfaces have in common.
///
/// To compress M along disjoint curves whose classes span A (cut along handle loops, fill tunnel
/// loops) makes H1 of the result the classes that cross A evenly, modulo A; and H1(I), H1(O)
/// likewise. If the change did that and no more, every common walk of a class in A bounds
/// afterwards, the common walks reach all classes that cross A evenly, and what bounds inside, or
/// outside, still does. check() asks for all of this. It needs no choice of loops: every class that
/// A leaves is still there, of the same kind.
class HomologyMap {
 public:
  /// `changed`: by vertex of before's lattice. `removed`: a basis of A, as class_of() gives it.
  /// Both boundaries must be closed, and the genus before not 0. More walks may prove what fewer do
  /// not reach; where a whole handle went, along with walks that cross it oddly, fewer do.
  HomologyMap(const Workings& before, const Workings& after, const std::vector<bool>& changed,
              std::span<const GeneratorSet> removed, CommonWalks common = CommonWalks::in_cubes);

  /// Nothing if all that A leaves is still there and no more; else what is wrong.
  std::optional<std::string> check() const;

  /// The class afterwards of a class before, modulo A; nothing if it crosses A oddly, or common
  /// walks do not reach it.
  std::optional<GeneratorSet> image(const GeneratorSet& before) const;

 private:
  struct ClassPair {  // of one walk
    GeneratorSet before;
    GeneratorSet after;
  };

  void add(ClassPair pair);

  /// Whether the classes that bounded on that side do so afterwards.
  bool keeps_kind(Side bounding) const;

  std::uint32_t before_inside_ = 0;
  std::uint32_t before_rank_ = 0;
  std::uint32_t after_inside_ = 0;
  std::uint32_t after_rank_ = 0;
  std::size_t removed_ = 0;
  bool is_map_ = true;            // equal classes before have equal classes after
  std::vector<ClassPair> pairs_;  // of common walks, and A with 0, independent before
  Z2Basis basis_;                 // of the classes before
};

}  // namespace isoloop
