// A bit for each block of one height of an octree.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isoloop {

/// Blocks numbered (x, y, z) below `dims`. Rows along x begin at a word of their own; bits beyond
/// a row are 0.
class BlockBits {
 public:
  explicit BlockBits(const std::array<std::uint32_t, 3>& dims)
      : dims_(dims),
        row_words_((std::size_t{dims[0]} + 63) / 64),
        words_(row_words_ * dims[1] * dims[2]) {}
  BlockBits() = default;

  const std::array<std::uint32_t, 3>& dims() const { return dims_; }
  std::size_t row_words() const { return row_words_; }

  std::uint64_t* row(std::uint32_t y, std::uint32_t z) {
    return words_.data() + row_words_ * (y + std::size_t{dims_[1]} * z);
  }
  const std::uint64_t* row(std::uint32_t y, std::uint32_t z) const {
    return words_.data() + row_words_ * (y + std::size_t{dims_[1]} * z);
  }

  bool operator()(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    return (row(y, z)[x / 64] >> (x % 64) & 1U) != 0;
  }
  void insert(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    row(y, z)[x / 64] |= std::uint64_t{1} << (x % 64);
  }

  /// Joins a set of the same dims.
  void insert(const BlockBits& other);

 private:
  std::array<std::uint32_t, 3> dims_{};
  std::size_t row_words_ = 0;
  std::vector<std::uint64_t> words_;
};

/// All within `steps`[a] blocks along each axis a of one of `blocks`.
BlockBits dilated(BlockBits blocks, const std::array<std::uint32_t, 3>& steps);

/// The blocks of the next height, twice as wide, that hold one of `blocks`.
BlockBits parents_of(const BlockBits& blocks);

}  // namespace isoloop
