#include "volume/mesh.h"

#include <algorithm>
#include <fstream>
#include <numeric>
#include <optional>
#include <system_error>
#include <utility>

#include "core/base/errors.h"
#include "volume/memory_limit.h"
#include "volume/mesh_closure.h"
#include "volume/mesh_text.h"

namespace isoloop {
namespace {

// The file itself, its points and triangles, and the order of the points: a triangle takes six
// bytes of text or more ("f 1 2 3"), a point as many.
constexpr std::uint64_t most_expansion = 16;

std::optional<MeshKind> mesh_kind(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  if (extension == ".stl") return MeshKind::stl;
  if (extension == ".ply") return MeshKind::ply;
  if (extension == ".obj") return MeshKind::obj;
  if (extension == ".off") return MeshKind::off;
  return std::nullopt;
}

std::string read_file(const std::filesystem::path& path, std::uint64_t max_bytes) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (error) throw InvalidInput(path.string() + ": cannot be read: " + error.message());
  const std::uint64_t limit = max_bytes == 0 ? default_voxel_limit() : max_bytes;
  if (size > limit / most_expansion) {
    throw LimitExceeded(path.string() + ": a mesh file of " + std::to_string(size) +
                        " bytes may need " + std::to_string(most_expansion) +
                        " times as many in memory; raise --max-memory or take a smaller mesh");
  }
  std::string bytes(size, '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw InvalidInput(path.string() + ": cannot be opened; check that you may read it");
  }
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) {
    throw InvalidInput(path.string() + ": reading stopped after " + std::to_string(file.gcount()) +
                       " of " + std::to_string(size) + " bytes");
  }
  return bytes;
}

/// Points of equal coordinates become the first of them; unused points stay.
void weld(Mesh& mesh) {
  for (Vec3& point : mesh.points) {
    for (double& c : point) c += 0.0;  // -0 becomes 0
  }
  std::vector<std::uint32_t> order(mesh.points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return mesh.points[a] != mesh.points[b] ? mesh.points[a] < mesh.points[b] : a < b;
  });
  std::vector<std::uint32_t> first(mesh.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && mesh.points[order[i]] == mesh.points[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) corner = first[corner];
  }
  std::erase_if(mesh.triangles,
                [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

ParsedMesh parse(std::string_view bytes, MeshKind kind, const std::string& what) {
  switch (kind) {
    case MeshKind::stl:
      return parse_stl(bytes, what);
    case MeshKind::ply:
      return parse_ply(bytes, what);
    case MeshKind::obj:
      return parse_obj(bytes, what);
    case MeshKind::off:
      return parse_off(bytes, what);
  }
  throw InvalidInput(what + ": no mesh");
}

}  // namespace

bool is_mesh(const std::filesystem::path& path) { return mesh_kind(path).has_value(); }

Mesh parse_mesh(std::string_view bytes, MeshKind kind, const std::string& what) {
  ParsedMesh parsed = parse(bytes, kind, what);
  Mesh& mesh = parsed.mesh;
  weld(mesh);
  if (mesh.triangles.empty()) {
    throw InvalidInput(what + ": the file holds no triangle; export the surface as triangles");
  }
  if (parsed.last_face_may_be_cut && closure_of(mesh).open_edges > 0) {
    throw InvalidInput(what +
                       ": the last line does not end and the mesh is open, so the file may " +
                       "be cut; fetch or export it again, or end the line if it is whole");
  }
  return std::move(mesh);
}

Mesh read_mesh(const std::filesystem::path& path, std::uint64_t max_bytes) {
  const std::optional<MeshKind> kind = mesh_kind(path);
  if (!kind) throw InvalidArgument(path.string() + ": meshes are .stl, .ply, .obj and .off files");
  return parse_mesh(read_file(path, max_bytes), *kind, path.string());
}

}  // namespace isoloop
