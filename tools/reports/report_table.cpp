#include "tools/reports/report_table.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "tools/runs/mesh_comparison.h"
#include "tools/words/largest.h"
#include "tools/words/number_text.h"
#include "tools/words/sentence.h"
#include "tools/words/text_rows.h"
#include "volume/base/memory_limit.h"

namespace isoloop {
namespace {

constexpr std::size_t most_components = 20;  // rows of the table; JSON has all
constexpr std::size_t many_loops = 100;
constexpr double voxels_of_noise = 3.0;  // size of the loops of a noisy surface, but for few

std::string point_text(const Vec3& point, int decimals) {
  std::string text = "(";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axis > 0) text += ", ";
    text += fixed_text(point[axis], decimals);
  }
  return text += ")";
}

std::string certificate_text(const Loop& loop) {
  if (loop.kind == LoopKind::loop) return "nontrivial on M";
  return loop.certificate.trivial_inside ? "bounds inside" : "bounds outside";
}

Row<10> row_of(const Loop& loop, const Volume& volume) {
  const int decimals = length_decimals(volume.spacing);
  return {std::to_string(loop.id),
          kind_text(loop.kind),
          fix_text(loop.kind),
          fixed_text(loop.length, decimals),
          fixed_text(loop.size, decimals),
          point_text(loop.center_index, 1),
          point_text(to_world(volume, loop.center_index), decimals),
          std::to_string(loop.component),
          std::to_string(loop.curves.size()),
          certificate_text(loop)};
}

std::string iso_text(const IsoLevel& level) {
  return shortest_text(level.iso) + (level.upper ? " to " + shortest_text(*level.upper) : "");
}

// Why the surface is missing, or is no more than the border of the volume.
void write_level_note(std::ostream& out, const CountRun& run) {
  const std::string iso = iso_text(run.level);
  std::string range = "[";
  range += shortest_text(run.range.min) + ", " + shortest_text(run.range.max) + "]";
  const bool below = run.level.upper.value_or(run.level.iso) < run.range.min;
  const bool above = run.level.iso > run.range.max;
  if (run.analysis.surface.triangles.empty()) {
    if (below || above) {
      out << "no surface: iso " << iso << " is outside the value range " << range << "; 0 loops\n";
    } else {
      out << "no surface exists at iso " << iso << ", value range " << range << "; 0 loops\n";
    }
  } else if (below || above) {
    out << "note: iso " << iso << " is outside the value range " << range
        << ", so every voxel is inside and the surface is the border of the volume\n";
  }
}

// The counts that the mesh has by itself, and how the voxels were chosen.
void write_mesh(std::ostream& out, const CountRun& run) {
  if (!run.volume.mesh) return;
  out << "mesh        " << mesh_text(*run.volume.mesh);
  if (const std::optional<bool> agree = voxels_agree(run, run.analysis))
    out << (*agree ? ": the voxels have the same" : ": the voxels have others");
  out << '\n';
  for (const std::string& note : sentences_of(run.volume.notes))
    out << "note        " << note << '\n';
}

void write_counts(std::ostream& out, const CountRun& run) {
  const Surface& surface = run.analysis.surface;
  const Betti& betti = run.analysis.betti;
  const auto count = [](std::size_t n) { return static_cast<std::int64_t>(n); };
  std::array<std::string, 3> numbers{std::to_string(betti.b0), std::to_string(betti.b1),
                                     std::to_string(betti.b2)};
  std::size_t width = 0;
  for (const std::string& number : numbers) width = std::max(width, number.size());
  for (std::string& number : numbers) number.insert(0, width - number.size(), ' ');
  out << "surface     " << counted(count(surface.points.size()), "vertex", "vertices") << ", "
      << counted(count(surface.triangles.size()), "triangle", "triangles") << ", "
      << counted(count(surface.components.size()), "component", "components")
      << ", Euler characteristic χ = " << surface.euler() << ", genus " << surface.genus();
  if (surface.boundary == Boundary::open) {
    std::int64_t borders = 0;
    for (const SurfaceComponent& component : surface.components) borders += component.borders;
    out << ", " << counted(borders, "border curve", "border curves") << '\n'
        << "components  " << numbers[0] << "  (b0: separate pieces of the surface)\n"
        << "loops       " << numbers[1] << "  (b1: independent loops on the surface)\n"
        << "closed      " << numbers[2] << "  (b2: pieces of the surface without a border)\n";
    return;
  }
  out << '\n'
      << "components  " << numbers[0] << "  (b0: separate pieces of the solid)\n"
      << "tunnels     " << numbers[1] << "  (b1: ways through the solid, as in a ring)\n"
      << "cavities    " << numbers[2] << "  (b2: hollows closed off inside the solid)\n";
}

