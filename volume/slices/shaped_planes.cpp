#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/base/errors.h"
#include "volume/base/header_text.h"
#include "volume/base/refuse.h"
#include "volume/slices/stated_planes.h"

namespace isoloop {
namespace {

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

}  // namespace

bool states_shape(std::string_view description) {
  return description.starts_with("shape=(") ||
         (description.starts_with("{") && description.find("\"shape\":") != std::string_view::npos);
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

}  // namespace isoloop
