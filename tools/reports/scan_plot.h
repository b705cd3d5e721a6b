// The counts at many iso values, as a picture.
#pragma once

#include <ostream>

#include "tools/runs/run_result.h"

namespace isoloop {

/// An SVG of its own, light or dark as the reader's screen: b0, b1 and b2 over the iso value, the
/// counts on a scale of log(1 + n), the widest meaningful plateaus shaded, the proposed iso value
/// as an upright line.
void write_scan_svg(std::ostream& out, const Scan& scan, InsideRule inside);

}  // namespace isoloop
