// How the reports write JSON: a member a line, and a list an item a line.
#pragma once

#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

namespace isoloop {

/// Bytes that are no UTF-8 are replaced: a file's name may hold any.
inline std::string line_of(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// Of an object that has a member already.
inline void write_member(std::ostream& out, const char* name, const nlohmann::ordered_json& value) {
  out << ",\n  \"" << name << "\": " << line_of(value);
}

/// The same of a member that is a list of to_json(item).
template <class Items, class ToJson>
void write_list(std::ostream& out, const char* name, const Items& items, const ToJson& to_json) {
  out << ",\n  \"" << name << "\": [";
  const char* separator = "\n    ";
  for (const auto& item : items) {
    out << separator << line_of(to_json(item));
    separator = ",\n    ";
  }
  out << (items.empty() ? "]" : "\n  ]");
}

}  // namespace isoloop
