#include "volume/slices/tiff_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>

#include "core/base/errors.h"
#include "volume/base/header_text.h"
#include "volume/base/refuse.h"
#include "volume/slices/ome_planes.h"
#include "volume/voxels/length_unit.h"

namespace isoloop {
namespace {

std::string count_text(std::uint64_t count, const char* one, const char* more) {
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

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

/// "[2, 16, 20, 24]" after tifffile's `"shape":`, or "(2, 16, 20, 24)" after `shape=`, as it wrote
/// before. Nothing if it is damaged.
std::optional<std::vector<std::uint64_t>> shape_of(std::string_view json) {
  json.remove_prefix(json.find("shape"));
  const std::size_t begin = json.find_first_of("[(");
  const std::size_t end = json.find_first_of("])");
  if (begin == std::string_view::npos || end == std::string_view::npos || end < begin) {
    return std::nullopt;
  }
  std::string list(json.substr(begin + 1, end - begin - 1));
  std::replace(list.begin(), list.end(), ',', ' ');
  std::vector<std::uint64_t> shape;
  constexpr std::int64_t most = std::int64_t{1} << 32;
  for (const std::string& word : words_of(list)) {
    const auto size = whole_number_of(word);
    if (!size || *size < 1 || *size > most || shape.size() == 16) return std::nullopt;
    shape.push_back(static_cast<std::uint64_t>(*size));
  }
  return shape;
}

/// What tifffile writes of an array of several dimensions.
bool states_shape(std::string_view description) {
  return description.starts_with("shape=(") ||
         (description.starts_with("{") && description.find("\"shape\":") != std::string_view::npos);
}

/// The value of `"axes": "…"` in capitals; empty if it is not there.
std::string stated_axes(std::string_view json) {
  constexpr std::string_view key = "\"axes\":";
  const std::size_t at = json.find(key);
  if (at == std::string_view::npos) return {};
  std::string_view rest = json.substr(at + key.size());
  const std::size_t begin = rest.find('"');
  if (begin == std::string_view::npos) return {};
  rest.remove_prefix(begin + 1);
  std::string axes(rest.substr(0, rest.find('"')));
  std::transform(axes.begin(), axes.end(), axes.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return axes;
}

TiffAxisName axis_name(char letter) {
  switch (letter) {
    case 'Z':
      return TiffAxisName::slices;
    case 'C':
      return TiffAxisName::channels;
    case 'T':
      return TiffAxisName::frames;
    default:
      return TiffAxisName::unnamed;
  }
}

/// Axes of more than one plane before those of the image, the last one first. Where they have no
/// names, the last one is that of the slices.
std::vector<TiffAxis> leading_axes(const std::vector<std::uint64_t>& shape, std::size_t count,
                                   const std::string& names) {
  std::vector<TiffAxis> axes;
  for (std::size_t i = count; i-- > 0;) {
    const bool named = names.size() == shape.size();
    if (shape[i] > 1) axes.push_back({named ? axis_name(names[i]) : axis_name('?'), shape[i]});
  }
  const auto has = [&](TiffAxisName name) {
    return std::any_of(axes.begin(), axes.end(), [&](const TiffAxis& a) { return a.name == name; });
  };
  if (!has(TiffAxisName::slices)) {
    const auto unnamed = std::find_if(axes.begin(), axes.end(), [](const TiffAxis& axis) {
      return axis.name == TiffAxisName::unnamed;
    });
    if (unnamed != axes.end()) unnamed->name = TiffAxisName::slices;
  }
  return axes;
}

void check_names(const std::vector<TiffAxis>& axes, const std::string& what) {
  for (const TiffAxisName name : {TiffAxisName::slices, TiffAxisName::channels,
                                  TiffAxisName::frames, TiffAxisName::unnamed}) {
    const auto many =
        std::count_if(axes.begin(), axes.end(), [&](const TiffAxis& a) { return a.name == name; });
    if (many < 2) continue;
    std::string sizes;
    for (const TiffAxis& axis : axes) {
      sizes = std::to_string(axis.size) + (sizes.empty() ? "" : " x ") + sizes;
    }
    refuse(what,
           "holds " + sizes +
               " planes, and its axes have no names to choose by; save one volume of them, "
               "or name the axes (Z, C and T)",
           Fault::unsupported);
  }
}

TiffPlanes shaped_planes(std::string_view json, std::uint64_t pages, const TiffPage& first,
                         const std::string& what) {
  TiffPlanes planes;
  const auto read = shape_of(json);
  if (!read) refuse(what, "its description states a shape that is none; save it as a plain TIFF");
  std::vector<std::uint64_t> shape = *read;
  std::string names = stated_axes(json);
  const auto height = static_cast<std::uint64_t>(first.image.height);
  const auto width = static_cast<std::uint64_t>(first.image.width);
  const auto fits = [&](std::size_t size) {
    return size >= 2 && shape[size - 2] == height && shape[size - 1] == width;
  };
  // One sample per pixel may be an axis of its own, the last.
  if (shape.size() > 2 && shape.back() == 1 && !fits(shape.size()) && fits(shape.size() - 1)) {
    shape.pop_back();
    if (names.size() > shape.size()) names.resize(shape.size());
  }
  if (!fits(shape.size())) {
    planes.axes = {{TiffAxisName::slices, pages}};
    planes.warnings.push_back(
        {.text =
             "its description states a shape that is not that of its pages: all pages are read as "
             "slices"});
    return planes;
  }
  if (!names.empty() && (names.size() != shape.size() || !names.ends_with("YX"))) {
    planes.warnings.push_back(
        {.text = "its description names the axes " + names + ", which are not those of its shape"});
    names.clear();
  }
  planes.axes = leading_axes(shape, shape.size() - 2, names);
  std::uint64_t product = 1;
  for (const TiffAxis& axis : planes.axes) {
    if (axis.size > (std::uint64_t{1} << 40) / product) refuse(what, "states too many planes");
    product *= axis.size;
  }
  const auto depth = static_cast<std::uint64_t>(first.depth);
  planes.behind_first = pages == 1 && product > depth && first.plain;
  if (planes.behind_first || product == pages * depth) {
    check_names(planes.axes, what);
    return planes;
  }
  if (product == 1 && depth == 1) {  // each page was saved by itself
    planes.axes = {{TiffAxisName::slices, pages}};
    return planes;
  }
  if (product > pages * depth || pages * depth % product != 0) {
    refuse(what, "states " + std::to_string(product) + " planes but holds " +
                     count_text(pages, "page", "pages") + "; fetch the file again");
  }
  // Arrays that were saved one after the other.
  planes.axes.push_back({TiffAxisName::unnamed, pages * depth / product});
  check_names(planes.axes, what);
  return planes;
}

std::string axes_text(const std::vector<TiffAxis>& axes) {
  constexpr std::array<TiffAxisName, 4> order{TiffAxisName::unnamed, TiffAxisName::channels,
                                              TiffAxisName::slices, TiffAxisName::frames};
  constexpr std::array<const char*, 4> names{"volumes (an axis without a name)", "channels",
                                             "slices", "frames"};
  std::string text;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (const TiffAxis& axis : axes) {
      if (axis.name != order[i] || axis.size == 1) continue;
      text += (text.empty() ? "" : ", ") + std::to_string(axis.size) + " " + names[i];
    }
  }
  return text;
}

std::uint64_t size_of(const std::vector<TiffAxis>& axes, TiffAxisName name) {
  for (const TiffAxis& axis : axes) {
    if (axis.name == name) return axis.size;
  }
  return 1;
}

/// What is chosen by `option` along an axis of `size`.
std::uint64_t choice(const std::optional<std::int64_t>& chosen, std::uint64_t size, Option option,
                     const std::string& what) {
  if (!chosen) return 0;
  if (*chosen >= 0 && static_cast<std::uint64_t>(*chosen) < size) {
    return static_cast<std::uint64_t>(*chosen);
  }
  throw InvalidArgument({.file = what,
                         .about = option,
                         .text = "counts from 0 to " + std::to_string(size - 1) + ": there is no " +
                                 std::to_string(*chosen)});
}

void check_that_all_are_chosen(const std::vector<TiffAxis>& axes, const FormatOptions& options,
                               const std::string& what) {
  const std::uint64_t unnamed = size_of(axes, TiffAxisName::unnamed);
  const std::uint64_t channels = size_of(axes, TiffAxisName::channels);
  const std::uint64_t frames = size_of(axes, TiffAxisName::frames);
  if (unnamed > 1 && channels > 1 && frames > 1) {
    refuse(what,
           "holds " + axes_text(axes) + ", more than isoloop can choose from; save one of them",
           Fault::unsupported);
  }
  // An axis without a name is chosen by the option that no other axis needs, or by either.
  const bool either = unnamed > 1 && channels == 1 && frames == 1;
  const bool by_frame = (frames > 1 && !options.frame) || (unnamed > 1 && channels > 1);
  const bool by_channel = (channels > 1 && !options.channel) || (unnamed > 1 && frames > 1);
  std::vector<Advice> advice;
  if (by_channel && by_frame) {
    advice = {Advice::choose_frame_and_channel};
  } else if (either) {
    advice = {Advice::choose_frame, Advice::choose_channel};
  } else if (by_frame || by_channel) {
    advice = {by_frame ? Advice::choose_frame : Advice::choose_channel};
  }
  if (advice.empty()) return;
  throw InvalidArgument({.file = what, .text = "holds " + axes_text(axes), .advice = advice},
                        by_channel ? Option::channel : Option::frame);
}

/// An axis without a name becomes that of the flag that is given, and still free.
void name_by_flag(std::vector<TiffAxis>& axes, const FormatOptions& options,
                  const std::string& what) {
  for (TiffAxis& axis : axes) {
    if (axis.name != TiffAxisName::unnamed) continue;
    const bool by_frame = options.frame && size_of(axes, TiffAxisName::frames) == 1;
    const bool by_channel = options.channel && size_of(axes, TiffAxisName::channels) == 1;
    if (by_frame && by_channel) {
      throw InvalidArgument(
          {.file = what,
           .text = "holds " + axes_text(axes) + ", of which one number chooses, not two",
           .advice = {Advice::choose_frame, Advice::choose_channel}},
          Option::frame);
    }
    if (by_frame) axis.name = TiffAxisName::frames;
    if (by_channel) axis.name = TiffAxisName::channels;
    return;
  }
}

void read_frames_as_slices(TiffPlanes& planes, const FormatOptions& options) {
  if (options.frame || size_of(planes.axes, TiffAxisName::slices) > 1) return;
  for (TiffAxis& axis : planes.axes) {
    if (axis.name != TiffAxisName::frames || axis.size == 1) continue;
    axis.name = TiffAxisName::slices;
    planes.notes.push_back(
        {.text = "its " + std::to_string(axis.size) + " frames of one slice are read as slices"});
  }
}

}  // namespace

TiffPlanes tiff_planes(const std::string& description, std::uint64_t pages, const TiffPage& first,
                       const std::string& what) {
  if (is_ome(description)) return ome_planes(description, pages, first.image, what);
  if (description.starts_with("ImageJ=")) return imagej_planes(description, pages, first, what);
  if (states_shape(description)) return shaped_planes(description, pages, first, what);
  TiffPlanes planes;
  planes.axes = {{TiffAxisName::slices, pages * static_cast<std::uint64_t>(first.depth)}};
  return planes;
}

std::vector<std::uint64_t> chosen_pages(TiffPlanes& planes, const FormatOptions& options,
                                        const std::string& what) {
  read_frames_as_slices(planes, options);
  name_by_flag(planes.axes, options, what);
  check_that_all_are_chosen(planes.axes, options, what);
  const std::uint64_t frame =
      choice(options.frame, size_of(planes.axes, TiffAxisName::frames), Option::frame, what);
  const std::uint64_t channel =
      choice(options.channel, size_of(planes.axes, TiffAxisName::channels), Option::channel, what);
  std::uint64_t first = 0;
  std::uint64_t step = 1;  // between slices
  std::uint64_t slices = 1;
  std::uint64_t stride = 1;
  for (const TiffAxis& axis : planes.axes) {
    if (axis.name == TiffAxisName::frames) first += frame * stride;
    if (axis.name == TiffAxisName::channels) first += channel * stride;
    if (axis.name == TiffAxisName::slices && axis.size > 1) {
      step = stride;
      slices = axis.size;
    }
    stride *= axis.size;
  }
  std::vector<std::uint64_t> pages(slices);
  for (std::uint64_t z = 0; z < slices; ++z) {
    const std::uint64_t plane = first + z * step;
    pages[z] = planes.pages.empty() ? plane : planes.pages[plane];
  }
  return pages;
}

}  // namespace isoloop
