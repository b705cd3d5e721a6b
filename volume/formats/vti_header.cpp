#include "volume/formats/vti_header.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/errors.h"
#include "volume/base/header_text.h"
#include "volume/base/refuse.h"

namespace isoloop {
namespace {

/// Without blanks and then `ending` at the end. Throws if it does not end so.
std::string_view without_ending(std::string_view text, std::string_view ending,
                                const std::string& what) {
  text = trimmed(text);
  if (!text.ends_with(ending)) refuse(what, "is cut short: it does not end with </VTKFile>");
  return text.substr(0, text.size() - ending.size());
}

void set_appended(const XmlTag& tag, std::string_view text, VtiHeader& header,
                  const std::string& what) {
  const std::string encoding = attribute(tag, "encoding", "raw");
  if (encoding != "raw" && encoding != "base64") {
    refuse(what, "its appended data is encoded as '" + encoding + "'");
  }
  header.appended_base64 = encoding == "base64";
  // Raw bytes may look like blanks: nothing is trimmed before the underscore or within.
  const std::size_t underscore = text.find('_', tag.end);
  const std::string_view body = without_ending(text, "</VTKFile>", what);
  const std::string_view data = without_ending(body, "</AppendedData>", what);
  const auto end = static_cast<std::size_t>(data.data() + data.size() - text.data());
  if (underscore == std::string_view::npos || underscore >= end) {
    refuse(what, "its appended data does not begin with an underscore");
  }
  header.appended = text.substr(underscore + 1, end - underscore - 1);
}

/// Takes the tags one by one.
class Parser {
 public:
  Parser(std::string_view text, const std::string& what) : text_(text), what_(what) {}

  VtiHeader parse() {
    std::size_t at = 0;
    bool closed = false;
    while (!closed) {
      const std::optional<XmlTag> tag = next_tag(text_, at, what_);
      if (!tag) refuse(what_, "is cut short: it does not end with </VTKFile>");
      at = take(*tag);
      closed = tag->name == "/VTKFile" || tag->name == "AppendedData";
    }
    if (header_.image.name.empty()) refuse(what_, "holds no image data");
    if (header_.appended.data() == nullptr) without_ending(text_, "</VTKFile>", what_);
    return header_;
  }

 private:
  std::size_t take(const XmlTag& tag) {
    if (header_.file.name.empty() && tag.name != "VTKFile") refuse(what_, "is no VTK file");
    if (tag.name == "VTKFile") {
      if (attribute(tag, "type", "") != "ImageData") {
        refuse(what_, "holds " + attribute(tag, "type", "nothing known") + ", not ImageData",
               Fault::unsupported);
      }
      header_.file = tag;
    } else if (tag.name == "ImageData") {
      header_.image = tag;
    } else if (tag.name == "Piece") {
      if (++pieces_ > 1) refuse(what_, "holds several pieces; save it as one", Fault::unsupported);
      if (words_of(attribute(tag, "Extent", "")) !=
          words_of(attribute(header_.image, "WholeExtent", ""))) {
        refuse(what_, "holds a piece that is not the whole");
      }
    } else if (tag.name == "PointData" || tag.name == "CellData") {
      const bool of_points = tag.name == "PointData";
      if (!tag.is_empty) site_ = of_points ? VtiSite::points : VtiSite::cells;
      (of_points ? header_.active_points : header_.active_cells) = attribute(tag, "Scalars", "");
    } else if (tag.name == "/PointData" || tag.name == "/CellData") {
      site_.reset();
    } else if (tag.name == "DataArray") {
      return take_array(tag);
    } else if (tag.name == "AppendedData") {
      set_appended(tag, text_, header_, what_);
    }
    return tag.end;
  }

  std::size_t take_array(const XmlTag& tag) {
    VtiArray array{.tag = tag};
    std::size_t end = tag.end;
    if (!tag.is_empty) {
      const std::size_t close = text_.find("</DataArray>", tag.end);
      if (close == std::string_view::npos) refuse(what_, "is cut short within an array");
      array.text = text_.substr(tag.end, close - tag.end);
      // Statistics may stand within, as elements of their own.
      array.text = array.text.substr(0, array.text.find('<'));
      end = close;
    }
    if (site_) {
      array.site = *site_;
      header_.arrays.push_back(array);
    }
    return end;
  }

  std::string_view text_;
  const std::string& what_;
  VtiHeader header_;
  int pieces_ = 0;
  std::optional<VtiSite> site_;  // whose arrays stand here
};

std::string prefix_of(VtiSite site) { return site == VtiSite::points ? "points:" : "cells:"; }

/// The arrays that `wanted` may mean.
std::vector<const VtiArray*> arrays_called(const VtiHeader& header, const std::string& wanted) {
  std::vector<const VtiArray*> found;
  for (const VtiArray& array : header.arrays) {
    if (array.name() == wanted) found.push_back(&array);
  }
  if (!found.empty()) return found;
  for (const VtiArray& array : header.arrays) {
    if (prefix_of(array.site) + array.name() == wanted) found.push_back(&array);
  }
  return found;
}

/// The arrays that may be meant where none is named: the active one, or all, of points or of cells;
/// those of both where the file holds both.
std::vector<const VtiArray*> unnamed_arrays(const VtiHeader& header) {
  std::vector<const VtiArray*> all;
  std::vector<const VtiArray*> active;
  for (const VtiArray& array : header.arrays) {
    if (array.name() == "vtkGhostType") continue;  // marks points or cells to leave out
    all.push_back(&array);
    const bool of_points = array.site == VtiSite::points;
    const std::string& name = of_points ? header.active_points : header.active_cells;
    if (!name.empty() && array.name() == name) active.push_back(&array);
  }
  const bool of_one_site = std::all_of(all.begin(), all.end(), [&](const VtiArray* array) {
    return array->site == all.front()->site;
  });
  return of_one_site && !active.empty() ? active : all;
}

std::string list_of(const VtiHeader& header) {
  std::array<std::string, 2> names;
  for (const VtiArray& array : header.arrays) {
    std::string& list = names[array.site == VtiSite::points ? 0 : 1];
    list += (list.empty() ? "'" : ", '") + array.name() + "'";
  }
  const std::string points = names[0].empty() ? "" : "of points " + names[0];
  const std::string cells = names[1].empty() ? "" : "of cells " + names[1];
  return points + (points.empty() || cells.empty() ? "" : "; ") + cells;
}

}  // namespace

std::string VtiArray::name() const { return attribute(tag, "Name", ""); }

std::string attribute(const XmlTag& tag, const std::string& name, const std::string& missing) {
  const auto found = tag.attributes.find(name);
  return found == tag.attributes.end() ? missing : found->second;
}

VtiHeader parse_vti_header(std::string_view text, const std::string& what) {
  return Parser(text, what).parse();
}

const VtiArray& choose_array(const VtiHeader& header, const std::string& wanted,
                             const std::string& what) {
  if (header.arrays.empty()) refuse(what, "holds no data of points or cells");
  const std::vector<const VtiArray*> found =
      wanted.empty() ? unnamed_arrays(header) : arrays_called(header, wanted);
  if (found.size() == 1) return *found.front();
  const bool is_shared = !wanted.empty() && found.size() > 1;
  throw InvalidArgument({.file = what,
                         .text = is_shared ? "has points:" + wanted + " and cells:" + wanted
                                           : (wanted.empty() ? "holds several arrays, "
                                                             : "no array is called '" + wanted +
                                                                   "'; it holds those ") +
                                                 list_of(header),
                         .advice = {Advice::choose_grid}},
                        Option::grid);
}

}  // namespace isoloop