void write_head(std::ostream& out, const CountRun& run) {
  out << run.file << ": " << volume_text(run.volume) << ", inside is " << inside_text(run)
      << "\n\n";
  write_counts(out, run);
  write_mesh(out, run);
  write_level_note(out, run);
}

// The largest first, where there is more than one.
void write_components(std::ostream& out, const Surface& surface) {
  const auto& components = surface.components;
  if (components.size() < 2) return;
  std::vector<std::size_t> order = largest_first(components, &SurfaceComponent::vertices);
  order.resize(std::min(order.size(), most_components));
  const bool open = surface.boundary == Boundary::open;
  std::vector<Row<6>> rows{
      {"component", "vertices", "triangles", "χ", "genus", open ? "border curves" : "bounds"}};
  for (const std::size_t i : order) {
    const SurfaceComponent& component = components[i];
    rows.push_back(
        {std::to_string(i), std::to_string(component.vertices), std::to_string(component.triangles),
         std::to_string(component.euler), std::to_string(component.genus),
         open ? std::to_string(component.borders) : bounds_text(surface.boundary, component)});
  }
  out << '\n';
  write_rows(out, rows, {false, false, false, false, false, true});
  if (components.size() > order.size())
    out << "and " << components.size() - order.size() << " smaller ones: --json lists all\n";
}

void write_total(std::ostream& out, const LoopsRun& run, LoopKind kind) {
  const auto loops = std::count_if(run.reported.begin(), run.reported.end(),
                                   [kind](const Loop& loop) { return loop.kind == kind; });
  double length = 0.0;
  double found = 0.0;
  for (const Loop& loop : run.reported) {
    if (loop.kind != kind) continue;
    length += loop.length;
    found += loop.found_length;
  }
  const int decimals = length_decimals(run.volume.spacing);
  out << "total length of " << counted(loops, name_of(kind), name_of(kind) + "s") << ": "
      << fixed_text(length, decimals) << (run.volume.unit.empty() ? "" : " " + run.volume.unit);
  if (run.tighten != Tighten::none) out << " (as found: " << fixed_text(found, decimals) << ')';
  out << '\n';
}

void write_rows_of_loops(std::ostream& out, const LoopsRun& run, std::size_t most_rows) {
  if (run.reported.empty()) return;
  std::vector<Row<10>> rows{{"id", "kind", "fix", with_unit("length", run.volume),
                             with_unit("size", run.volume), "centre (index)", "centre (world)",
                             "component", "curves", "certificate"}};
  for (const Loop* loop : loops_in_rows(run, most_rows)) rows.push_back(row_of(*loop, run.volume));
  out << '\n';
  write_rows(out, rows, {false, true, true, false, false, false, false, false, false, true});
  write_more(out, rows.size() - 1, run.reported.size());
}

/// Where most of many loops are as small as those of noise.
void write_size_hint(std::ostream& out, const LoopsRun& run) {
  const Vec3& spacing = run.volume.spacing;
  const double size = voxels_of_noise * std::min({spacing[0], spacing[1], spacing[2]});
  const auto small =
      static_cast<std::size_t>(std::count_if(run.reported.begin(), run.reported.end(),
                                             [&](const Loop& loop) { return loop.size < size; }));
  if (run.reported.size() < many_loops || 2 * small <= run.reported.size()) return;
  out << "note: " << small << " of " << run.reported.size()
      << " loops have a size below 3 voxels, as noise has; --min-size " << shortest_text(size)
      << " leaves them out\n";
}

