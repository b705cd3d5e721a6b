// A basis of sparse vectors over Z2, and coordinates in it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/z2/label.h"

namespace isoloop {

/// Independent vectors v_0, v_1, ... in order of insertion, kept in echelon form.
class Z2Basis {
 public:
  /// Adds `vector` unless it depends on those before; says whether it was added.
  bool add(std::span<const std::uint32_t> vector);

  /// The set of numbers k such that the v_k sum to `vector`; nothing if it is not in their span.
  std::optional<GeneratorSet> coordinates(std::span<const std::uint32_t> vector) const;

  std::uint32_t rank() const { return static_cast<std::uint32_t>(rows_.size()); }

 private:
  struct Row {
    GeneratorSet vector;       // its greatest element is its pivot, no other row's
    GeneratorSet combination;  // the v_k that sum to it
  };
  Row reduce(std::span<const std::uint32_t> vector) const;

  std::vector<Row> rows_;
  std::unordered_map<std::uint32_t, std::uint32_t> row_of_pivot_;
};

}  // namespace isoloop
