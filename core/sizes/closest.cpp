#include "core/sizes/closest.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/base/threads.h"

namespace isoloop {
namespace {

constexpr float unreached = std::numeric_limits<float>::infinity();
constexpr double nowhere = std::numeric_limits<double>::infinity();
constexpr std::uint32_t lines_at_once = 16;  // one cache line of each array

struct CutLattice {
  const Lattice& lattice;
  const EdgeIndex& edges;
  const Surface& surface;

  std::uint32_t site_on(std::uint32_t vertex, std::uint32_t axis) const {
    return edges.vertex_on(3 * vertex + axis);
  }

  /// Of a vertex of M, in steps of the lattice.
  double place(std::uint32_t site, int axis) const {
    return surface.points[site][axis] - static_cast<double>(lattice.first[axis]);
  }
};

/// The best vertex of M so far for each of some lattice vertices.
struct Field {
  UnsetVector<float> squared;  // distance, unit of the spacing
  UnsetVector<std::uint32_t> site;

  explicit Field(std::uint32_t count) : squared(count), site(count) {}

  void clear() {
    std::fill(squared.begin(), squared.end(), unreached);
    std::fill(site.begin(), site.end(), 0U);
  }

  /// Offers the vertex `to`, which lies at `place`, to the lattice vertex that lies at `at` along
  /// an axis of spacing `h`.
  void offer(std::uint32_t i, std::uint32_t to, double place, std::uint32_t at, double h) {
    const double d = h * (place - at);
    const auto offered = static_cast<float>(d * d);
    const bool is_nearer = offered < squared[i];
    squared[i] = is_nearer ? offered : squared[i];
    site[i] = is_nearer ? to : site[i];
  }
};

/// A vertex of M for each of some parallel lines.
struct Front {
  std::vector<std::uint32_t> site;
  std::vector<double> place;  // along the lines

  explicit Front(std::uint32_t count) : site(count), place(count) {}

  void clear() { std::fill(place.begin(), place.end(), nowhere); }

  void offer_to(Field& layer, std::uint32_t first, std::uint32_t at, double h) const {
    for (std::uint32_t i = 0; i < site.size(); ++i)
      layer.offer(first + i, site[i], place[i], at, h);
  }
};

/// Calls visit(vertex) for the lattice vertices from `first` to `last`, itself not included, whose
/// edge along `axis` is cut, ascending.
template <class Visit>
void for_each_cut(const CutLattice& cut, std::uint32_t axis, std::uint32_t first,
                  std::uint32_t last, const Visit& visit) {
  for (std::uint32_t from = first; from < last; from += 64) {
    std::uint64_t bits = cut.edges.cut_bits(axis, from);
    if (last - from < 64) bits &= (std::uint64_t{1} << (last - from)) - 1;
    for (; bits != 0; bits &= bits - 1)
      visit(from + static_cast<std::uint32_t>(std::countr_zero(bits)));
  }
}

/// Sets a layer anew: distances along x to the vertices of M on x-edges.
void seed_along_x(const CutLattice& cut, std::uint32_t z, Field& layer) {
  layer.clear();
  const std::uint32_t nx = cut.lattice.dims[0];
  const double h = cut.surface.spacing[0];
  for (std::uint32_t y = 0; y < cut.lattice.dims[1]; ++y) {
    const std::uint32_t first = cut.lattice.vertex(0, y, z);
    const std::uint32_t row = y * nx;
    std::uint32_t last_site = 0;
    double last_place = nowhere;
    std::uint32_t x = 0;  // the first one that knows of no vertex after it
    for_each_cut(cut, 0, first, first + nx, [&](std::uint32_t v) {
      const std::uint32_t site = cut.site_on(v, 0);
      const double place = cut.place(site, 0);
      for (; x <= v - first; ++x) {
        layer.offer(row + x, last_site, last_place, x, h);
        layer.offer(row + x, site, place, x, h);
      }
      last_site = site;
      last_place = place;
    });
    for (; x < nx; ++x) layer.offer(row + x, last_site, last_place, x, h);
  }
}

/// The same along y; `front`: a row of scratch space.
void seed_along_y(const CutLattice& cut, std::uint32_t z, Front& front, Field& layer) {
  layer.clear();
  const std::uint32_t nx = cut.lattice.dims[0];
  const std::uint32_t ny = cut.lattice.dims[1];
  const double h = cut.surface.spacing[1];
  const auto pass_edges = [&](std::uint32_t y) {
    const std::uint32_t first = cut.lattice.vertex(0, y, z);
    for_each_cut(cut, 1, first, first + nx, [&](std::uint32_t v) {
      front.site[v - first] = cut.site_on(v, 1);
      front.place[v - first] = cut.place(front.site[v - first], 1);
    });
  };
  front.clear();
  for (std::uint32_t y = 1; y < ny; ++y) {
    pass_edges(y - 1);
    front.offer_to(layer, y * nx, y, h);
  }
  front.clear();
  for (std::uint32_t y = ny - 1; y-- > 0;) {
    pass_edges(y);
    front.offer_to(layer, y * nx, y, h);
  }
}

/// The vertices of M on z-edges just below and above a layer that moves up.
class Columns {
 public:
  Columns(const CutLattice& cut, std::uint32_t z)
      : cut_(cut), z_(z), below_(cut.lattice.stride[2]), above_(cut.lattice.stride[2]) {
    below_.clear();
    above_.clear();
    for (std::uint32_t column = 0; column < cut.lattice.stride[2]; column += 64) {
      look(
          below_, column, all_from(column), [&](std::uint32_t step) { return z_ - 1 - step; }, z_);
      look_up(column, all_from(column));
    }
  }

