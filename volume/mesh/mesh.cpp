#include "volume/mesh/mesh.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

#include "core/base/errors.h"
#include "core/base/memory_budget.h"
#include "volume/base/file_kind.h"
#include "volume/base/memory_limit.h"
#include "volume/mesh/mesh_closure.h"
#include "volume/mesh/mesh_edges.h"
#include "volume/mesh/mesh_text.h"
#include "volume/mesh/mesh_weld.h"

namespace isoloop {
namespace {

// A triangle takes six bytes of text or more ("f 1 2 3"), a point as many. Polygons may take fewer
// for each of their triangles: check_join_memory() sees to them.
constexpr std::uint64_t text_expansion = 16;

// While corners are joined: the lists of the mesh, and of what is looked up by edge and by place.
constexpr std::uint64_t bytes_per_triangle = 24 + edge_bytes_per_triangle;
constexpr std::uint64_t bytes_per_point = 112;

/// Of triangles and points beside the bytes of their file.
void check_join_memory(std::uint64_t triangles, std::uint64_t points, std::uint64_t file_bytes,
                       std::uint64_t max_bytes, const std::string& what) {
  const std::uint64_t needed =
      file_bytes + triangles * bytes_per_triangle + points * bytes_per_point;
  const std::uint64_t limit = max_bytes == 0 ? default_voxel_limit() : max_bytes;
  if (needed <= limit) return;
  throw LimitExceeded(
      {.file = what,
       .text = "to join " + std::to_string(triangles) + " triangles at their edges takes " +
               bytes_text(needed) + ", and the limit is " + bytes_text(limit),
       .advice = {Advice::raise_memory_limit, Advice::take_smaller_mesh}},
      {.unit = Excess::Unit::bytes, .needed = needed, .limit = limit, .stage = "read"});
}

std::optional<MeshKind> mesh_kind(const std::filesystem::path& path) {
  switch (file_kind(path).value_or(FileKind::raw)) {
    case FileKind::stl:
      return MeshKind::stl;
    case FileKind::ply:
      return MeshKind::ply;
    case FileKind::obj:
      return MeshKind::obj;
    case FileKind::off:
      return MeshKind::off;
    default:
      return std::nullopt;
  }
}

/// How many triangles a binary STL file of `size` bytes holds, if `file` is one.
std::optional<std::uint64_t> triangles_of_stl(std::istream& file, std::uint64_t size) {
  constexpr std::uint64_t header_bytes = 84;
  constexpr std::uint64_t triangle_bytes = 50;
  std::string header(header_bytes, '\0');
  const bool has_header = static_cast<bool>(file.read(header.data(), header_bytes));
  file.clear();
  file.seekg(0);
  if (!has_header) return std::nullopt;
  std::uint64_t stated = 0;
  for (std::size_t b = header_bytes; b-- > header_bytes - 4;) {
    stated = stated << 8U | static_cast<unsigned char>(header[b]);
  }
  if (size != header_bytes + triangle_bytes * stated) return std::nullopt;
  return stated;
}

std::string read_file(const std::filesystem::path& path, MeshKind kind, std::uint64_t max_bytes) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (error)
    throw InvalidInput({.file = path.string(), .text = "cannot be read: " + error.message()},
                       Fault::unreadable);
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw InvalidInput(
        {.file = path.string(), .text = "cannot be opened; check that you may read it"},
        Fault::unreadable);
  }
  const std::uint64_t limit = max_bytes == 0 ? default_voxel_limit() : max_bytes;
  const auto triangles = kind == MeshKind::stl ? triangles_of_stl(file, size) : std::nullopt;
  if (triangles) {
    check_join_memory(*triangles, 3 * *triangles, size, limit, path.string());
  } else if (size > limit / text_expansion) {
    throw LimitExceeded({.file = path.string(),
                         .text = "a mesh file of " + std::to_string(size) + " bytes may need " +
                                 std::to_string(text_expansion) + " times as many in memory",
                         .advice = {Advice::raise_memory_limit, Advice::take_smaller_mesh}},
                        {.unit = Excess::Unit::bytes,
                         .needed = size * text_expansion,
                         .limit = limit,
                         .stage = "read"});
  }
  std::string bytes(size, '\0');
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) {
    throw InvalidInput({.file = path.string(),
                        .text = "reading stopped after " + std::to_string(file.gcount()) + " of " +
                                std::to_string(size) + " bytes"},
                       Fault::unreadable);
  }
  return bytes;
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
  throw InvalidInput({.file = what, .text = "no mesh"});
}

}  // namespace

bool is_mesh(const std::filesystem::path& path) { return mesh_kind(path).has_value(); }

Mesh parse_mesh(std::string_view bytes, MeshKind kind, const std::string& what,
                std::uint64_t max_bytes) {
  ParsedMesh parsed = parse(bytes, kind, what);
  check_join_memory(parsed.mesh.triangles.size(), parsed.mesh.points.size(), bytes.size(),
                    max_bytes, what);
  Mesh mesh = weld_borders(weld_equal_points(std::move(parsed.mesh)), what);
  if (mesh.triangles.empty()) {
    throw InvalidInput(
        {.file = what, .text = "the file holds no triangle; export the surface as triangles"});
  }
  if (parsed.last_face_may_be_cut && closure_of(mesh).open_edges > 0) {
    throw InvalidInput({.file = what,
                        .text =
                            "the last line does not end and the mesh is open, so the file may "
                            "be cut; fetch or export it again, or end the line if it is whole"});
  }
  return mesh;
}

Mesh read_mesh(const std::filesystem::path& path, std::uint64_t max_bytes) {
  const std::optional<MeshKind> kind = mesh_kind(path);
  if (!kind)
    throw InvalidArgument(
        {.file = path.string(), .text = "meshes are " + mesh_extensions() + " files"});
  return parse_mesh(read_file(path, *kind, max_bytes), *kind, path.string(), max_bytes);
}

}  // namespace isoloop
