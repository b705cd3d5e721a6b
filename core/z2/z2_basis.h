// A basis of sparse vectors over Z2, and coordinates in it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/z2/label.h"
#include "core/z2/z2_vector.h"

namespace isoloop {

/// Independent vectors v_0, v_1, ... in order of insertion, kept in echelon form: each of its rows
/// has a greatest element, its pivot, that is in no row after it.
class Z2Basis {
 public:
  /// Adds `vector` unless it depends on those before: the new row's pivot, or nothing.
  std::optional<std::uint32_t> add(std::span<const std::uint32_t> vector);

  /// The set of numbers k such that the v_k sum to `vector`; nothing if it is not in their span.
  std::optional<GeneratorSet> coordinates(std::span<const std::uint32_t> vector) const;

  /// What is left of `vector` modulo the span: the one set without a pivot that it can be changed
  /// to by adding some of the v_k.
  GeneratorSet remainder(std::span<const std::uint32_t> vector) const {
    return reduce(vector).vector.ones();
  }

  bool is_pivot(std::uint32_t element) const { return row_of_pivot_.count(element) > 0; }

  std::uint32_t rank() const { return static_cast<std::uint32_t>(rows_.size()); }

 private:
  struct Row {
    Z2Vector vector;       // its greatest element is its pivot; it holds none of those before
    Z2Vector combination;  // the v_k that sum to it
  };
  Row reduce(std::span<const std::uint32_t> vector) const;

  std::vector<Row> rows_;
  std::unordered_map<std::uint32_t, std::uint32_t> row_of_pivot_;
};

}  // namespace isoloop
