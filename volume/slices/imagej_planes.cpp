#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/errors.h"
#include "volume/base/header_text.h"
#include "volume/base/refuse.h"
#include "volume/slices/stated_planes.h"
#include "volume/voxels/length_unit.h"

namespace isoloop {
namespace {

/// The text after "name=" in a line of what ImageJ writes of an image.
std::optional<std::string> stated_text(const std::string& description, const std::string& name) {
  const std::size_t at = description.find("\n" + name + "=");
  if (at == std::string::npos) return std::nullopt;
  const std::string_view rest = std::string_view(description).substr(at + name.size() + 2);
  return std::string(trimmed(rest.substr(0, rest.find_first_of(std::string_view("\n\0", 2)))));
}

std::uint64_t stated_count(const std::string& description, const std::string& name,
                           const std::string& what) {
  const auto text = stated_text(description, name);
  if (!text) return 1;
  const auto count = whole_number_of(*text);
  constexpr std::int64_t most = 1 << 24;  // so that products of three fit
  if (!count || *count < 1 || *count > most) {
    refuse(what, "its description states " + name + "=" + *text +
                     ", which is no number of pages; save it as a plain TIFF");
  }
  return static_cast<std::uint64_t>(*count);
}

/// ImageJ's lengths: pixels per unit in the tags, the distance of slices and the unit in the text.
void set_imagej_spacing(const std::string& description, const TiffPage& page, TiffPlanes& planes) {
  const auto between = stated_text(description, "spacing");
  const std::string unit = stated_text(description, "unit").value_or("");
  const std::optional<LengthUnit> length = length_unit(unit);
  if (!between && !length) return;
  const double x = page.pixels_per_unit_x;
  const double y = page.pixels_per_unit_y;
  const Vec3 spacing{x > 0.0 ? 1.0 / x : 1.0, y > 0.0 ? 1.0 / y : 1.0,
                     std::abs(number_of(between.value_or("1")).value_or(0.0))};
  if (!std::all_of(spacing.begin(), spacing.end(), is_spacing)) {
    planes.warnings.push_back(
        {.text = "its description states a spacing that is no length: 1 is taken",
         .advice = {Advice::override_spacing}});
    return;
  }
  planes.spacing = spacing;
  if (length) planes.unit = length->name;
  if (unit.empty() && page.resolution_unit == 2) planes.unit = "inch";
  if (unit.empty() && page.resolution_unit == 3) planes.unit = "cm";
  if (!between && spacing[0] != 1.0) {
    planes.warnings.push_back({.text = "it states no distance between slices: 1 " + planes.unit +
                                       " is taken, as ImageJ does",
                               .advice = {Advice::override_spacing}});
  }
}

/// In the order in which pages follow one another, the fastest first: channels, slices, frames
/// unless `order=` says otherwise.
std::vector<TiffAxis> imagej_axes(const std::string& description, std::uint64_t channels,
                                  std::uint64_t slices, std::uint64_t frames,
                                  const std::string& what) {
  std::string order = stated_text(description, "order").value_or("czt");
  std::erase_if(order, [](char c) { return c == 'x' || c == 'y' || c == 'X' || c == 'Y'; });
  std::vector<TiffAxis> axes;
  for (const char c : order) {
    if (c == 'c' || c == 'C') axes.push_back({TiffAxisName::channels, channels});
    if (c == 'z' || c == 'Z') axes.push_back({TiffAxisName::slices, slices});
    if (c == 't' || c == 'T') axes.push_back({TiffAxisName::frames, frames});
  }
  const auto states = [&](TiffAxisName name) {
    return std::any_of(axes.begin(), axes.end(), [&](const TiffAxis& a) { return a.name == name; });
  };
  if (order.size() != 3 || axes.size() != 3 || !states(TiffAxisName::channels) ||
      !states(TiffAxisName::slices) || !states(TiffAxisName::frames)) {
    refuse(what, "its description states order=" + *stated_text(description, "order") +
                     ", which is no order of channels, slices and frames; save it as a plain TIFF");
  }
  return axes;
}

}  // namespace

TiffPlanes imagej_planes(const std::string& description, std::uint64_t pages, const TiffPage& first,
                         const std::string& what) {
  TiffPlanes planes;
  set_imagej_spacing(description, first, planes);
  const std::uint64_t images = stated_count(description, "images", what);
  const std::uint64_t channels = stated_count(description, "channels", what);
  const std::uint64_t frames = stated_count(description, "frames", what);
  const bool states_slices = stated_text(description, "slices").has_value();
  const std::uint64_t slices =
      states_slices || channels * frames > 1 ? stated_count(description, "slices", what) : images;
  const std::uint64_t product = channels * slices * frames;
  planes.behind_first = pages == 1 && images > 1 && first.plain;
  const std::uint64_t held = planes.behind_first ? images : pages;
  if (images > held) {
    refuse(what, "states " + std::to_string(images) + " images but holds " +
                     count_text(pages, "page", "pages") +
                     "; fetch the file again or save it as a plain TIFF");
  }
  if (product == held) {
    planes.axes = imagej_axes(description, channels, slices, frames, what);
    return planes;
  }
  if (channels * frames > 1) {
    refuse(what, "states " + std::to_string(channels) + " channels, " + std::to_string(slices) +
                     " slices and " + std::to_string(frames) + " frames, which " +
                     count_text(held, "page does", "pages do") +
                     " not fill; save it as a plain TIFF");
  }
  planes.axes = {{TiffAxisName::slices, held}};
  planes.warnings.push_back({.text = "its description states " +
                                     count_text(product, "slice", "slices") + ", but it holds " +
                                     std::to_string(held) + " pages: all are read"});
  return planes;
}

}  // namespace isoloop