  /// Sets the layer at hand anew.
  void seed(Field& layer) const {
    layer.clear();
    below_.offer_to(layer, 0, z_, cut_.surface.spacing[2]);
    above_.offer_to(layer, 0, z_, cut_.surface.spacing[2]);
  }

  void move_up() {
    const std::uint32_t first = cut_.lattice.vertex(0, 0, z_++);
    for (std::uint32_t column = 0; column < cut_.lattice.stride[2]; column += 64) {
      const std::uint64_t passed = cut_.edges.cut_bits(2, first + column) & all_from(column);
      if (passed == 0) continue;
      for (std::uint64_t left = passed; left != 0; left &= left - 1) {
        const std::uint32_t c = column + static_cast<std::uint32_t>(std::countr_zero(left));
        below_.site[c] = above_.site[c];
        below_.place[c] = above_.place[c];
        above_.place[c] = nowhere;
      }
      look_up(column, passed);
    }
  }

 private:
  /// The columns among 64 that there are.
  std::uint64_t all_from(std::uint32_t column) const {
    const std::uint32_t left = cut_.lattice.stride[2] - column;
    return left < 64 ? (std::uint64_t{1} << left) - 1 : ~std::uint64_t{0};
  }

  void look_up(std::uint32_t column, std::uint64_t wanted) {
    look(
        above_, column, wanted, [&](std::uint32_t step) { return z_ + step; },
        cut_.lattice.dims[2] - z_);
  }

  /// Finds the first cut edge in each of the `wanted` columns, in `steps` layers.
  template <class LayerAt>
  void look(Front& front, std::uint32_t column, std::uint64_t wanted, const LayerAt& layer_at,
            std::uint32_t steps) {
    for (std::uint32_t step = 0; step < steps && wanted != 0; ++step) {
      const std::uint32_t first = cut_.lattice.vertex(0, 0, layer_at(step)) + column;
      const std::uint64_t found = cut_.edges.cut_bits(2, first) & wanted;
      for (std::uint64_t left = found; left != 0; left &= left - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(left));
        front.site[column + i] = cut_.site_on(first + i, 2);
        front.place[column + i] = cut_.place(front.site[column + i], 2);
      }
      wanted &= ~found;
    }
  }

  const CutLattice& cut_;
  std::uint32_t z_;
  Front below_;
  Front above_;
};

/// Scratch space for one line of lattice vertices.
struct Line {
  std::vector<float> squared;
  std::vector<std::uint32_t> site;
  std::vector<std::uint32_t> apex;  // of the parabolas on the envelope
  std::vector<double> start;        // from where each is the lowest

  explicit Line(std::uint32_t length)
      : squared(length), site(length), apex(length), start(length) {}

  std::uint32_t length() const { return static_cast<std::uint32_t>(squared.size()); }
};

/// Lower envelope of the parabolas squared[q] + (h (x - q))^2: fills line.apex and line.start and
/// returns how many there are.
std::size_t find_envelope(Line& line, double h) {
  std::size_t count = 0;
  const double h2 = h * h;
  for (std::uint32_t q = 0; q < line.length(); ++q) {
    if (line.squared[q] == unreached) continue;
    double from = -std::numeric_limits<double>::infinity();
    while (count > 0) {
      const double p = line.apex[count - 1];
      from =
          (line.squared[q] - line.squared[line.apex[count - 1]]) / (2 * h2 * (q - p)) + (q + p) / 2;
      if (from > line.start[count - 1]) break;
      --count;
      from = -std::numeric_limits<double>::infinity();
    }
    line.apex[count] = q;
    line.start[count] = from;
    ++count;
  }
  return count;
}

/// Lets the vertices of `count` lines reach along these. The vertices of a line are `step` apart,
/// the lines `across`.
void spread(Field& field, std::size_t first, std::uint32_t step, std::uint32_t count,
            std::uint32_t across, double h, std::vector<Line>& lines) {
  const std::uint32_t n = lines.front().length();
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t l = 0; l < count; ++l) {
      lines[l].squared[i] = field.squared[first + i * step + l * across];
      lines[l].site[i] = field.site[first + i * step + l * across];
    }
  for (std::uint32_t l = 0; l < count; ++l) {
    Line& line = lines[l];
    const std::size_t parabolas = find_envelope(line, h);
    if (parabolas == 0) continue;
    std::size_t k = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      while (k + 1 < parabolas && line.start[k + 1] < i) ++k;
      const std::uint32_t q = line.apex[k];
      const double d = h * (static_cast<double>(i) - q);
      field.squared[first + i * step + l * across] = static_cast<float>(line.squared[q] + d * d);
      field.site[first + i * step + l * across] = line.site[q];
    }
  }
}

