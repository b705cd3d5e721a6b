#include "tools/runs/frowns.h"

#include <variant>

#include "core/grid/level.h"
#include "tools/words/number_text.h"
#include "tools/words/value_hints.h"

namespace isoloop {
namespace {

constexpr std::int64_t many_tunnels = 1000;
constexpr double most_of_border = 0.9;

}  // namespace

std::string spacing_note(const RunInput& run, bool stated_by_flag) {
  const Volume& volume = run.volume;
  if (stated_by_flag || volume.mesh || !volume.unit.empty() || volume.frame != Frame::index ||
      volume.level_set || volume.spacing != Vec3{1.0, 1.0, 1.0})
    return "";
  return "the file states no spacing: lengths and sizes are in voxels; --spacing X Y Z states it";
}

std::string label_warning(const RunInput& run, bool iso_is_stated) {
  if (!iso_is_stated || run.volume.level_set || !is_label_map(run.range)) return "";
  return "an iso value parts numbers, and these look like labels: " + values_text(run.range);
}

double inside_share_of_border(const RunInput& run) {
  std::int64_t inside = 0;
  std::int64_t all = 0;
  std::visit(
      [&](const auto& grid) {
        const Index3& dims = grid.dims;
        const auto look_at = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
          ++all;
          const auto place = static_cast<std::size_t>(x + dims[0] * (y + dims[1] * z));
          inside += level_of(grid.values[place], run.level) >= 0.0 ? 1 : 0;
        };
        for (std::int64_t z = 0; z < dims[2]; ++z)
          for (std::int64_t y = 0; y < dims[1]; ++y) {
            const bool whole_row = z == 0 || z + 1 == dims[2] || y == 0 || y + 1 == dims[1];
            const std::int64_t step = whole_row || dims[0] == 1 ? 1 : dims[0] - 1;
            for (std::int64_t x = 0; x < dims[0]; x += step) look_at(x, y, z);
          }
      },
      voxels_of(run));
  return static_cast<double>(inside) / static_cast<double>(all);
}

std::vector<std::string> count_warnings(const RunInput& run, const Analysis& analysis) {
  std::vector<std::string> warnings;
  if (analysis.surface.boundary == Boundary::open || analysis.surface.triangles.empty())
    return warnings;
  const double share = inside_share_of_border(run);
  const Index3& dims = run.volume.dims;
  const bool is_thick = dims[0] > 2 && dims[1] > 2 && dims[2] > 2;
  const bool is_inside_out = is_thick && share >= most_of_border && analysis.betti.b0 > 0;
  if (is_inside_out && !run.volume.level_set)
    warnings.push_back(fixed_text(100 * share, 0) +
                       " % of the voxels at the border of the volume are inside, so the surface "
                       "runs along it; --inside " +
                       (run.level.inside == InsideRule::above ? "below" : "above") +
                       " takes the other side, --open-boundary ends the surface there");
  if (analysis.betti.b1 > many_tunnels)
    warnings.push_back(
        "the solid has " + std::to_string(analysis.betti.b1) +
        " tunnels, most of which may be noise; another --iso may have fewer (isoloop "
        "scan), and --min-size of isoloop loops leaves small ones out");
  return warnings;
}

}  // namespace isoloop
