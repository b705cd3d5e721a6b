#include "tools/reports/report_surface.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/grid/vec3.h"
#include "tools/reports/report_mesh.h"
#include "tools/reports/report_table.h"
#include "tools/words/base64.h"
#include "tools/words/number_text.h"

namespace isoloop {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Point = std::array<float, 3>;

Point world_point(const LoopsRun& run, std::uint32_t vertex) {
  const auto& p = run.analysis.surface.points[vertex];
  const Vec3 world = to_world(run.volume, {p[0], p[1], p[2]});
  return {static_cast<float>(world[0]), static_cast<float>(world[1]), static_cast<float>(world[2])};
}

void append_float(Bytes& bytes, float number) {
  append_little_endian(bytes, std::bit_cast<std::uint32_t>(number));
}

/// Calls visit(corners) for each triangle, counter-clockwise seen from outside in the world.
template <class Visit>
void for_each_triangle(const LoopsRun& run, const Visit& visit) {
  const bool mirrored = frame_mirrors(run.volume);
  for (auto corners : run.analysis.surface.triangles) {
    if (mirrored) std::swap(corners[1], corners[2]);
    visit(corners);
  }
}

Point unit_normal(const Point& a, const Point& b, const Point& c) {
  std::array<double, 3> u{};
  std::array<double, 3> v{};
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = double{b[i]} - a[i];
    v[i] = double{c[i]} - a[i];
  }
  const Vec3 n = cross(u, v);
  const double length = norm(n);
  if (!(length > 0)) return {};
  return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
          static_cast<float>(n[2] / length)};
}

/// A VTK array: its length in bytes, then the bytes, each in base64.
void write_array(std::ostream& out, const char* attributes, const Bytes& bytes) {
  Bytes length;
  append_little_endian(length, static_cast<std::uint64_t>(bytes.size()));
  out << "<DataArray " << attributes << " format=\"binary\">" << base64(length) << base64(bytes)
      << "</DataArray>\n";
}

}  // namespace

void write_surface_obj(std::ostream& out, const LoopsRun& run) {
  out << "# isoloop: " << frame_comment(run) << "\no surface\n";
  for (std::uint32_t v = 0; v < run.analysis.surface.points.size(); ++v) {
    const auto [x, y, z] = world_point(run, v);
    out << "v " << shortest_text(x) << ' ' << shortest_text(y) << ' ' << shortest_text(z) << '\n';
  }
  for_each_triangle(run, [&](const auto& corners) {
    out << "f " << corners[0] + 1 << ' ' << corners[1] + 1 << ' ' << corners[2] + 1 << '\n';
  });
}

void write_surface_stl(std::ostream& out, const LoopsRun& run) {
  const Surface& surface = run.analysis.surface;
  if (surface.triangles.size() > std::numeric_limits<std::uint32_t>::max())
    throw LimitExceeded("the surface has too many triangles for an STL file");
  std::string head = "isoloop: " + frame_comment(run);
  head.resize(80, ' ');
  Bytes bytes;
  append_little_endian(bytes, static_cast<std::uint32_t>(surface.triangles.size()));
  out << head;
  const auto flush = [&] {
    for (const std::uint8_t byte : bytes) out.put(static_cast<char>(byte));
    bytes.clear();
  };
  for_each_triangle(run, [&](const auto& corners) {
    std::array<Point, 3> points{};
    for (std::size_t i = 0; i < 3; ++i) points[i] = world_point(run, corners[i]);
    for (const float x : unit_normal(points[0], points[1], points[2])) append_float(bytes, x);
    for (const Point& point : points)
      for (const float x : point) append_float(bytes, x);
    append_little_endian(bytes, std::uint16_t{0});
    if (bytes.size() > std::size_t{1} << 20) flush();
  });
  flush();
}

void write_surface_vtp(std::ostream& out, const LoopsRun& run) {
  const Surface& surface = run.analysis.surface;
  Bytes points;
  Bytes components;
  for (std::uint32_t v = 0; v < surface.points.size(); ++v) {
    for (const float x : world_point(run, v)) append_float(points, x);
    append_little_endian(components, surface.component_of_vertex[v]);
  }
  Bytes corners;
  Bytes offsets;
  std::uint64_t end = 0;
  for_each_triangle(run, [&](const auto& triangle) {
    for (const std::uint32_t corner : triangle)
      append_little_endian(corners, std::uint64_t{corner});
    append_little_endian(offsets, end += 3);
  });
  out << "<?xml version=\"1.0\"?>\n<!-- isoloop: " << frame_comment(run)
      << " -->\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      << "header_type=\"UInt64\">\n<PolyData><Piece NumberOfPoints=\"" << surface.points.size()
      << "\" NumberOfPolys=\"" << surface.triangles.size() << "\">\n<Points>";
  write_array(out, "type=\"Float32\" NumberOfComponents=\"3\"", points);
  out << "</Points>\n<Polys>";
  write_array(out, "type=\"Int64\" Name=\"connectivity\"", corners);
  write_array(out, "type=\"Int64\" Name=\"offsets\"", offsets);
  out << "</Polys>\n<PointData>";
  write_array(out, "type=\"UInt32\" Name=\"component\"", components);
  out << "</PointData></Piece></PolyData></VTKFile>\n";
}

LoopsReport surface_report(const std::string& name) {
  if (name.ends_with(".ply"))
    return [](std::ostream& out, const LoopsRun& run) { write_ply(out, run, {.loops = false}); };
  if (name.ends_with(".obj")) return write_surface_obj;
  if (name.ends_with(".stl")) return write_surface_stl;
  if (name.ends_with(".vtp")) return write_surface_vtp;
  throw InvalidArgument("--surface " + name +
                        ": the surface is written as .ply, .obj, .stl and .vtp");
}

}  // namespace isoloop
