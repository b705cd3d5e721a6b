#include "tools/runs/scan_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <type_traits>
#include <variant>

#include "core/base/errors.h"
#include "core/scan/plateau.h"
#include "core/scan/proposal.h"
#include "tools/flags/flag_lists.h"
#include "tools/runs/read_run.h"
#include "tools/words/number_text.h"
#include "tools/words/value_hints.h"

namespace isoloop {
namespace {

constexpr int default_values = 256;
constexpr double most_integers = 1024;

bool holds_integers(const AnyGridView& grid) {
  return std::visit([]<class T>(const GridView<T>&) { return std::is_integral_v<T>; }, grid);
}

/// From the least to the greatest voxel, of finite ones where there are others; as
/// core/grid/level.h takes the largest numbers.
std::array<double, 2> finite_range(const AnyGridView& grid, const ValueRange& voxels) {
  constexpr double largest = 1e150;
  std::array<double, 2> range{voxels.min, voxels.max};
  if (!std::isfinite(voxels.min) || !std::isfinite(voxels.max)) {
    range = {largest, -largest};
    std::visit(
        [&](const auto& view) {
          for (const auto value : view.values) {
            const auto number = static_cast<double>(value);
            if (!std::isfinite(number)) continue;
            range = {std::min(range[0], number), std::max(range[1], number)};
          }
        },
        grid);
    if (range[0] > range[1]) range = {0.0, 0.0};
  }
  for (double& end : range) end = std::clamp(end, -largest, largest);
  return range;
}

}  // namespace

std::vector<double> scan_values(const ScanRange& range, const AnyGridView& grid,
                                const ValueRange& voxels) {
  const std::array<double, 2> finite = finite_range(grid, voxels);
  const double from = range.from.value_or(finite[0]);
  const double to = range.to.value_or(finite[1]);
  if (!std::isfinite(from) || !std::isfinite(to) || from > to)
    throw InvalidArgument("--from " + shortest_text(from) + " and --to " + shortest_text(to) +
                          " leave no iso value");
  if (range.values && (*range.values < 1 || *range.values > static_cast<int>(max_scan_values)))
    throw InvalidArgument("--values must be 1 to " + std::to_string(max_scan_values));
  const bool integers = holds_integers(grid);
  const double all = std::floor(to) - std::ceil(from) + 1;
  const bool take_all = integers && !range.values && all <= most_integers;
  const int count = range.values.value_or(take_all ? static_cast<int>(all) : default_values);
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double share = count == 1 ? 0.5 : static_cast<double>(i) / (count - 1);
    const double value =
        take_all ? std::ceil(from) + i : from * (1 - share) + to * share;  // never beyond the ends
    values.push_back(integers ? std::round(value) : value);
  }
  values.erase(std::unique(values.begin(), values.end()), values.end());
  if (values.empty())
    throw InvalidArgument("--from " + shortest_text(from) + " and --to " + shortest_text(to) +
                          " leave no integer iso value");
  return values;
}

IgnoredSize parse_ignored_size(std::string_view text) {
  if (text.empty()) return {};
  if (text.ends_with('%')) {
    const std::optional<double> percent = parse_number<double>(text.substr(0, text.size() - 1));
    if (percent && *percent > 0 && *percent < 100) return {.share = *percent / 100};
  } else if (const auto voxels = parse_number<std::int64_t>(text); voxels && *voxels >= 0) {
    return {.voxels = voxels};
  }
  throw InvalidArgument("--ignore-below " + std::string(text) +
                        " states neither a number of voxels nor a share of the largest component, "
                        "as 64 and 0.1% do");
}

Scan scan_of(const RunInput& run, const std::vector<double>& isos, const Progress& progress,
             const IgnoredSize& ignored) {
  Scan scan = about_file(run.file, [&] {
    return scan_and_propose(voxels_of(run), isos,
                            {.inside = run.level.inside,
                             .topology = run.level.topology,
                             .ignore_below = ignored.voxels,
                             .ignore_share = ignored.share,
                             .progress = progress,
                             .max_bytes = run.cost.max_bytes});
  });
  if (!labels_text(run).empty()) scan.proposed = scan.otsu = scan.valley = std::nullopt;
  return scan;
}

std::string proposal_text(const Scan& scan) {
  if (scan.by == ProposedBy::plateau) {
    const Plateau& plateau = scan.plateaus[stablest_plateaus(scan.plateaus).front()];
    std::string text = "the middle of the most stable plateau, " +
                       shortest_text(scan.rows[plateau.first].iso) + " to " +
                       shortest_text(scan.rows[plateau.last].iso);
    if (scan.ignored_below > 0)
      text += ", of parts of " + std::to_string(scan.ignored_below) + " voxels and more";
    return text;
  }
  std::string text =
      "Otsu's value, which parts the voxels by their values alone, as no plateau is "
      "stable";
  if (scan.valley)
    text += "; the valley of the histogram is at " + shortest_text(scan.rows[*scan.valley].iso);
  return text;
}

std::string labels_text(const RunInput& run) {
  if (run.volume.level_set || !is_label_map(run.range)) return "";
  return values_text(run.range);
}

}  // namespace isoloop
