// The tags of a small XML text, in order: all that .vti headers need.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace isoloop {

struct XmlTag {
  std::string name;  // "/name" of a closing tag
  std::map<std::string, std::string> attributes;
  bool is_empty = false;  // <name/>
  std::size_t begin = 0;  // of '<' in the text
  std::size_t end = 0;    // after '>'
};

/// The first tag at or after `from`; comments and the declaration are passed over. Nothing if there
/// is none. Throws InvalidInput, opening with `what`, for a tag that is damaged or cut short.
std::optional<XmlTag> next_tag(std::string_view text, std::size_t from, const std::string& what);

}  // namespace isoloop