void write_loops(std::ostream& out, const LoopsRun& run, std::size_t most_rows) {
  write_rows_of_loops(out, run, most_rows);
  out << '\n';
  write_size_hint(out, run);
  const bool open = run.analysis.surface.boundary == Boundary::open;
  if (open) write_total(out, run, LoopKind::loop);
  if (!open && run.filter.handles) write_total(out, run, LoopKind::handle);
  if (!open && run.filter.tunnels) write_total(out, run, LoopKind::tunnel);
  if (run.reported.size() != run.analysis.loops.size()) {
    out << "reported: " << run.reported.size() << " of "
        << counted(static_cast<std::int64_t>(run.analysis.loops.size()), "loop", "loops")
        << ", as --min-size" << (open ? " and --max-size" : ", --max-size and --side") << " ask\n";
  }
  if (open) {
    out << "verified: every loop is closed and lies on M, and none is a sum of others; "
        << run.analysis.loops.size() << " = b1\n";
    return;
  }
  const std::int64_t genus = run.analysis.surface.genus();
  out << "verified: every loop is closed, lies on M and is certified; " << genus << " handle + "
      << genus << " tunnel = 2 × genus\n";
}

}  // namespace

std::string part_text(const Volume& volume, const VolumePart& part) {
  std::string text = "voxels ";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axis > 0) text += ',';
    text += std::to_string(part.first[axis]) + ":";
    text += std::to_string(part.first[axis] + volume.dims[axis]);
  }
  return text + " of " + dims_text(part.whole);
}

std::string volume_text(const Volume& volume) {
  const std::string text = dims_text(volume.dims) + " " + type_name(volume.values);
  return volume.part ? text + " (" + part_text(volume, *volume.part) + ")" : text;
}

void write_hint(std::ostream& out, const RunInput& run) {
  if (!run.remark.empty()) out << "\nnote: " << run.remark << '\n';
  if (!run.hint.empty()) out << "\nnote: " << run.hint << '\n';
}

std::string inside_text(const IsoLevel& level) {
  if (level.upper) return shortest_text(level.iso) + " <= f <= " + shortest_text(*level.upper);
  return (level.inside == InsideRule::above ? "f >= " : "f <= ") + shortest_text(level.iso);
}

std::string inside_text(const RunInput& run) {
  return inside_text(run.level) + (run.iso_choice.empty() ? "" : ", " + run.iso_choice);
}

std::string bounds_text(Boundary boundary, const SurfaceComponent& component) {
  if (boundary == Boundary::open) return "unknown";
  return component.bounds_cavity ? "cavity" : "solid";
}

std::string kind_text(LoopKind kind) {
  const std::string name = name_of(kind);
  return name.substr(0, name.find(' '));
}

std::string fix_text(LoopKind kind) {
  switch (kind) {
    case LoopKind::handle:
      return "cut";
    case LoopKind::tunnel:
      return "fill";
    case LoopKind::loop:
      return "none";
  }
  return "none";
}

std::string unit_text(const Volume& volume) {
  return volume.unit.empty() ? "unit of the spacing" : volume.unit;
}

std::string with_unit(const std::string& name, const Volume& volume, int power) {
  if (volume.unit.empty()) return name;
  return name + " (" + volume.unit + (power == 2 ? "²" : power == 3 ? "³" : "") + ")";
}

std::string frame_comment(const RunInput& run) {
  const Vec3& spacing = run.volume.spacing;
  return "frame " + frame_name(run.volume.frame) + ", spacing " + shortest_text(spacing[0]) + ' ' +
         shortest_text(spacing[1]) + ' ' + shortest_text(spacing[2]) + " in the unit of lengths";
}

void write_count_table(std::ostream& out, const CountRun& run) {
  write_head(out, run);
  write_components(out, run.analysis.surface);
  write_hint(out, run);
}

std::vector<const Loop*> loops_in_rows(const LoopsRun& run, std::size_t most_rows) {
  return items_in_rows(run.reported, most_rows, &Loop::size);
}

void write_more(std::ostream& out, std::size_t rows, std::size_t all) {
  if (rows < all) out << "and " << all - rows << " more: --top 0 shows all, --json lists all\n";
}

void write_table(std::ostream& out, const LoopsRun& run, std::size_t most_rows) {
  write_head(out, run);
  write_loops(out, run, most_rows);
  write_hint(out, run);
}

}  // namespace isoloop
