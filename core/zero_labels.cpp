#include "core/zero_labels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include <tbb/parallel_for.h>

namespace isoloop {
namespace {

using Word = std::uint64_t;

/// A bit for each vertex of the box. Layers begin at a word of their own, after enough words of
/// ones that a vertex' neighbours at lesser x and y can be read everywhere; one more layer of ones
/// comes first.
class Plane {
 public:
  explicit Plane(const Lattice& lattice)
      : pad_(lattice.dims[0] / 64 + 2),
        per_layer_(pad_ + (std::size_t{lattice.stride[2]} + 63) / 64),
        words_(per_layer_ * (std::size_t{lattice.dims[2]} + 1), ~Word{0}) {}

  std::size_t words_in_layer() const { return per_layer_ - pad_; }
  Word* layer(std::uint32_t z) { return words_.data() + (std::size_t{z} + 1) * per_layer_ + pad_; }
  Word* layer_before(std::uint32_t z) { return layer(z) - per_layer_; }

 private:
  std::size_t pad_;
  std::size_t per_layer_;
  std::vector<Word> words_;
};

/// The bits that lie `distance` before those of a word.
struct Back {
  std::size_t words;
  unsigned bits;

  explicit Back(std::uint32_t distance) : words(distance / 64), bits(distance % 64) {}

  Word read(const Word* word) const {
    const Word* const at = word - words;
    return bits == 0 ? *at : *at << bits | *(at - 1) >> (64 - bits);
  }

  void insert(Word* word, Word found) const {
    Word* const at = word - words;
    *at |= found >> bits;
    if (bits != 0) *(at - 1) |= found << (64 - bits);
  }
};

/// Where three of four are known.
Word all_but_one(Word p, Word q, Word r, Word s) {
  return ((p & q) & (r ^ s)) | ((r & s) & (p ^ q));
}

class PlainRings {
 public:
  PlainRings(const GridComplex& complex, const BitSet& forest)
      : complex_(complex),
        lattice_(complex.lattice()),
        by_x_(lattice_.stride[0]),
        by_y_(lattice_.stride[1]),
        known_{Plane(lattice_), Plane(lattice_), Plane(lattice_)},
        plain_{Plane(lattice_), Plane(lattice_), Plane(lattice_)},
        chunk_(std::max<std::size_t>(least_chunk, by_y_.words + 2)),
        chunks_((known_[0].words_in_layer() + chunk_ - 1) / chunk_),
        is_dirty_(chunks_ * lattice_.dims[2], 1),
        is_layer_dirty_(lattice_.dims[2], 1),
        other_edges_(lattice_.dims[2]) {
    tbb::parallel_for(std::uint32_t{0}, lattice_.dims[2],
                      [&](std::uint32_t z) { read_layer(z, forest); });
  }

  /// Slabs that are neighbours share a layer of pieces: every other slab at a time. A chain of
  /// conclusions may cross from slab to slab many thousand times, so a round costs little where
  /// there is little to read.
  void close() {
    const std::uint32_t slabs = (lattice_.dims[2] + layers_in_slab - 1) / layers_in_slab;
    std::vector<std::uint32_t> dirty;
    for (std::uint32_t quiet = 0, parity = 0; quiet < 2; parity ^= 1U) {
      dirty.clear();
      for (std::uint32_t slab = parity; slab < slabs; slab += 2)
        if (is_slab_dirty(slab)) dirty.push_back(slab);
      quiet = dirty.empty() ? quiet + 1 : 0;
      tbb::parallel_for(std::size_t{0}, dirty.size(), [&](std::size_t i) { close_slab(dirty[i]); });
    }
  }

  /// The interior edges with other rings.
  std::vector<std::uint32_t> other_edges() const {
    std::vector<std::uint32_t> all;
    for (const auto& edges : other_edges_) all.insert(all.end(), edges.begin(), edges.end());
    return all;
  }

  void write(BitSet& known) {
    for (std::uint32_t z = 0; z < lattice_.dims[2]; ++z) {
      std::uint32_t v = lattice_.vertex(0, 0, z);
      const std::array<const Word*, 3> bits{known_[0].layer(z), known_[1].layer(z),
                                            known_[2].layer(z)};
      for (std::uint32_t i = 0; i < lattice_.stride[2]; ++i, ++v)
        for (std::uint32_t a = 0; a < 3; ++a)
          if ((bits[a][i / 64] >> (i % 64) & 1U) != 0) known.insert(3 * v + a);
    }
  }

 private:
  static constexpr std::size_t least_chunk = 8;       // words
  static constexpr std::uint32_t layers_in_slab = 4;  // layers

  void read_layer(std::uint32_t z, const BitSet& forest) {
    std::array<Word*, 3> known{};
    std::array<Word*, 3> plain{};
    for (std::size_t a = 0; a < 3; ++a) {
      known[a] = known_[a].layer(z);
      plain[a] = plain_[a].layer(z);
      std::fill(plain[a], plain[a] + plain_[a].words_in_layer(), 0);
    }
    std::uint32_t i = 0;
    for (std::uint32_t y = 0; y < lattice_.dims[1]; ++y)
      for (std::uint32_t x = 0; x < lattice_.dims[0]; ++x, ++i) {
        const std::uint32_t v = lattice_.vertex(x, y, z);
        const unsigned faces = complex_.faces_at(v, {x, y, z});
        const unsigned edges = complex_.edges_at(v, {x, y, z});
        const unsigned plain_edges = edges == 0 ? 0 : edges & complex_.plain_rings_at(v, {x, y, z});
        for (std::uint32_t a = 0; a < 3; ++a) {
          if ((faces >> a & 1U) != 0 && !forest[3 * v + a])
            known[a][i / 64] &= ~(Word{1} << (i % 64));
          plain[a][i / 64] |= Word{plain_edges >> a & 1U} << (i % 64);
          if (((edges ^ plain_edges) >> a & 1U) != 0) other_edges_[z].push_back(3 * v + a);
        }
      }
  }

