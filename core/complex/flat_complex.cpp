#include "core/complex/flat_complex.h"

namespace isoloop {
FlatComplex::FlatComplex(std::uint32_t cell_bound, std::uint32_t edge_bound,
                         std::span<const FlatPiece> pieces)
    : cell_bound_(cell_bound), first_segment_{0} {
  const auto count = static_cast<std::uint32_t>(pieces.size());
  const auto for_each_incidence = [&](const auto& visit) {
    for (std::uint32_t piece = 0; piece < count; ++piece)
      for (const std::uint32_t edge : pieces[piece].edges) visit(piece, edge);
  };
  borders_ = collected_rows(count, for_each_incidence);
  rings_ = collected_rows(edge_bound, [&](const auto& visit) {
    for_each_incidence([&](std::uint32_t piece, std::uint32_t edge) { visit(edge, piece); });
  });
  for (const FlatPiece& piece : pieces) {
    cells_.push_back(piece.cells);
    segments_.insert(segments_.end(), piece.segments.begin(), piece.segments.end());
    first_segment_.push_back(static_cast<std::uint32_t>(segments_.size()));
  }
}

}  // namespace isoloop
