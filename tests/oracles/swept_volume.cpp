#include "tests/oracles/swept_volume.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>

#include "tests/oracles/swept_cube.h"

namespace isoloop::oracle {
namespace {

/// The levels with a layer of outside all round.
class Padded {
 public:
  Padded(const std::vector<double>& levels, const std::array<std::int64_t, 3>& dims)
      : dims_{dims[0] + 2, dims[1] + 2, dims[2] + 2},
        levels_(static_cast<std::size_t>(dims_[0] * dims_[1] * dims_[2]), -1.0) {
    for (std::int64_t k = 0; k < dims[2]; ++k)
      for (std::int64_t j = 0; j < dims[1]; ++j)
        for (std::int64_t i = 0; i < dims[0]; ++i)
          levels_[at(i + 1, j + 1, k + 1)] =
              levels[static_cast<std::size_t>(i + dims[0] * (j + dims[1] * k))];
  }

  std::size_t at(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return static_cast<std::size_t>(i + dims_[0] * (j + dims_[1] * k));
  }
  std::size_t count() const { return levels_.size(); }
  double operator[](std::size_t n) const { return levels_[n]; }
  bool is_inside(std::size_t n) const { return levels_[n] >= 0; }

  /// Calls visit(numbers of the corners) for each block of 1 or 2 voxels along each axis; bit a of
  /// `span`: two along axis a. Corner c of a block lies at offset c & span.
  template <class Visit>
  void for_each_block(unsigned span, const Visit& visit) const {
    for (std::int64_t k = 0; k + (span >> 2) < dims_[2]; ++k)
      for (std::int64_t j = 0; j + (span >> 1 & 1) < dims_[1]; ++j)
        for (std::int64_t i = 0; i + (span & 1) < dims_[0]; ++i) {
          std::array<std::size_t, 8> corners{};
          for (unsigned c = 0; c < 8; ++c)
            corners[c] = at(i + (c & span & 1), j + ((c & span) >> 1 & 1), k + ((c & span) >> 2));
          visit(corners);
        }
  }

 private:
  std::array<std::int64_t, 3> dims_;
  std::vector<double> levels_;
};

class Joined {
 public:
  explicit Joined(std::size_t count) : root_(count) { std::iota(root_.begin(), root_.end(), 0); }

  std::size_t find(std::size_t n) {
    while (root_[n] != n) n = root_[n] = root_[root_[n]];
    return n;
  }
  void join(std::size_t a, std::size_t b) { root_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> root_;
};

/// Corners of a face across `axis`, at its upper end or not, in ring order.
std::array<std::size_t, 4> ring(unsigned axis, bool upper) {
  const unsigned b = 1U << (axis + 1) % 3;
  const unsigned c = 1U << (axis + 2) % 3;
  const unsigned base = upper ? 1U << axis : 0U;
  return {base, base | b, base | b | c, base | c};
}

using CornerLevels = std::array<double, 8>;

/// Parts of the inside and of the outside on a face: 2 of one side where its corners alternate.
struct FaceParts {
  int inside = 0;
  bool alternates = false;
  bool inside_is_joined = false;
};

FaceParts face_parts(const CornerLevels& levels, const std::array<std::size_t, 4>& face,
                     double lowered_by) {
  std::array<double, 4> at{};
  for (std::size_t i = 0; i < 4; ++i) {
    at[i] = levels[face[i]];
    if (at[i] != 0) at[i] -= lowered_by;
  }
  const auto inside = std::count_if(at.begin(), at.end(), [](double level) { return level >= 0; });
  FaceParts parts;
  parts.alternates = inside == 2 && (at[0] >= 0) == (at[2] >= 0);
  const std::size_t in = at[0] >= 0 ? 0 : 1;
  parts.inside_is_joined = parts.alternates && at[in] * at[in + 2] > at[1 - in] * at[3 - in];
  parts.inside = inside == 0 ? 0 : parts.alternates && !parts.inside_is_joined ? 2 : 1;
  return parts;
}

/// For each corner a corner of its part, as the cube's edges and faces join them.
std::array<int, 8> parts_of_faces(const CornerLevels& levels, double lowered_by) {
  std::array<int, 8> part{0, 1, 2, 3, 4, 5, 6, 7};
  const auto merge = [&](std::size_t a, std::size_t b) {
    const int from = part[a];
    const int to = part[b];
    std::replace(part.begin(), part.end(), from, to);
  };
  for (unsigned axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const auto face = ring(axis, upper);
      for (std::size_t i = 0; i < 4; ++i)
        if ((levels[face[i]] >= 0) == (levels[face[(i + 1) % 4]] >= 0))
          merge(face[i], face[(i + 1) % 4]);
      const FaceParts parts = face_parts(levels, face, lowered_by);
      if (!parts.alternates) continue;
      const std::size_t in = levels[face[0]] >= 0 ? 0 : 1;
      const std::size_t first = parts.inside_is_joined ? in : 1 - in;
      merge(face[first], face[first + 2]);
    }
  return part;
}

}  // namespace

Betti count_by_sweep(const std::vector<double>& levels, const std::array<std::int64_t, 3>& dims,
                     bool cubes_are_simple, double lowered_by) {
  const Padded volume(levels, dims);
  Joined joined(volume.count());
  // The solid is covered by closed cubes, which meet in faces, edges and vertices.
  std::int64_t euler = 0;
  volume.for_each_block(7, [&](const std::array<std::size_t, 8>& corners) {
    CornerLevels at{};
    for (std::size_t c = 0; c < 8; ++c) at[c] = volume[corners[c]];
    std::array<int, 8> part{};
    if (cubes_are_simple) {
      part = parts_of_faces(at, lowered_by);
      std::set<int> inside;
      for (std::size_t c = 0; c < 8; ++c)
        if (at[c] >= 0) inside.insert(part[c]);
      euler += static_cast<std::int64_t>(inside.size());
    } else {
      const SweptCube swept = sweep(at, lowered_by);
      part = swept.part_of_corner;
      euler += swept.parts[1] - swept.cycles[1];
    }
    for (std::size_t c = 0; c < 8; ++c)
      for (std::size_t d = 0; d < c; ++d)
        if (part[c] == part[d] && (at[c] >= 0) == (at[d] >= 0)) joined.join(corners[c], corners[d]);
  });
  for (unsigned axis = 0; axis < 3; ++axis) {
    volume.for_each_block(7 & ~(1U << axis), [&](const std::array<std::size_t, 8>& corners) {
      CornerLevels at{};
      for (std::size_t c = 0; c < 8; ++c) at[c] = volume[corners[c]];
      euler -= face_parts(at, ring(axis, false), lowered_by).inside;
    });
    volume.for_each_block(1U << axis, [&](const std::array<std::size_t, 8>& corners) {
      if (volume.is_inside(corners[0]) || volume.is_inside(corners[1U << axis])) ++euler;
    });
  }
  volume.for_each_block(0, [&](const std::array<std::size_t, 8>& corners) {
    if (volume.is_inside(corners[0])) --euler;
  });
  Betti betti;
  for (std::size_t n = 0; n < volume.count(); ++n)
    if (joined.find(n) == n) ++(volume.is_inside(n) ? betti.b0 : betti.b2);
  --betti.b2;  // the outside of all
  betti.b1 = betti.b0 + betti.b2 - euler;
  return betti;
}

}  // namespace isoloop::oracle
