// The files of tools/viewer, as they were when the program was built.
#pragma once

#include <span>
#include <string_view>

namespace isoloop {

/// The page, with {{title}}, {{plot}}, {{data}} and {{viewer}} where these go; in pieces, since
/// compilers limit how long a text may be.
std::span<const std::string_view> viewer_page();

/// The script, three.js included; in pieces.
std::span<const std::string_view> viewer_script();

}  // namespace isoloop
