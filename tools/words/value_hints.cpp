#include "tools/words/value_hints.h"

#include <algorithm>
#include <cmath>

#include "tools/words/number_text.h"

namespace isoloop {
namespace {

bool is_whole(double value) { return std::isfinite(value) && value == std::floor(value); }

std::string flags_of_mask(const ValueRange& range) {
  const std::string inside = shortest_text(range.max);
  return (is_whole(range.max) ? "--label " : "--iso ") + inside + " --connectivity 26";
}

}  // namespace

bool is_mask(const ValueRange& range) { return range.distinct.size() == 2; }

bool is_label_map(const ValueRange& range) {
  constexpr double most_span = 16.0;  // for each label
  const auto count = static_cast<double>(range.distinct.size());
  return count >= 3 && range.max - range.min <= most_span * count &&
         std::all_of(range.distinct.begin(), range.distinct.end(), is_whole);
}

std::string mask_hint(const ValueRange& range) {
  return "the voxels are " + shortest_text(range.min) + " and " + shortest_text(range.max) +
         " alone, so this is a mask, and how its voxels are joined is a choice: " +
         flags_of_mask(range) + " joins those of " + shortest_text(range.max) +
         " across corners too";
}

std::string values_text(const ValueRange& range) {
  std::string text =
      "its values run from " + shortest_text(range.min) + " to " + shortest_text(range.max);
  if (is_mask(range)) {
    return text + ", and there are no others, so it is a mask: " + flags_of_mask(range) +
           " takes the voxels of " + shortest_text(range.max) + " as inside";
  }
  if (!is_label_map(range)) return text;
  std::string labels;
  for (const double value : range.distinct) {
    labels += (labels.empty() ? "" : ", ") + shortest_text(value);
  }
  return text + ", and are the whole numbers " + labels +
         " alone, as in a label map: --label N[,M...] takes some of them as inside";
}

}  // namespace isoloop
