// A set of grid edges that knows how many of its members come before each.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include <tbb/parallel_for.h>

namespace isoloop {

/// Half a byte a lattice vertex.
class EdgeSet {
 public:
  using BlockBits = std::array<std::uint64_t, 3>;  // by axis: bit i is the edge at vertex 64 b + i

  /// `bits_of_block(b)` returns the BlockBits of lattice vertices 64 b .. 64 b + 63, of which the
  /// lattice has `vertex_count` at most; called for many blocks at a time.
  template <class BitsOfBlock>
  EdgeSet(std::uint32_t vertex_count, const BitsOfBlock& bits_of_block)
      : blocks_((std::size_t{vertex_count} + 63) / 64) {
    tbb::parallel_for(std::uint32_t{0}, block_count(),
                      [&](std::uint32_t b) { blocks_[b].members = bits_of_block(b); });
    for (Block& block : blocks_) {
      block.first = count_;
      for (std::size_t a = 0; a < 3; ++a) {
        block.before_axis[a] = static_cast<std::uint8_t>(count_ - block.first);
        count_ += static_cast<std::uint32_t>(std::popcount(block.members[a]));
      }
    }
  }
  EdgeSet() = default;

  std::uint32_t count() const { return count_; }

  bool operator[](std::uint32_t grid_edge) const {
    const std::uint32_t v = grid_edge / 3;
    return (blocks_[v / 64].members[grid_edge % 3] >> (v % 64) & 1U) != 0;
  }

  /// Bit i: whether the edge along `axis` at lattice vertex `first` + i is a member.
  std::uint64_t bits(std::uint32_t axis, std::uint32_t first) const {
    const std::size_t b = first / 64;
    const unsigned shift = first % 64;
    std::uint64_t found = blocks_[b].members[axis] >> shift;
    if (shift != 0 && b + 1 < blocks_.size()) found |= blocks_[b + 1].members[axis] << (64 - shift);
    return found;
  }

  /// Members before `grid_edge`, in the order of visit_block().
  std::uint32_t rank(std::uint32_t grid_edge) const {
    const std::uint32_t v = grid_edge / 3;
    const std::uint32_t axis = grid_edge - 3 * v;
    const Block& block = blocks_[v / 64];
    const std::uint64_t before = (std::uint64_t{1} << (v % 64)) - 1;
    return block.first + block.before_axis[axis] +
           static_cast<std::uint32_t>(std::popcount(block.members[axis] & before));
  }

  /// Calls visit(rank, grid edge) for the members at lattice vertices 64 b .. 64 b + 63: by axis,
  /// then by vertex.
  template <class Visit>
  void visit_block(std::uint32_t b, const Visit& visit) const {
    std::uint32_t rank = blocks_[b].first;
    for (std::uint32_t a = 0; a < 3; ++a)
      for (std::uint64_t left = blocks_[b].members[a]; left != 0; left &= left - 1)
        visit(rank++, 3 * (64 * b + static_cast<std::uint32_t>(std::countr_zero(left))) + a);
  }

  std::uint32_t block_count() const { return static_cast<std::uint32_t>(blocks_.size()); }

  std::uint64_t bytes() const { return blocks_.size() * sizeof(Block); }

 private:
  struct Block {
    BlockBits members{};
    std::uint32_t first = 0;                    // members in all blocks before
    std::array<std::uint8_t, 3> before_axis{};  // members of this block along lesser axes
  };
  std::vector<Block> blocks_;
  std::uint32_t count_ = 0;
};

}  // namespace isoloop
