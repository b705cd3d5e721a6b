#include "volume/slices/ome_planes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string_view>

#include "volume/base/header_text.h"
#include "volume/base/refuse.h"
#include "volume/base/xml_tags.h"
#include "volume/voxels/length_unit.h"

namespace isoloop {
namespace {

constexpr std::uint64_t no_page = std::numeric_limits<std::uint64_t>::max();

std::string attribute(const XmlTag& tag, const std::string& name) {
  const auto found = tag.attributes.find(name);
  return found == tag.attributes.end() ? std::string() : found->second;
}

/// What an OME-XML text says of one image.
struct OmeImage {
  XmlTag pixels{};
  std::vector<XmlTag> blocks{};   // TiffData
  std::set<std::string> files{};  // that hold its planes, by their identifiers or names
  bool interleaved = false;
};

/// Without the prefix of a name space, "ome:Pixels".
std::string local_name(const std::string& name) {
  const std::size_t colon = name.find(':');
  if (colon == std::string::npos) return name;
  const std::size_t first = name.starts_with('/') ? 1 : 0;
  return std::string(name).erase(first, colon + 1 - first);
}

OmeImage image_of(const std::string& xml, const std::string& what) {
  OmeImage image;
  int images = 0;
  std::size_t at = 0;
  bool closed = false;
  while (!closed) {
    const std::optional<XmlTag> tag = next_tag(xml, at, what);
    if (!tag) refuse(what, "its OME-XML is cut short: it does not end with </OME>");
    at = tag->end;
    const std::string name = local_name(tag->name);
    closed = name == "/OME" || (name == "OME" && tag->is_empty);
    if (name == "BinaryOnly") {
      refuse(what,
             "is one of several files of an OME-TIFF (its description is in " +
                 attribute(*tag, "MetadataFile") + "); save it as one file",
             Fault::unsupported);
    }
    if (name == "Pixels") {
      image.pixels = *tag;
      ++images;
    }
    if (name == "TiffData") image.blocks.push_back(*tag);
    if (name == "UUID") {
      const std::size_t end = xml.find('<', at);
      const std::string_view text = trimmed(std::string_view(xml).substr(at, end - at));
      image.files.insert(text.empty() ? attribute(*tag, "FileName") : std::string(text));
    }
    const std::string samples = attribute(*tag, "SamplesPerPixel");
    if (name == "Channel" && !samples.empty() && samples != "1") image.interleaved = true;
  }
  if (images == 0) refuse(what, "its OME-XML describes no pixels; save it as a plain TIFF");
  if (images > 1) {
    refuse(what,
           "holds " + std::to_string(images) +
               " images (positions or resolutions); save one of them as a file of its own",
           Fault::unsupported);
  }
  return image;
}

std::uint64_t number_in(const XmlTag& tag, const std::string& name, std::uint64_t missing,
                        std::uint64_t most, const std::string& what) {
  const std::string text = attribute(tag, name);
  if (text.empty()) return missing;
  const auto number = whole_number_of(text);
  if (!number || *number < 0 || static_cast<std::uint64_t>(*number) > most) {
    refuse(what, "its OME-XML states " + name + " " + text.substr(0, 40) +
                     ", which does not fit the pages that it holds; fetch the file again");
  }
  return static_cast<std::uint64_t>(*number);
}

/// Slices, channels and frames in the order of DimensionOrder.
std::vector<TiffAxis> axes_of(const XmlTag& pixels, std::uint64_t pages, const std::string& what) {
  const std::string order = attribute(pixels, "DimensionOrder");
  std::string sorted = order;
  std::sort(sorted.begin(), sorted.end());
  if (!order.starts_with("XY") || sorted != "CTXYZ") {
    refuse(what, "its OME-XML states the order '" + order.substr(0, 40) +
                     "' of dimensions, which is none; save it as a plain TIFF");
  }
  std::vector<TiffAxis> axes;
  for (const char letter : order.substr(2)) {
    const TiffAxisName name = letter == 'Z'   ? TiffAxisName::slices
                              : letter == 'C' ? TiffAxisName::channels
                                              : TiffAxisName::frames;
    const std::uint64_t size = number_in(pixels, std::string("Size") + letter, 0, pages, what);
    if (size == 0) refuse(what, std::string("its OME-XML does not state Size") + letter);
    axes.push_back({name, size});
  }
  return axes;
}

/// The planes that a TiffData element is for get their pages.
void place_block(const XmlTag& block, std::uint64_t pages, TiffPlanes& planes,
                 const std::string& what) {
  const std::uint64_t page = number_in(block, "IFD", 0, pages - 1, what);
  std::uint64_t plane = 0;
  std::uint64_t stride = 1;
  for (const TiffAxis& axis : planes.axes) {
    const char* first = axis.name == TiffAxisName::slices     ? "FirstZ"
                        : axis.name == TiffAxisName::channels ? "FirstC"
                                                              : "FirstT";
    plane += stride * number_in(block, first, 0, axis.size - 1, what);
    stride *= axis.size;
  }
  const bool one = block.attributes.count("IFD") > 0;
  const std::uint64_t all = std::min(pages - page, planes.pages.size() - plane);
  const std::uint64_t count = number_in(block, "PlaneCount", one ? 1 : all, all, what);
  for (std::uint64_t i = 0; i < count; ++i) {
    if (planes.pages[plane + i] != no_page) {
      refuse(what, "its OME-XML puts plane " + std::to_string(plane + i) +
                       " on two pages; save it as a plain TIFF");
    }
    planes.pages[plane + i] = page + i;
  }
}

void place_planes(const OmeImage& image, std::uint64_t pages, TiffPlanes& planes,
                  const std::string& what) {
  std::uint64_t count = 1;
  for (const TiffAxis& axis : planes.axes) count *= axis.size;  // each at most a million
  if (count > pages) {
    refuse(what, "states " + std::to_string(count) + " planes but holds " + std::to_string(pages) +
                     (pages == 1 ? " page" : " pages") +
                     "; fetch the file again, or all files of it");
  }
  planes.pages.assign(count, no_page);
  if (image.blocks.empty()) {
    for (std::uint64_t i = 0; i < count; ++i) planes.pages[i] = i;
  }
  for (const XmlTag& block : image.blocks) place_block(block, pages, planes, what);
  const auto missing = std::find(planes.pages.begin(), planes.pages.end(), no_page);
  if (missing != planes.pages.end()) {
    refuse(what, "its OME-XML puts plane " + std::to_string(missing - planes.pages.begin()) +
                     " on no page; save it as a plain TIFF");
  }
  const std::set<std::uint64_t> used(planes.pages.begin(), planes.pages.end());
  if (used.size() < planes.pages.size()) {
    refuse(what, "its OME-XML puts two planes on one page; save it as a plain TIFF");
  }
  if (used.size() < pages) {
    planes.warnings.push_back(
        {.text = std::to_string(pages - used.size()) +
                 " of its pages are no planes of its image: they are not read"});
  }
}

/// PhysicalSizeX, Y and Z in the unit of the first that is stated.
void set_spacing(const XmlTag& pixels, TiffPlanes& planes) {
  Vec3 spacing{};
  std::optional<LengthUnit> unit;
  const auto give_up = [&](const std::string& why) {
    planes.warnings.push_back({.text = why + ": 1 is taken", .advice = {Advice::override_spacing}});
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name = std::string("PhysicalSize") + "XYZ"[axis];
    const std::string size = attribute(pixels, name);
    if (size.empty()) continue;
    const double length = number_of(size).value_or(0.0);
    if (!is_spacing(length)) return give_up(name + " is no length");
    const std::string spelling = attribute(pixels, name + "Unit");
    const auto own = length_unit(spelling.empty() ? "um" : spelling);
    if (!own) return give_up("lengths are in '" + spelling.substr(0, 40) + "'");
    if (!unit) unit = own;
    spacing[axis] = own->name == unit->name ? length : length * (own->metres / unit->metres);
  }
  if (!unit) return;
  constexpr std::array<std::size_t, 3> in_its_place{1, 0, 0};
  constexpr std::array<const char*, 3> names{"x", "y", "z"};
  const Vec3 stated = spacing;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (stated[axis] > 0.0) continue;
    const std::size_t other = stated[in_its_place[axis]] > 0.0 ? in_its_place[axis] : 2;
    spacing[axis] = stated[other] > 0.0 ? stated[other] : stated[1];
    if (axis == 2 && attribute(pixels, "SizeZ") == "1") continue;
    planes.warnings.push_back({.text = std::string("it states no spacing along ") + names[axis] +
                                       ": that of another axis is taken",
                               .advice = {Advice::override_spacing}});
  }
  if (!std::all_of(spacing.begin(), spacing.end(), is_spacing)) return give_up("no lengths");
  planes.spacing = spacing;
  planes.unit = unit->name;
}

}  // namespace

