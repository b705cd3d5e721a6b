#include "tools/runs/mesh_comparison.h"

#include <array>
#include <charconv>
#include <iostream>

#include "tools/words/number_text.h"

namespace isoloop {
namespace {

std::string counts_text(const Betti& betti) {
  return counted(betti.b0, "component", "components") + ", " +
         counted(betti.b1, "tunnel", "tunnels") + ", " + counted(betti.b2, "cavity", "cavities");
}

/// To four digits.
std::string short_text(double length) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.begin(), text.end(), length, std::chars_format::general, 4).ptr;
  return {text.begin(), end};
}

}  // namespace

std::optional<bool> voxels_agree(const RunInput& run, const Analysis& analysis) {
  const std::optional<MeshCounts>& mesh = run.volume.mesh;
  const IsoLevel& level = run.level;
  const bool is_on_mesh = level.iso == 0.0 && !level.upper && level.inside == InsideRule::below &&
                          analysis.surface.boundary == Boundary::closed;
  if (!mesh || !mesh->betti || !is_on_mesh) return std::nullopt;
  return *mesh->betti == analysis.betti;
}

std::string difference_text(const RunInput& run, const Analysis& analysis) {
  if (voxels_agree(run, analysis).value_or(true)) return {};
  const MeshCounts& mesh = *run.volume.mesh;
  if (mesh.voxels && *mesh.voxels == analysis.betti) return {};
  const double length = run.volume.spacing[0];
  const bool by_gap = mesh.gap && *mesh.gap < length;
  const double smaller = by_gap ? *mesh.gap / 2.0 : length / 2.0;
  return run.file + ": the voxels have " + counts_text(analysis.betti) + ", but the mesh itself " +
         counts_text(*mesh.betti) + ": walls, gaps or sharp edges are finer than voxels of " +
         short_text(length) + "; try --voxel " + short_text(smaller) +
         (by_gap ? ", half the least gap between two shells (" + short_text(*mesh.gap) + ")"
                 : ", half the present length") +
         ", or --resolution auto";
}

void compare_with_mesh(RunInput& run, const Analysis& analysis) {
  std::string difference = difference_text(run, analysis);
  if (!difference.empty()) add_warning(run, std::move(difference));
}

std::string mesh_text(const MeshCounts& mesh) {
  if (!mesh.betti) return "no counts of its own, because " + mesh.unknown;
  std::string text = counts_text(*mesh.betti) + " by its " +
                     counted(static_cast<std::int64_t>(mesh.triangles), "triangle", "triangles") +
                     " in " + counted(static_cast<std::int64_t>(mesh.shells), "shell", "shells");
  if (mesh.swallowed > 0) {
    text += " (" + std::to_string(mesh.swallowed) + " within the solid, so not counted)";
  }
  return text;
}

}  // namespace isoloop
