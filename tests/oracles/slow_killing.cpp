#include "tests/oracles/slow_killing.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "tests/oracles/slow_reduction.h"

namespace isoloop::testing {
namespace {

using oracle::ExplicitComplex;

/// A face by its grid edges, and its cube if it is a wall: two walls may have the same edges.
struct FaceKey {
  ExplicitComplex::Place place;
  std::set<std::uint32_t> edges;
  std::uint32_t cube_of_wall = static_cast<std::uint32_t>(-1);
  auto operator<=>(const FaceKey&) const = default;
};

ExplicitComplex::Place place_of(Side side) {
  return side == Side::inside ? ExplicitComplex::Place::inside : ExplicitComplex::Place::outside;
}

std::map<FaceKey, int> faces_off_surface(const ExplicitComplex& slow, Side side) {
  std::map<FaceKey, int> faces;
  for (std::size_t face = 0; face < slow.faces.size(); ++face) {
    const auto& cell = slow.faces[face];
    if (cell.place != place_of(side)) continue;
    FaceKey key{cell.place, {}};
    for (const int edge : cell.boundary)
      if (slow.edges[static_cast<std::size_t>(edge)].place == cell.place)
        key.edges.insert(slow.grid_edge_of_edge[static_cast<std::size_t>(edge)]);
    const auto wall = slow.cube_of_wall.find(static_cast<int>(face));
    if (wall != slow.cube_of_wall.end()) key.cube_of_wall = wall->second;
    faces.emplace(std::move(key), static_cast<int>(face));
  }
  return faces;
}

struct Entry {
  float size = 0.0F;
  SidedPiece piece;
  int face = 0;
};

std::vector<Entry> entries_of(const GridComplex& complex, const GridSizes& sizes,
                              const ExplicitComplex& slow) {
  const std::map<FaceKey, int> faces = faces_off_surface(slow, complex.side());
  std::map<std::uint32_t, std::uint32_t> cube_of_wall;
  for (const BeyondWall& beyond : complex.beyond_walls()) cube_of_wall[beyond.piece] = beyond.cube;
  std::vector<Entry> entries;
  for (const std::uint32_t piece : all_pieces(complex)) {
    const auto edges = complex.edges_of(piece);
    FaceKey key{place_of(complex.side()), {edges.begin(), edges.end()}};
    const auto wall = cube_of_wall.find(piece);
    if (wall != cube_of_wall.end()) key.cube_of_wall = wall->second;
    const auto found = faces.find(key);
    if (found == faces.end()) throw std::logic_error("the oracle lacks a piece");
    entries.push_back({sizes.of_piece(piece), {complex.side(), piece}, found->second});
  }
  if (entries.size() != faces.size()) throw std::logic_error("the pieces differ in number");
  return entries;
}

}  // namespace

WrittenSide written_side(const Prepared& prepared, const ExplicitComplex& slow, Side side) {
  const auto beyond = static_cast<std::uint32_t>(slow.solids.size());
  std::map<int, std::vector<std::uint32_t>> cells;  // by face
  for (std::uint32_t solid = 0; solid < beyond; ++solid)
    for (const int face : slow.solids[solid].boundary) cells[face].push_back(solid);
  std::vector<FlatPiece> flat;
  FlatSizes sizes;
  std::vector<SidedPiece> pieces;
  for (const Entry& entry : entries_of(prepared.complex(side), prepared.sizes_on(side), slow)) {
    FlatPiece& piece = flat.emplace_back();
    // On the border of the box the other cell lies beyond. A wall has the same one on both sides,
    // and which it is does not matter.
    cells[entry.face].resize(2, beyond);
    piece.cells = {cells[entry.face][0], cells[entry.face][1]};
    for (const int edge : slow.faces[static_cast<std::size_t>(entry.face)].boundary)
      if (slow.edges[static_cast<std::size_t>(edge)].place == place_of(side))
        piece.edges.push_back(static_cast<std::uint32_t>(edge));
    sizes.by_piece.push_back(entry.size);
    pieces.push_back(entry.piece);
  }
  const auto edges = static_cast<std::uint32_t>(slow.edges.size());
  return {FlatComplex(beyond + 1, edges, flat), std::move(sizes), std::move(pieces)};
}

std::vector<SidedPiece> slow_killing_pieces(const Prepared& prepared, const ExplicitComplex& slow,
                                            std::span<const Side> sides) {
  std::vector<Entry> entries;
  for (const Side side : sides) {
    const std::vector<Entry> more =
        entries_of(prepared.complex(side), prepared.sizes_on(side), slow);
    entries.insert(entries.end(), more.begin(), more.end());
  }
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::pair(a.size, a.piece.piece) < std::pair(b.size, b.piece.piece);
  });
  std::vector<int> faces;
  std::map<int, SidedPiece> piece_of_face;
  for (const Entry& entry : entries) {
    faces.push_back(entry.face);
    piece_of_face[entry.face] = entry.piece;
  }
  std::vector<SidedPiece> killing;
  for (const int face : oracle::killing_faces(slow, faces))
    killing.push_back(piece_of_face.at(face));
  return killing;
}

}  // namespace isoloop::testing
