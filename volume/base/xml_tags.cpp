#include "volume/base/xml_tags.h"

#include "core/base/errors.h"

namespace isoloop {
namespace {

constexpr std::string_view blanks = " \t\r\n";

[[noreturn]] void refuse(const std::string& what) {
  throw InvalidInput(
      {.file = what, .text = "its XML is damaged or cut short; fetch the file again"});
}

std::size_t past(std::string_view text, std::string_view mark, std::size_t from,
                 const std::string& what) {
  const std::size_t at = text.find(mark, from);
  if (at == std::string_view::npos) refuse(what);
  return at + mark.size();
}

std::string_view word(std::string_view text, std::size_t from) {
  const std::size_t end = text.find_first_of(" \t\r\n=/><\"'", from);
  return text.substr(from, end == std::string_view::npos ? end : end - from);
}

}  // namespace

std::optional<XmlTag> next_tag(std::string_view text, std::size_t from, const std::string& what) {
  std::size_t at = text.find('<', from);
  while (at != std::string_view::npos) {
    if (text.substr(at).starts_with("<!--")) {
      at = text.find('<', past(text, "-->", at, what));
    } else if (text.substr(at).starts_with("<?") || text.substr(at).starts_with("<!")) {
      at = text.find('<', past(text, ">", at, what));
    } else {
      break;
    }
  }
  if (at == std::string_view::npos) return std::nullopt;
  XmlTag tag{.name = {}, .attributes = {}, .begin = at};
  ++at;
  if (text.substr(at).starts_with('/')) {
    tag.name = "/";
    ++at;
  }
  const std::string_view name = word(text, at);
  if (name.empty()) refuse(what);
  tag.name += name;
  at += name.size();
  while (true) {
    at = text.find_first_not_of(blanks, at);
    if (at == std::string_view::npos) refuse(what);
    if (text[at] == '>') break;
    if (text.substr(at).starts_with("/>")) {
      tag.is_empty = true;
      ++at;
      break;
    }
    const std::string key(word(text, at));
    at = text.find_first_not_of(blanks, at + key.size());
    if (key.empty() || at == std::string_view::npos || text[at] != '=') refuse(what);
    at = text.find_first_not_of(blanks, at + 1);
    if (at == std::string_view::npos || (text[at] != '"' && text[at] != '\'')) refuse(what);
    const std::size_t end = text.find(text[at], at + 1);
    if (end == std::string_view::npos) refuse(what);
    tag.attributes[key] = text.substr(at + 1, end - at - 1);
    at = end + 1;
  }
  tag.end = at + 1;
  return tag;
}

}  // namespace isoloop
