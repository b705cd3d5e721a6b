#include "core/octree/block_bits.h"

#include <algorithm>

#include <tbb/parallel_for.h>

namespace isoloop {
namespace {

/// Adds the neighbours along x of each bit of a row.
void widen(std::uint64_t* row, std::size_t words, std::uint32_t length) {
  std::uint64_t before = 0;  // the word before, as it was
  for (std::size_t w = 0; w < words; ++w) {
    const std::uint64_t here = row[w];
    const std::uint64_t after = w + 1 < words ? row[w + 1] : 0;
    row[w] = here | here << 1 | here >> 1 | before >> 63 | after << 63;
    before = here;
  }
  if (length % 64 != 0) row[words - 1] &= (std::uint64_t{1} << (length % 64)) - 1;
}

/// The rows at y and z and at the neighbours along `axis`, 1 or 2, in one.
BlockBits joined_rows(const BlockBits& blocks, int axis) {
  const auto& dims = blocks.dims();
  BlockBits joined = blocks;
  const auto add = [&](std::uint64_t* to, const std::uint64_t* from) {
    std::transform(from, from + blocks.row_words(), to, to,
                   [](std::uint64_t a, std::uint64_t b) { return a | b; });
  };
  tbb::parallel_for(std::uint32_t{0}, dims[2], [&](std::uint32_t z) {
    for (std::uint32_t y = 0; y < dims[1]; ++y) {
      const std::uint32_t at = axis == 1 ? y : z;
      const auto beside = [&](std::uint32_t other) {
        return axis == 1 ? blocks.row(other, z) : blocks.row(y, other);
      };
      if (at > 0) add(joined.row(y, z), beside(at - 1));
      if (at + 1 < dims[axis]) add(joined.row(y, z), beside(at + 1));
    }
  });
  return joined;
}

/// Bits 0, 2, 4, ... of a word in its lower half.
std::uint64_t every_other(std::uint64_t word) {
  word &= 0x5555555555555555U;
  word = (word | word >> 1) & 0x3333333333333333U;
  word = (word | word >> 2) & 0x0f0f0f0f0f0f0f0fU;
  word = (word | word >> 4) & 0x00ff00ff00ff00ffU;
  word = (word | word >> 8) & 0x0000ffff0000ffffU;
  return (word | word >> 16) & 0x00000000ffffffffU;
}

}  // namespace

void BlockBits::insert(const BlockBits& other) {
  std::transform(other.words_.begin(), other.words_.end(), words_.begin(), words_.begin(),
                 [](std::uint64_t a, std::uint64_t b) { return a | b; });
}

BlockBits dilated(BlockBits blocks, const std::array<std::uint32_t, 3>& steps) {
  const auto& dims = blocks.dims();
  for (std::uint32_t i = 0; i < steps[0]; ++i)
    for (std::uint32_t z = 0; z < dims[2]; ++z)
      for (std::uint32_t y = 0; y < dims[1]; ++y)
        widen(blocks.row(y, z), blocks.row_words(), dims[0]);
  for (const int axis : {1, 2})
    for (std::uint32_t i = 0; i < steps[axis]; ++i) blocks = joined_rows(blocks, axis);
  return blocks;
}

BlockBits parents_of(const BlockBits& blocks) {
  const auto& dims = blocks.dims();
  BlockBits parents({(dims[0] + 1) / 2, (dims[1] + 1) / 2, (dims[2] + 1) / 2});
  for (std::uint32_t z = 0; z < dims[2]; ++z)
    for (std::uint32_t y = 0; y < dims[1]; ++y) {
      const std::uint64_t* const row = blocks.row(y, z);
      std::uint64_t* const parent = parents.row(y / 2, z / 2);
      for (std::size_t w = 0; w < blocks.row_words(); ++w)
        parent[w / 2] |= every_other(row[w] | row[w] >> 1) << (w % 2 * 32);
    }
  return parents;
}

}  // namespace isoloop
