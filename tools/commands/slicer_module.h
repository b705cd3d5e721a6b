// isoloop as a command-line module of 3D Slicer: what --xml prints, and how Slicer calls.
#pragma once

#include <string>
#include <vector>

namespace isoloop {

/// The descriptor that Slicer makes a dialogue of: an <executable> of its execution model, whose
/// flags are those of `isoloop loops`.
std::string slicer_descriptor();

/// Slicer names no command: arguments with --slicer are those of `loops`. Others are as they were.
std::vector<std::string> with_slicer_command(const std::vector<std::string>& arguments);

}  // namespace isoloop
