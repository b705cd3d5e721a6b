// Small meshes of known topology, and their bytes in each format.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <string_view>

#include "volume/mesh/mesh.h"

namespace isoloop::test {

inline Mesh box_mesh(const Vec3& low, const Vec3& high) {
  Mesh mesh;
  for (unsigned c = 0; c < 8; ++c) {
    mesh.points.push_back({(c & 1U) != 0 ? high[0] : low[0], (c & 2U) != 0 ? high[1] : low[1],
                           (c & 4U) != 0 ? high[2] : low[2]});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

inline Mesh sample_box() { return box_mesh({-1.5, 0.25, 2}, {1, 10.75, 300}); }

/// Axis z through `centre`; `around` by `across` quads, each cut in two.
inline Mesh torus_mesh(const Vec3& centre, double ring, double tube, std::uint32_t around,
                       std::uint32_t across) {
  constexpr double turn = 6.283185307179586;
  Mesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = turn * i / around;
      const double v = turn * j / across;
      const double radius = ring + tube * std::cos(v);
      mesh.points.push_back({centre[0] + radius * std::cos(u), centre[1] + radius * std::sin(u),
                             centre[2] + tube * std::sin(v)});
      const std::uint32_t next_i = (i + 1) % around;
      const std::uint32_t next_j = (j + 1) % across;
      const std::uint32_t a = i * across + j;
      const std::uint32_t b = next_i * across + j;
      const std::uint32_t c = next_i * across + next_j;
      const std::uint32_t d = i * across + next_j;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

/// A block with `holes` square holes through it, in a row: unit cubes of a 2 holes + 1 by 3 plan,
/// whose faces are two triangles each.
inline Mesh block_mesh(int holes) {
  const int length = 2 * holes + 1;
  const auto is_solid = [&](int x, int y, int z) {
    const bool within = x >= 0 && x < length && y >= 0 && y < 3 && z == 0;
    return within && !(y == 1 && x % 2 == 1);
  };
  Mesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto point = [&](const std::array<int, 3>& at) {
    const auto [place, is_new] =
        numbers.emplace(at, static_cast<std::uint32_t>(mesh.points.size()));
    if (is_new) {
      mesh.points.push_back(
          {static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])});
    }
    return place->second;
  };
  for (int x = 0; x < length; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (std::size_t face = 0; face < 6 && is_solid(x, y, 0); ++face) {
        const std::size_t a = face / 2;
        std::array<int, 3> beyond{x, y, 0};
        beyond[a] += face % 2 == 0 ? -1 : 1;
        if (is_solid(beyond[0], beyond[1], beyond[2])) continue;
        std::array<int, 3> corner{x, y, 0};
        corner[a] += face % 2 == 0 ? 0 : 1;
        std::array<std::uint32_t, 4> square{};
        for (std::size_t c = 0; c < 4; ++c) {  // anticlockwise as seen from the end of axis a
          std::array<int, 3> at = corner;
          at[(a + 1) % 3] += c == 1 || c == 2 ? 1 : 0;
          at[(a + 2) % 3] += c >= 2 ? 1 : 0;
          square[c] = point(at);
        }
        if (face % 2 == 0) std::swap(square[1], square[3]);
        mesh.triangles.push_back({square[0], square[1], square[2]});
        mesh.triangles.push_back({square[0], square[2], square[3]});
      }
    }
  }
  return mesh;
}

inline Mesh flipped(Mesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

inline Mesh joined(Mesh mesh, const Mesh& other) {
  const auto shift = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles) {
    mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return mesh;
}

enum class MeshFormat { stl_ascii, stl_binary, ply_ascii, ply_little, ply_big, obj, off };

inline MeshKind kind_of(MeshFormat format) {
  switch (format) {
    case MeshFormat::stl_ascii:
    case MeshFormat::stl_binary:
      return MeshKind::stl;
    case MeshFormat::obj:
      return MeshKind::obj;
    case MeshFormat::off:
      return MeshKind::off;
    default:
      return MeshKind::ply;
  }
}

inline Mesh parsed(const std::string& bytes, MeshFormat format) {
  return parse_mesh(bytes, kind_of(format), "a.mesh");
}

template <class T>
void put_bytes(std::string& bytes, T value, bool big = false) {
  std::string raw(sizeof value, '\0');
  std::memcpy(raw.data(), &value, sizeof value);
  if (big) raw.assign(raw.rbegin(), raw.rend());
  bytes += raw;
}

inline std::string stl_bytes(const Mesh& mesh, bool binary) {
  std::string bytes(80, ' ');
  std::ostringstream text;
  text << "solid sample\n";
  put_bytes(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int a = 0; a < 3; ++a) put_bytes(bytes, 0.0F);
    text << "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t corner : triangle) {
      const Vec3& p = mesh.points[corner];
      for (const double c : p) put_bytes(bytes, static_cast<float>(c));
      text << "vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
    put_bytes(bytes, std::uint16_t{0});
    text << "endloop\nendfacet\n";
  }
  text << "endsolid sample\n";
  return binary ? bytes : text.str();
}

/// Also carries properties and an element that a reader must step over.
inline std::string ply_bytes(const Mesh& mesh, MeshFormat format) {
  const bool ascii = format == MeshFormat::ply_ascii;
  const bool big = format == MeshFormat::ply_big;
  std::ostringstream text;
  text << "ply\nformat " << (ascii ? "ascii" : (big ? "binary_big_endian" : "binary_little_endian"))
       << " 1.0\ncomment sample\nelement camera 1\nproperty list uchar short view\nelement vertex "
       << mesh.points.size()
       << "\nproperty float x\nproperty float y\nproperty double z\nproperty uchar red\nelement "
          "face "
       << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  std::string bytes = text.str();
  text << "2 7 8\n";
  put_bytes(bytes, std::uint8_t{2});
  for (const std::int16_t value : {7, 8}) put_bytes(bytes, value, big);
  for (const Vec3& p : mesh.points) {
    text << p[0] << ' ' << p[1] << ' ' << p[2] << " 255\n";
    put_bytes(bytes, static_cast<float>(p[0]), big);
    put_bytes(bytes, static_cast<float>(p[1]), big);
    put_bytes(bytes, p[2], big);
    put_bytes(bytes, std::uint8_t{255});
  }
  for (const auto& t : mesh.triangles) {
    text << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    put_bytes(bytes, std::uint8_t{3});
    for (const std::uint32_t corner : t) put_bytes(bytes, corner, big);
  }
  return ascii ? text.str() : bytes;
}

inline std::string mesh_bytes(const Mesh& mesh, MeshFormat format) {
  if (format == MeshFormat::stl_ascii) return stl_bytes(mesh, false);
  if (format == MeshFormat::stl_binary) return stl_bytes(mesh, true);
  const bool obj = format == MeshFormat::obj;
  if (!obj && format != MeshFormat::off) return ply_bytes(mesh, format);
  std::ostringstream text;
  text << (obj ? "# sample\n" : "OFF\n# sample\n");
  if (!obj) text << mesh.points.size() << ' ' << mesh.triangles.size() << " 0\n";
  for (const Vec3& p : mesh.points) {
    text << (obj ? "v " : "") << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  for (const auto& t : mesh.triangles) {
    const std::uint32_t one = obj ? 1 : 0;
    text << (obj ? "f " : "3 ") << t[0] + one << ' ' << t[1] + one << ' ' << t[2] + one << '\n';
  }
  return text.str();
}

}  // namespace isoloop::test
