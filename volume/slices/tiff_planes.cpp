#include "volume/slices/tiff_planes.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/errors.h"
#include "volume/base/refuse.h"
#include "volume/slices/ome_planes.h"
#include "volume/slices/stated_planes.h"

namespace isoloop {
namespace {

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
