#include "core/octree/octree.h"

#include <algorithm>
#include <atomic>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

namespace isoloop {
namespace {

using Position = std::array<std::uint32_t, 3>;

/// Sets that many bits from `first` on; other threads may do so at the same time.
void insert_shared(std::vector<std::uint64_t>& words, std::uint32_t first, std::uint64_t bits) {
  const auto add = [&](std::size_t w, std::uint64_t added) {
    const std::atomic_ref word(words[w]);
    if ((word.load(std::memory_order_relaxed) & added) != added)
      word.fetch_or(added, std::memory_order_relaxed);
  };
  add(first / 64, bits << (first % 64));
  if (first % 64 != 0 && bits >> (64 - first % 64) != 0)
    add(first / 64 + 1, bits >> (64 - first % 64));
}

std::uint32_t layers_of(const Leaves& leaves) { return leaves.is_split[leaves.largest].dims()[2]; }

}  // namespace

Octree::Octree(const VoxelSides& sides, const Leaves& leaves) : lattice_(sides.lattice) {
  number_corners(leaves);
  offer_heights(leaves);
  note_sides(sides);
}

void Octree::number_corners(const Leaves& leaves) {
  std::vector<std::uint64_t> words(std::size_t{lattice_.vertex_count()} / 64 + 1);
  std::atomic<std::uint32_t> count = 0;
  tbb::parallel_for(std::uint32_t{0}, layers_of(leaves), [&](std::uint32_t layer) {
    std::uint32_t here = 0;
    for_each_leaf(leaves, layer, [&](const Position& p, std::uint32_t height) {
      ++here;
      const std::uint32_t first = lattice_.vertex(p[0], p[1], p[2]);
      const std::uint64_t ends = 1 | std::uint64_t{1} << (1U << height);
      for (const std::uint32_t row : {first, first + step(height, 1), first + step(height, 2),
                                      first + step(height, 1) + step(height, 2)})
        insert_shared(words, row, ends);
    });
    count += here;
  });
  leaf_count_ = count;
  corners_ = RankedBits(words);
  words = std::vector<std::uint64_t>();
  lattice_vertex_.resize(corners_.count());
  tbb::parallel_for(std::size_t{0}, corners_.word_count(), [&](std::size_t w) {
    corners_.visit_word(
        w, [&](std::uint32_t vertex, std::uint32_t at) { lattice_vertex_[vertex] = at; });
  });
  for (std::uint32_t layer = 0; layer << leaves.largest < lattice_.dims[2]; ++layer)
    first_.push_back(corners_.rank(lattice_.vertex(0, 0, layer << leaves.largest)));
  first_.push_back(corners_.count());
}

void Octree::offer_heights(const Leaves& leaves) {
  words_.assign(vertex_count(), 07777777);
  const auto offer = [&](std::uint32_t vertex, std::uint32_t shift, std::uint32_t height) {
    std::uint32_t& word = words_[vertex];
    if ((word >> shift & 7U) > height) word = (word & ~(7U << shift)) | height << shift;
  };
  const auto offer_leaf = [&](const Position& p, std::uint32_t height) {
    const std::uint32_t at = lattice_.vertex(p[0], p[1], p[2]);
    const std::uint32_t first = vertex_at(at);
    offer(first, 0, height);
    for (std::uint32_t a = 0; a < 3; ++a) {
      const std::uint32_t b = (a + 1) % 3;
      const std::uint32_t c = (a + 2) % 3;
      const std::uint32_t next = vertex_at(at + step(height, a));
      offer(first, first_face + 3 * a, height);
      offer(next, first_face + 3 * a, height);
      offer(first, first_edge + 3 * a, height);
      offer(next, first_edge + 3 * b, height);
      offer(next, first_edge + 3 * c, height);
      offer(vertex_at(at + step(height, b) + step(height, c)), first_edge + 3 * a, height);
    }
  };
  // A layer's leaves have corners in the first layer of vertices of the next as well: every other
  // one at a time.
  const std::uint32_t layers = layers_of(leaves);
  for (std::uint32_t parity = 0; parity < 2; ++parity)
    tbb::parallel_for(std::uint32_t{0}, (layers + 1 - parity) / 2,
                      [&](std::uint32_t i) { for_each_leaf(leaves, 2 * i + parity, offer_leaf); });
}

void Octree::note_sides(const VoxelSides& sides) {
  const tbb::blocked_range<std::uint32_t> all(0, vertex_count(), 1 << 12);
  tbb::parallel_for(all, [&](const auto& range) {
    for (std::uint32_t vertex = range.begin(); vertex < range.end(); ++vertex) {
      const std::uint8_t* const at = sides.inside.data() + lattice_vertex_[vertex];
      std::uint32_t word = words_[vertex];
      word |= std::uint32_t{at[0]} << inside;
      const std::uint8_t flags = sides.cubes[lattice_vertex_[vertex]];
      word |= std::uint32_t{(flags & VoxelSides::on_border) != 0} << border;
      word |= std::uint32_t{(flags & VoxelSides::many_outside_cells) != 0} << first_many;
      word |= std::uint32_t{(flags & VoxelSides::many_inside_cells) != 0} << (first_many + 1);
      for (std::uint32_t a = 0; a < 3; ++a) {
        const auto& stride = lattice_.stride;
        const std::uint32_t b = stride[(a + 1) % 3];
        const std::uint32_t c = stride[(a + 2) % 3];
        if ((word >> (first_face + 3 * a) & 7U) == 0 &&
            (at[0] != at[b] || at[0] != at[c] || at[0] != at[b + c]))
          word |= 1U << (first_cut_face + a);
        if ((word >> (first_edge + 3 * a) & 7U) == 0 && at[0] != at[stride[a]])
          word |= 1U << (first_cut_edge + a);
      }
      words_[vertex] = word;
    }
  });
}

std::uint32_t Octree::leaf_at(std::uint32_t cube, std::uint32_t least) const {
  const auto position = lattice_.position(cube);
  for (std::uint32_t height = least; height < none; ++height) {
    const std::uint32_t at = rounded(position, height);
    if (!corners_[at]) continue;
    const std::uint32_t vertex = vertex_at(at);
    if (leaf_height(vertex) == height) return vertex;
  }
  return no_vertex;
}

}  // namespace isoloop
