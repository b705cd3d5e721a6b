#include "core/sizes/closest.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace isoloop {
namespace {

constexpr float unreached = std::numeric_limits<float>::infinity();
constexpr std::uint32_t lines_at_once = 16;  // one cache line of each array

/// The best vertex of M so far for every lattice vertex.
struct Field {
  UnsetVector<float> squared;  // distance, unit of the spacing
  UnsetVector<std::uint32_t> site;

  explicit Field(std::uint32_t count) : squared(count), site(count) {}
};

/// Scratch space for one line of lattice vertices.
struct Line {
  std::vector<float> squared;
  std::vector<std::uint32_t> site;
  std::vector<std::uint32_t> apex;  // of the parabolas on the envelope
  std::vector<double> start;        // from where each is the lowest
};

/// Calls body(first vertex, line count, lines) for batches of lines along `axis` that lie side by
/// side in memory, in parallel.
template <class Body>
void for_each_batch(const Lattice& lattice, int axis, const Body& body) {
  const int across = axis == 0 ? 1 : 0;  // the axis along which a batch extends
  const int outer = axis == 2 ? 1 : 2;
  tbb::parallel_for(
      tbb::blocked_range<std::uint32_t>(0, lattice.dims[outer]), [&](const auto& range) {
        std::vector<Line> lines(lines_at_once);
        for (Line& line : lines) {
          line.squared.resize(lattice.dims[axis]);
          line.site.resize(lattice.dims[axis]);
        }
        for (std::uint32_t o = range.begin(); o < range.end(); ++o)
          for (std::uint32_t i = 0; i < lattice.dims[across]; i += lines_at_once)
            body(o * lattice.stride[outer] + i * lattice.stride[across],
                 std::min(lines_at_once, lattice.dims[across] - i), lattice.stride[across], lines);
      });
}

/// Sets `field` anew: distances along `axis` to the vertices of M on edges of that direction, line
/// by line.
void seed(const Lattice& lattice, const EdgeIndex& edges, const Surface& surface, int axis,
          Field& field) {
  const std::uint32_t n = lattice.dims[axis];
  const std::uint32_t step = lattice.stride[axis];
  const double h = surface.spacing[axis];
  const auto offset = static_cast<double>(lattice.first[axis]);
  for_each_batch(lattice, axis,
                 [&](std::uint32_t first, std::uint32_t count, std::uint32_t across,
                     const std::vector<Line>&) {
                   for (std::uint32_t i = 0; i < n; ++i)
                     for (std::uint32_t l = 0; l < count; ++l) {
                       field.squared[first + i * step + l * across] = unreached;
                       field.site[first + i * step + l * across] = 0;
                     }
                   for (std::uint32_t l = 0; l < count; ++l) {
                     const std::uint32_t base = first + l * across;
                     const auto offer = [&](std::uint32_t i, std::uint32_t site) {
                       const double d = h * (surface.points[site][axis] - offset - i);
                       const auto squared = static_cast<float>(d * d);
                       if (squared >= field.squared[base + i * step]) return;
                       field.squared[base + i * step] = squared;
                       field.site[base + i * step] = site;
                     };
                     const auto edge_at = [&](std::uint32_t i) {
                       return 3 * (base + i * step) + static_cast<std::uint32_t>(axis);
                     };
                     constexpr auto none = static_cast<std::uint32_t>(-1);
                     std::uint32_t last = none;
                     for (std::uint32_t i = 1; i < n; ++i) {
                       if (edges.is_cut(edge_at(i - 1))) last = edges.vertex_on(edge_at(i - 1));
                       if (last != none) offer(i, last);
                     }
                     last = none;
                     for (std::uint32_t i = n - 1; i-- > 0;) {
                       if (edges.is_cut(edge_at(i))) last = edges.vertex_on(edge_at(i));
                       if (last != none) offer(i, last);
                     }
                   }
                 });
}

/// Lower envelope of the parabolas squared[q] + (h (x - q))^2; fills line.apex and line.start.
void find_envelope(Line& line, double h) {
  line.apex.clear();
  line.start.clear();
  const double h2 = h * h;
  for (std::uint32_t q = 0; q < line.squared.size(); ++q) {
    if (line.squared[q] == unreached) continue;
    double from = -std::numeric_limits<double>::infinity();
    while (!line.apex.empty()) {
      const double p = line.apex.back();
      from = (line.squared[q] - line.squared[line.apex.back()]) / (2 * h2 * (q - p)) + (q + p) / 2;
      if (from > line.start.back()) break;
      line.apex.pop_back();
      line.start.pop_back();
      from = -std::numeric_limits<double>::infinity();
    }
    line.apex.push_back(q);
    line.start.push_back(from);
  }
}

/// Lets every vertex reach along `axis`.
void spread(const Lattice& lattice, const Vec3& spacing, int axis, Field& field) {
  const std::uint32_t n = lattice.dims[axis];
  const std::uint32_t step = lattice.stride[axis];
  const double h = spacing[axis];
  for_each_batch(lattice, axis,
                 [&](std::uint32_t first, std::uint32_t count, std::uint32_t across,
                     std::vector<Line>& lines) {
                   for (std::uint32_t i = 0; i < n; ++i)
                     for (std::uint32_t l = 0; l < count; ++l) {
                       lines[l].squared[i] = field.squared[first + i * step + l * across];
                       lines[l].site[i] = field.site[first + i * step + l * across];
                     }
                   for (std::uint32_t l = 0; l < count; ++l) {
                     Line& line = lines[l];
                     find_envelope(line, h);
                     if (line.apex.empty()) continue;
                     std::size_t k = 0;
                     for (std::uint32_t i = 0; i < n; ++i) {
                       while (k + 1 < line.start.size() && line.start[k + 1] < i) ++k;
                       const std::uint32_t q = line.apex[k];
                       const double d = h * (static_cast<double>(i) - q);
                       field.squared[first + i * step + l * across] =
                           static_cast<float>(line.squared[q] + d * d);
                       field.site[first + i * step + l * across] = line.site[q];
                     }
                   }
                 });
}

void take_nearer(Field& field, const Field& other_field) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, field.site.size(), 1 << 16),
                    [&](const auto& range) {
                      for (std::size_t v = range.begin(); v < range.end(); ++v) {
                        if (other_field.squared[v] >= field.squared[v]) continue;
                        field.squared[v] = other_field.squared[v];
                        field.site[v] = other_field.site[v];
                      }
                    });
}

}  // namespace

UnsetVector<std::uint32_t> closest_surface_vertices(const VoxelSides& sides, const EdgeIndex& edges,
                                                    const Surface& surface) {
  const Lattice& lattice = sides.lattice;
  Field nearest(lattice.vertex_count());
  seed(lattice, edges, surface, 0, nearest);
  spread(lattice, surface.spacing, 1, nearest);
  Field other(lattice.vertex_count());
  seed(lattice, edges, surface, 1, other);
  spread(lattice, surface.spacing, 0, other);
  take_nearer(nearest, other);
  spread(lattice, surface.spacing, 2, nearest);
  seed(lattice, edges, surface, 2, other);
  spread(lattice, surface.spacing, 0, other);
  spread(lattice, surface.spacing, 1, other);
  take_nearer(nearest, other);
  return std::move(nearest.site);
}

}  // namespace isoloop
