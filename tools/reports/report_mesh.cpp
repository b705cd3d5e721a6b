#include "tools/reports/report_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/errors.h"
#include "tools/drawings/colours.h"
#include "tools/drawings/tube.h"
#include "tools/reports/report_features.h"
#include "tools/reports/report_table.h"
#include "tools/words/number_text.h"

namespace isoloop {
namespace {

constexpr Colour surface_grey{200, 200, 200};

struct MeshSize {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
};

MeshSize size_of(const LoopsRun& run, std::span<const Loop> loops) {
  MeshSize size{run.analysis.surface.points.size(), run.analysis.surface.triangles.size()};
  for (const Loop& loop : loops) {
    for (const auto& curve : drawn_curves(run.analysis.surface, loop)) {
      if (curve.size() < 2) continue;
      size.vertices += curve.size() * tube_sides;
      size.triangles += 2 * curve.size() * tube_sides;
    }
  }
  return size;
}

// Along edges of the surface: what lies next to the loop where it is drawn across triangles.
std::vector<Curve> curves_on_edges(const Loop& loop) {
  if (loop.geodesics.empty()) return loop.curves;
  std::vector<Curve> curves;
  for (const Geodesic& geodesic : loop.geodesics) curves.push_back(pushed_to_edges(geodesic));
  return curves;
}

void write_header(std::ostream& out, const LoopsRun& run, const MeshSize& size) {
  out << "ply\nformat binary_little_endian 1.0\n"
      << "comment isoloop: iso-surface (grey), handle loops (green), tunnel loops (red), "
      << "other loops (blue)\n"
      << "comment inside is " << inside_text(run) << "\n"
      << "comment frame " << frame_name(run.volume.frame) << ", lengths in the unit of the spacing "
      << shortest_text(run.volume.spacing[0]) << ' ' << shortest_text(run.volume.spacing[1]) << ' '
      << shortest_text(run.volume.spacing[2]) << "\nelement vertex " << size.vertices
      << "\nproperty float x\nproperty float y\nproperty float z\n"
      << "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      << (run.with_features ? "property int label\n" : "") << "element face " << size.triangles
      << "\nproperty list uchar int vertex_indices\nend_header\n";
}

template <class Bits>
void append_bits(std::vector<char>& bytes, Bits bits) {
  for (std::size_t i = 0; i < sizeof(Bits); ++i) {
    bytes.push_back(static_cast<char>((bits >> (8 * i)) & 0xFF));
  }
}

void append_vertex(std::vector<char>& bytes, const Vec3& position, const Colour& colour) {
  for (const double x : position) {
    append_bits(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(x)));
  }
  for (const std::uint8_t channel : colour) bytes.push_back(static_cast<char>(channel));
}

void append_face(std::vector<char>& bytes, const std::array<std::uint32_t, 3>& corners) {
  bytes.push_back(3);
  for (const std::uint32_t corner : corners) append_bits(bytes, corner);
}

// Hands the bytes on once they are many, so that the whole file is never in memory.
void flush(std::ostream& out, std::vector<char>& bytes, std::size_t from = 0) {
  if (bytes.size() < from) return;
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.clear();
}
constexpr std::size_t chunk_bytes = std::size_t{1} << 20;

Vec3 world_point(const LoopsRun& run, std::uint32_t vertex) {
  const auto& point = run.analysis.surface.points[vertex];
  return to_world(run.volume, {point[0], point[1], point[2]});
}

std::vector<Tube> tubes_of(const LoopsRun& run, std::span<const Loop> loops, double radius) {
  std::vector<Tube> tubes;
  for (const Loop& loop : loops) {
    for (std::vector<Vec3>& curve : drawn_curves(run.analysis.surface, loop)) {
      for (Vec3& point : curve) point = to_world(run.volume, point);
      tubes.push_back(closed_tube(curve, radius));
    }
  }
  return tubes;
}

std::vector<Colour> surface_colours(const LoopsRun& run, std::span<const Loop> loops) {
  std::vector<Colour> colours(run.analysis.surface.points.size(), surface_grey);
  for (const LoopKind kind : {LoopKind::loop, LoopKind::tunnel, LoopKind::handle}) {
    for (const Loop& loop : loops) {
      if (loop.kind != kind) continue;
      for (const Curve& curve : curves_on_edges(loop)) {
        for (const std::uint32_t vertex : curve) colours[vertex] = colour_of(kind);
      }
    }
  }
  return colours;
}

void write_vertices(std::ostream& out, const LoopsRun& run, std::span<const Loop> loops,
                    const std::vector<Tube>& tubes) {
  std::vector<char> bytes;
  const std::vector<Colour> colours = surface_colours(run, loops);
  const bool labelled = run.with_features;
  const std::vector<std::uint32_t> labels =
      labelled ? vertex_labels(run) : std::vector<std::uint32_t>{};
  for (std::uint32_t vertex = 0; vertex < colours.size(); ++vertex) {
    append_vertex(bytes, world_point(run, vertex), colours[vertex]);
    if (labelled) append_bits(bytes, labels[vertex]);
    flush(out, bytes, chunk_bytes);
  }
  std::size_t tube = 0;
  for (const Loop& loop : loops) {
    for (std::size_t curve = 0; curve < loop.curves.size(); ++curve, ++tube) {
      for (const Vec3& point : tubes[tube].points) {
        append_vertex(bytes, point, colour_of(loop.kind));
        if (labelled) append_bits(bytes, static_cast<std::uint32_t>(place_of(run, loop) + 1));
      }
      flush(out, bytes, chunk_bytes);
    }
  }
  flush(out, bytes);
}

void write_faces(std::ostream& out, const LoopsRun& run, const std::vector<Tube>& tubes) {
  std::vector<char> bytes;
  const bool mirrored = frame_mirrors(run.volume);
  for (auto corners : run.analysis.surface.triangles) {
    if (mirrored) std::swap(corners[1], corners[2]);
    append_face(bytes, corners);
    flush(out, bytes, chunk_bytes);
  }
  auto first = static_cast<std::uint32_t>(run.analysis.surface.points.size());
  for (const Tube& tube : tubes) {
    for (const auto& [a, b, c] : tube.triangles)
      append_face(bytes, {first + a, first + b, first + c});
    first += static_cast<std::uint32_t>(tube.points.size());
    flush(out, bytes, chunk_bytes);
  }
  flush(out, bytes);
}

}  // namespace

void write_ply(std::ostream& out, const LoopsRun& run, const MeshOptions& options) {
  std::span<const Loop> loops;
  if (options.loops) loops = run.reported;
  const MeshSize size = size_of(run, loops);
  if (size.vertices > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max())) {
    throw LimitExceeded("the mesh has too many vertices for a PLY file");
  }
  const Vec3& spacing = run.volume.spacing;
  const double radius = options.tube_radius * *std::min_element(spacing.begin(), spacing.end());
  const std::vector<Tube> tubes = tubes_of(run, loops, radius);
  write_header(out, run, size);
  write_vertices(out, run, loops, tubes);
  write_faces(out, run, tubes);
}

}  // namespace isoloop
