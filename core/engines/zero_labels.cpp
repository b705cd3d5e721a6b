#include "core/engines/zero_labels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
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
  Word* layer(std::uint32_t z) { return words_.data() + begin(z); }
  const Word* layer(std::uint32_t z) const { return words_.data() + begin(z); }
  Word* layer_before(std::uint32_t z) { return layer(z) - per_layer_; }
  const Word* layer_before(std::uint32_t z) const { return layer(z) - per_layer_; }

  /// Bits by number. Those before a vertex along an axis can be read everywhere.
  std::size_t first_bit(std::uint32_t z) const { return 64 * begin(z); }
  std::size_t bits_in_layer() const { return 64 * per_layer_; }
  bool operator[](std::size_t bit) const { return (words_[bit / 64] >> (bit % 64) & 1U) != 0; }
  void insert(std::size_t bit) { words_[bit / 64] |= Word{1} << (bit % 64); }

 private:
  std::size_t begin(std::uint32_t z) const { return (std::size_t{z} + 1) * per_layer_ + pad_; }

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
        back_{Back(lattice_.stride[0]), Back(lattice_.stride[1])},
        known_{Plane(lattice_), Plane(lattice_), Plane(lattice_)},
        plain_{Plane(lattice_), Plane(lattice_), Plane(lattice_)},
        step_{lattice_.stride[0], lattice_.stride[1], known_[0].bits_in_layer()},
        chunk_(std::max<std::size_t>(least_chunk, back_[1].words + 2)),
        chunks_((known_[0].words_in_layer() + chunk_ - 1) / chunk_),
        is_dirty_(chunks_ * lattice_.dims[2], 1),
        is_layer_dirty_(lattice_.dims[2], 1),
        other_edges_(lattice_.dims[2]) {
    tbb::parallel_for(std::uint32_t{0}, lattice_.dims[2],
                      [&](std::uint32_t z) { read_layer(z, forest); });
  }

  /// Where conclusions come in their thousands at a time they are drawn 64 at a time, else one by
  /// one: in large boxes thin chains of them wind through all layers, millions long.
  void close() {
    for (std::vector<Edge> front = next_conclusions(); !front.empty(); front = next_conclusions()) {
      if (front.size() > thin) {
        sweep();
      } else {
        std::fill(is_layer_dirty_.begin(), is_layer_dirty_.end(), 0);
        std::fill(is_dirty_.begin(), is_dirty_.end(), 0);
        follow(std::move(front));
      }
    }
  }

  /// The interior edges with other rings.
  std::vector<std::uint32_t> other_edges() const {
    std::vector<std::uint32_t> all;
    for (const auto& edges : other_edges_) all.insert(all.end(), edges.begin(), edges.end());
    return all;
  }

  void write(BitSet& known) {
    tbb::parallel_for(std::uint32_t{0}, lattice_.dims[2], [&](std::uint32_t z) {
      const std::uint32_t begin = lattice_.vertex(0, 0, z);
      const std::array<const Word*, 3> bits{known_[0].layer(z), known_[1].layer(z),
                                            known_[2].layer(z)};
      for (std::uint32_t i = 0; i < lattice_.stride[2]; ++i) {
        // The layers beside this one may have numbers in the words of its first and last 64.
        const bool is_shared = i < 64 || i + 64 > lattice_.stride[2];
        for (std::uint32_t a = 0; a < 3; ++a) {
          if ((bits[a][i / 64] >> (i % 64) & 1U) == 0) continue;
          const std::uint32_t piece = 3 * (begin + i) + a;
          is_shared ? known.insert_shared(piece) : known.insert(piece);
        }
      }
    });
  }

 private:
  static constexpr std::size_t least_chunk = 8;       // words
  static constexpr std::uint32_t layers_in_slab = 2;  // layers
  static constexpr std::size_t thin = 2000;           // conclusions

  struct Edge {
    std::size_t bit;  // of its lesser end
    std::uint32_t axis;
  };

  void read_layer(std::uint32_t z, const BitSet& forest) {
    std::array<Word*, 3> known{};
    std::array<Word*, 3> plain{};
    for (std::size_t a = 0; a < 3; ++a) {
      known[a] = known_[a].layer(z);
      plain[a] = plain_[a].layer(z);
      std::fill(plain[a], plain[a] + plain_[a].words_in_layer(), 0);
    }
    for_each_row_part(lattice_, z, [&](const RowPart& part) {
      const std::uint32_t bit = part.vertex - lattice_.vertex(0, 0, z);
      GridComplex::Bits unknown{};
      for_each_number(part.vertex, complex_.faces_in(part).any, [&](std::uint32_t piece) {
        if (!forest[piece]) unknown[piece % 3] |= std::uint64_t{1} << (piece / 3 - part.vertex);
      });
      const GridComplex::Bits edges = complex_.edges_in(part);
      const GridComplex::Bits rings = complex_.plain_rings_in(part);
      GridComplex::Bits others{};
      for (std::size_t a = 0; a < 3; ++a) {
        flip(known[a], bit, unknown[a]);
        flip(plain[a], bit, edges[a] & rings[a]);
        others[a] = edges[a] & ~rings[a];
      }
      for_each_number(part.vertex, others,
                      [&](std::uint32_t edge) { other_edges_[z].push_back(edge); });
    });
  }

  /// Of 64 bits from `bit` on.
  static void flip(Word* words, std::uint32_t bit, Word flipped) {
    words += bit / 64;
    *words ^= flipped << (bit % 64);
    if (bit % 64 != 0 && flipped >> (64 - bit % 64) != 0)
      *(words + 1) ^= flipped >> (64 - bit % 64);
  }

  /// The edges from whose rings a piece follows, or more than `thin` of them.
  std::vector<Edge> next_conclusions() {
    std::vector<Edge> edges;
    for (std::uint32_t z = 0; z < lattice_.dims[2]; ++z) {
      if (is_layer_dirty_[z] == 0) continue;
      for (std::size_t chunk = 0; chunk < chunks_; ++chunk) {
        if (is_dirty_[z * chunks_ + chunk] == 0) continue;
        for (std::size_t w = chunk * chunk_; w < chunk_end(chunk); ++w) {
          const std::array<Word, 3> found{found_in_word<0>(z, w), found_in_word<1>(z, w),
                                          found_in_word<2>(z, w)};
          for (std::uint32_t a = 0; a < 3; ++a)
            for (Word left = found[a]; left != 0; left &= left - 1)
              edges.push_back({plain_[a].first_bit(z) + 64 * w + std::countr_zero(left), a});
        }
        if (edges.size() > thin) return edges;
      }
    }
    return edges;
  }

  /// Draws the conclusions one by one, and those that follow, until there are many at a time:
  /// chunks with these are dirty then.
  void follow(std::vector<Edge> front) {
    std::vector<Edge> next;
    for (; !front.empty() && front.size() <= thin; std::swap(front, next)) {
      next.clear();
      for (const Edge& edge : front) {
        const auto unknown = sole_unknown(edge);
        if (!unknown) continue;
        const auto& [bit, normal] = *unknown;
        known_[normal].insert(bit);
        const std::uint32_t b = (normal + 1) % 3;
        const std::uint32_t c = (normal + 2) % 3;
        for (const Edge& beside :
             {Edge{bit, b}, Edge{bit, c}, Edge{bit + step_[b], c}, Edge{bit + step_[c], b}})
          if (sole_unknown(beside)) next.push_back(beside);
      }
    }
    for (const Edge& edge : front) {
      const std::size_t z = edge.bit / step_[2] - 1;
      is_layer_dirty_[z] = 1;
      is_dirty_[z * chunks_ + (edge.bit - plain_[0].first_bit(z)) / 64 / chunk_] = 1;
    }
  }

  /// The one unknown piece round an edge with a plain ring: `bit` of its lowest corner and, as
  /// `axis`, its normal.
  std::optional<Edge> sole_unknown(const Edge& edge) const {
    const auto& [bit, axis] = edge;
    if (!plain_[axis][bit]) return std::nullopt;
    const std::uint32_t b = (axis + 1) % 3;
    const std::uint32_t c = (axis + 2) % 3;
    std::optional<Edge> found;
    for (const Edge& piece :
         {Edge{bit, b}, Edge{bit, c}, Edge{bit - step_[b], c}, Edge{bit - step_[c], b}}) {
      if (known_[piece.axis][piece.bit]) continue;
      if (found) return std::nullopt;
      found = piece;
    }
    return found;
  }

  /// Closes the dirty slabs once. Neighbours share a layer of pieces: every other slab at a time.
  void sweep() {
    const std::uint32_t slabs = (lattice_.dims[2] + layers_in_slab - 1) / layers_in_slab;
    for (std::uint32_t parity = 0; parity < 2; ++parity)
      tbb::parallel_for(std::uint32_t{0}, (slabs + 1 - parity) / 2,
                        [&](std::uint32_t i) { close_slab(2 * i + parity); });
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

  std::size_t chunk_end(std::size_t chunk) const {
    return std::min((chunk + 1) * chunk_, known_[0].words_in_layer());
  }

  /// Says whether anything followed.
  bool close_chunk(std::uint32_t z, std::size_t chunk) {
    bool any = false;
    for (std::size_t w = chunk * chunk_; w < chunk_end(chunk); ++w)
      for (bool found = true; found; any = any || found) {
        found = close_word<0>(z, w);
        found = close_word<1>(z, w) || found;
        found = close_word<2>(z, w) || found;
      }
    return any;
  }

  template <std::uint32_t Axis>
  bool close_word(std::uint32_t z, std::size_t w) {
    const Word found = found_in_word<Axis>(z, w);
    if (found == 0) return false;
    constexpr std::uint32_t b = (Axis + 1) % 3;
    constexpr std::uint32_t c = (Axis + 2) % 3;
    known_[b].layer(z)[w] |= found;
    known_[c].layer(z)[w] |= found;
    insert_before<c, b>(z, w, found);
    insert_before<b, c>(z, w, found);
    return true;
  }

  /// The edges along `Axis` at the vertices of a word from whose plain rings a piece follows. With
  /// b and c across: normal c at the vertex and before it along b, normal b there and along c.
  template <std::uint32_t Axis>
  Word found_in_word(std::uint32_t z, std::size_t w) const {
    constexpr std::uint32_t b = (Axis + 1) % 3;
    constexpr std::uint32_t c = (Axis + 2) % 3;
    return all_but_one(known_[b].layer(z)[w], known_[c].layer(z)[w], read_before<c, b>(z, w),
                       read_before<b, c>(z, w)) &
           plain_[Axis].layer(z)[w];
  }

  template <std::uint32_t Normal, std::uint32_t Along>
  Word read_before(std::uint32_t z, std::size_t w) const {
    if constexpr (Along == 2)
      return known_[Normal].layer_before(z)[w];
    else
      return back_[Along].read(known_[Normal].layer(z) + w);
  }

  template <std::uint32_t Normal, std::uint32_t Along>
  void insert_before(std::uint32_t z, std::size_t w, Word found) {
    if constexpr (Along == 2)
      known_[Normal].layer_before(z)[w] |= found;
    else
      back_[Along].insert(known_[Normal].layer(z) + w, found);
  }

  const GridComplex& complex_;
  const Lattice& lattice_;
  std::array<Back, 2> back_;                  // by axis
  std::array<Plane, 3> known_;                // by normal: of the face with lowest corner v
  std::array<Plane, 3> plain_;                // by direction: of the edge from v
  std::array<std::size_t, 3> step_;           // bits, by axis
  std::size_t chunk_;                         // words
  std::size_t chunks_;                        // in a layer
  std::vector<std::uint8_t> is_dirty_;        // by layer and chunk: whether anything may follow
  std::vector<std::uint8_t> is_layer_dirty_;  // whether a chunk of it may be dirty
  std::vector<std::vector<std::uint32_t>> other_edges_;  // by layer
};

/// `known`, pieces with label 0, and all pieces whose label is 0 if theirs are: where every piece
/// but one round an interior edge is known, so is the last. `todo`: the edges from which anything
/// may follow.
BitSet closed_by_rings(const GridComplex& complex, BitSet known, std::vector<std::uint32_t> todo) {
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
  return closed_by_rings(complex, std::move(known), std::move(todo));
}

}  // namespace isoloop