bool is_ome(const std::string& description) {
  const std::string_view text = trimmed(description);
  if (!text.starts_with("<")) return false;
  return text.find("<OME") != std::string_view::npos || text.find(":OME") != std::string_view::npos;
}

TiffPlanes ome_planes(const std::string& description, std::uint64_t pages, const SliceImage& image,
                      const std::string& what) {
  const OmeImage ome = image_of(description, what);
  if (ome.interleaved || lower_case(attribute(ome.pixels, "Interleaved")) == "true") {
    refuse(what,
           "holds channels that are interleaved (several samples per pixel); save it with "
           "one channel to a page",
           Fault::unsupported);
  }
  if (ome.files.size() > 1) {
    refuse(what,
           "is one of " + std::to_string(ome.files.size()) +
               " files of an OME-TIFF; save it as one file",
           Fault::unsupported);
  }
  TiffPlanes planes;
  planes.axes = axes_of(ome.pixels, pages, what);
  place_planes(ome, pages, planes, what);
  constexpr std::uint64_t any = std::numeric_limits<std::int64_t>::max();
  if (number_in(ome.pixels, "SizeX", 0, any, what) != static_cast<std::uint64_t>(image.width) ||
      number_in(ome.pixels, "SizeY", 0, any, what) != static_cast<std::uint64_t>(image.height)) {
    planes.warnings.push_back({.text = "its OME-XML states another size than its pages have"});
  }
  set_spacing(ome.pixels, planes);
  return planes;
}

}  // namespace isoloop
