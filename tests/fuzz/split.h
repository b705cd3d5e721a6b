// Inputs that stand for two files: a header, and the voxels that follow it.
#pragma once

#include <string_view>
#include <utility>

namespace isoloop::fuzz {

/// The bytes up to and with the first `end`, and those after it; without `end`, all and none.
inline std::pair<std::string_view, std::string_view> split_after(std::string_view bytes,
                                                                 std::string_view end) {
  const std::size_t at = bytes.find(end);
  if (at == std::string_view::npos) return {bytes, {}};
  return {bytes.substr(0, at + end.size()), bytes.substr(at + end.size())};
}

}  // namespace isoloop::fuzz
