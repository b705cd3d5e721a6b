#include "tools/flags/flag_lists.h"

#include "volume/base/header_text.h"

namespace isoloop {
namespace {

// "10:20", "10:", ":20", ":" or nothing.
std::optional<CropRange> parse_range(std::string_view text) {
  text = trimmed(text);
  if (text.empty()) return CropRange{};
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  CropRange range;
  const std::string_view begin = trimmed(text.substr(0, colon));
  const std::string_view end = trimmed(text.substr(colon + 1));
  if (!begin.empty()) range.begin = parse_number<std::int64_t>(begin);
  if (!end.empty()) range.end = parse_number<std::int64_t>(end);
  if (range.begin.has_value() == begin.empty() || range.end.has_value() == end.empty()) {
    return std::nullopt;
  }
  return range;
}

}  // namespace

std::vector<std::int64_t> parse_labels(std::string_view text) {
  return parse_list<std::int64_t>(
      text, ",",
      "--label " + std::string(text) + " does not state labels, as --label 3 and --label 3,7 do");
}

CropBox parse_crop(std::string_view text) {
  std::vector<CropRange> ranges;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::optional<CropRange> range = parse_range(text.substr(at, comma - at));
    if (!range) break;
    ranges.push_back(*range);
    at = comma + 1;
    if (comma == text.size() && ranges.size() == 3) return {ranges[0], ranges[1], ranges[2]};
  }
  throw InvalidArgument("--crop " + std::string(text) +
                        " does not state three ranges of voxels, along x, y and z, as --crop "
                        "10:20,:,5: does");
}

}  // namespace isoloop