/// What a thread needs for one layer at a time.
struct LayerSpace {
  Field near;
  Field other;
  Front row;
  std::vector<Line> along_x;
  std::vector<Line> along_y;

  explicit LayerSpace(const Lattice& lattice)
      : near(lattice.stride[2]),
        other(lattice.stride[2]),
        row(lattice.dims[0]),
        along_x(1, Line(lattice.dims[0])),
        along_y(lines_at_once, Line(lattice.dims[1])) {}
};

void spread_along_x(const CutLattice& cut, Field& layer, std::vector<Line>& lines) {
  for (std::uint32_t y = 0; y < cut.lattice.dims[1]; ++y)
    spread(layer, std::size_t{y} * cut.lattice.dims[0], 1, 1, 0, cut.surface.spacing[0], lines);
}

void spread_along_y(const CutLattice& cut, Field& layer, std::vector<Line>& lines) {
  const std::uint32_t nx = cut.lattice.dims[0];
  for (std::uint32_t x = 0; x < nx; x += lines_at_once)
    spread(layer, x, nx, std::min(lines_at_once, nx - x), 1, cut.surface.spacing[1], lines);
}

void spread_along_z(const CutLattice& cut, Field& field) {
  const std::uint32_t nx = cut.lattice.dims[0];
  const std::uint32_t nz = cut.lattice.dims[2];
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, cut.lattice.dims[1]),
                    [&](const auto& range) {
                      std::vector<Line> lines(lines_at_once, Line(nz));
                      for (std::uint32_t y = range.begin(); y < range.end(); ++y)
                        for (std::uint32_t x = 0; x < nx; x += lines_at_once)
                          spread(field, std::size_t{y} * nx + x, cut.lattice.stride[2],
                                 std::min(lines_at_once, nx - x), 1, cut.surface.spacing[2], lines);
                    });
}

/// Calls body(first, last, space) for the layers from first to last, itself not included; a few
/// times for each thread.
template <class Body>
void for_each_slab(const Lattice& lattice, const Body& body) {
  const auto grain = static_cast<std::uint32_t>(lattice.dims[2] / (4 * thread_count()) + 1);
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, lattice.dims[2], grain),
                    [&](const auto& range) {
                      LayerSpace space(lattice);
                      body(range.begin(), range.end(), space);
                    });
}

}  // namespace

UnsetVector<std::uint32_t> closest_surface_vertices(const VoxelSides& sides, const EdgeIndex& edges,
                                                    const Surface& surface) {
  const Lattice& lattice = sides.lattice;
  const CutLattice cut{lattice, edges, surface};
  Field nearest(lattice.vertex_count());
  for_each_slab(lattice, [&](std::uint32_t first, std::uint32_t last, LayerSpace& space) {
    for (std::uint32_t z = first; z < last; ++z) {
      seed_along_x(cut, z, space.near);
      spread_along_y(cut, space.near, space.along_y);
      seed_along_y(cut, z, space.row, space.other);
      spread_along_x(cut, space.other, space.along_x);
      const std::size_t begin = lattice.vertex(0, 0, z);
      for (std::uint32_t i = 0; i < lattice.stride[2]; ++i) {
        const bool is_nearer = space.other.squared[i] < space.near.squared[i];
        nearest.squared[begin + i] = (is_nearer ? space.other : space.near).squared[i];
        nearest.site[begin + i] = (is_nearer ? space.other : space.near).site[i];
      }
    }
  });
  spread_along_z(cut, nearest);
  for_each_slab(lattice, [&](std::uint32_t first, std::uint32_t last, LayerSpace& space) {
    Columns columns(cut, first);
    for (std::uint32_t z = first; z < last; ++z, columns.move_up()) {
      columns.seed(space.other);
      spread_along_x(cut, space.other, space.along_x);
      spread_along_y(cut, space.other, space.along_y);
      const std::size_t begin = lattice.vertex(0, 0, z);
      for (std::uint32_t i = 0; i < lattice.stride[2]; ++i)
        if (space.other.squared[i] < nearest.squared[begin + i])
          nearest.site[begin + i] = space.other.site[i];
    }
  });
  return std::move(nearest.site);
}

}  // namespace isoloop