  std::uint32_t slab_end(std::uint32_t slab) const {
    return std::min((slab + 1) * layers_in_slab, lattice_.dims[2]);
  }

  bool is_slab_dirty(std::uint32_t slab) const {
    const std::uint8_t* const first = is_layer_dirty_.data() + slab * layers_in_slab;
    const std::uint8_t* const last = is_layer_dirty_.data() + slab_end(slab);
    return std::find(first, last, 1) != last;
  }

  void close_slab(std::uint32_t slab) {
    while (is_slab_dirty(slab)) {
      for (std::uint32_t z = slab * layers_in_slab; z < slab_end(slab); ++z) close_layer(z);
      for (std::uint32_t z = slab_end(slab); z-- > slab * layers_in_slab;) close_layer(z);
    }
  }

  void close_layer(std::uint32_t z) {
    if (is_layer_dirty_[z] == 0) return;
    std::uint8_t* const dirty = is_dirty_.data() + z * chunks_;
    std::size_t from = 0;
    while (const void* const found = std::memchr(dirty + from, 1, chunks_ - from)) {
      const auto chunk = static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - dirty);
      dirty[chunk] = 0;
      from = chunk;
      if (!close_chunk(z, chunk)) continue;
      mark_near(z, chunk);
      if (chunk > 0) --from;
    }
    is_layer_dirty_[z] = 0;
  }

  void mark_near(std::uint32_t z, std::size_t chunk) {
    const std::size_t first = chunk == 0 ? 0 : chunk - 1;
    const std::size_t last = std::min(chunk + 2, chunks_);
    for (std::uint32_t near = z == 0 ? 0 : z - 1; near < std::min(z + 2, lattice_.dims[2]);
         ++near) {
      is_layer_dirty_[near] = 1;
      std::fill(is_dirty_.begin() + static_cast<std::ptrdiff_t>(near * chunks_ + first),
                is_dirty_.begin() + static_cast<std::ptrdiff_t>(near * chunks_ + last), 1);
    }
  }

  /// Says whether anything followed.
  bool close_chunk(std::uint32_t z, std::size_t chunk) {
    const std::size_t begin = chunk * chunk_;
    const std::size_t end = std::min(begin + chunk_, known_[0].words_in_layer());
    bool any = false;
    for (std::size_t w = begin; w < end; ++w)
      while (close_word(z, w)) any = true;
    return any;
  }

  /// Edge v along a, with b and c across: normal c at v and before it along b, normal b at v and
  /// before it along c.
  bool close_word(std::uint32_t z, std::size_t w) {
    const std::array<Word*, 3> here{known_[0].layer(z) + w, known_[1].layer(z) + w,
                                    known_[2].layer(z) + w};
    Word* const x_below = known_[0].layer_before(z) + w;
    Word* const y_below = known_[1].layer_before(z) + w;
    bool any = false;
    const auto conclude = [&](std::size_t a, Word* p, Word* q, Word r, Word s, const auto& insert_r,
                              const auto& insert_s) {
      const Word found = all_but_one(*p, *q, r, s) & plain_[a].layer(z)[w];
      if (found == 0) return;
      any = true;
      *p |= found;
      *q |= found;
      insert_r(found);
      insert_s(found);
    };
    conclude(
        0, here[2], here[1], by_y_.read(here[2]), *y_below,
        [&](Word found) { by_y_.insert(here[2], found); }, [&](Word found) { *y_below |= found; });
    conclude(
        1, here[0], here[2], *x_below, by_x_.read(here[2]), [&](Word found) { *x_below |= found; },
        [&](Word found) { by_x_.insert(here[2], found); });
    conclude(
        2, here[1], here[0], by_x_.read(here[1]), by_y_.read(here[0]),
        [&](Word found) { by_x_.insert(here[1], found); },
        [&](Word found) { by_y_.insert(here[0], found); });
    return any;
  }

  const GridComplex& complex_;
  const Lattice& lattice_;
  Back by_x_;
  Back by_y_;
  std::array<Plane, 3> known_;                // by normal: of the face with lowest corner v
  std::array<Plane, 3> plain_;                // by direction: of the edge from v
  std::size_t chunk_;                         // words
  std::size_t chunks_;                        // in a layer
  std::vector<std::uint8_t> is_dirty_;        // by layer and chunk: whether anything may follow
  std::vector<std::uint8_t> is_layer_dirty_;  // whether a chunk of it may be dirty
  std::vector<std::vector<std::uint32_t>> other_edges_;  // by layer
};

}  // namespace

BitSet zero_labels(const GridComplex& complex, const BitSet& forest) {
  BitSet known(complex.piece_bound());
  std::vector<std::uint32_t> todo;
  {
    PlainRings rings(complex, forest);
    rings.close();
    rings.write(known);
    todo = rings.other_edges();
  }
  for (std::uint32_t piece = complex.edge_bound(); piece < complex.piece_bound(); ++piece)
    if (forest[piece]) known.insert(piece);
  while (!todo.empty()) {
    const std::uint32_t edge = todo.back();
    todo.pop_back();
    std::uint32_t last = 0;
    int unknown = 0;
    for (const std::uint32_t piece : complex.ring(edge))
      if (!known[piece]) {
        last = piece;
        ++unknown;
      }
    if (unknown != 1) continue;
    known.insert(last);
    for (const std::uint32_t next : complex.edges_of(last)) todo.push_back(next);
  }
  return known;
}

}  // namespace isoloop
