// What a .vti file says before and between its numbers: its image, its arrays, where they are.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "volume/base/xml_tags.h"

namespace isoloop {

enum class VtiSite { points, cells };

/// One array: what its tag says, and the text up to the closing tag.
struct VtiArray {
  XmlTag tag{};
  std::string_view text{};
  VtiSite site = VtiSite::points;

  std::string name() const;
};

struct VtiHeader {
  XmlTag file{};
  XmlTag image{};
  std::string active_points{};  // name of the active scalars, or empty
  std::string active_cells{};
  std::vector<VtiArray> arrays{};
  std::string_view appended{};  // after the underscore, before the closing tag
  bool appended_base64 = false;
};

/// The value of an attribute, `missing` if the tag has none of that name.
std::string attribute(const XmlTag& tag, const std::string& name, const std::string& missing);

/// Reads the tags of a whole file, which the header refers to. Throws InvalidInput, opening with
/// `what`: XML that is damaged or cut, data that are no image of one piece.
VtiHeader parse_vti_header(std::string_view text, const std::string& what);

/// The array called `wanted`: NAME, or points:NAME or cells:NAME where both have it. Without a name
/// the active array of a file that holds points or cells alone, else the only array. Throws
/// InvalidArgument, listing the arrays, if that is not one, and InvalidInput if there is none.
const VtiArray& choose_array(const VtiHeader& header, const std::string& wanted,
                             const std::string& what);

}  // namespace isoloop
