// The surface alone, for the tools that people have.
#pragma once

#include <ostream>
#include <string>

#include "tools/runs/run_result.h"

namespace isoloop {

/// The writer for the file's extension: .ply, .obj, .stl or .vtp. Throws InvalidArgument for
/// another. Each file names the frame in a comment of its head; triangles are counter-clockwise
/// seen from outside.
LoopsReport surface_report(const std::string& name);

void write_surface_obj(std::ostream& out, const LoopsRun& run);

/// Binary. Its head has 80 characters, no more.
void write_surface_stl(std::ostream& out, const LoopsRun& run);

/// Binary, in base64. Point data: "component".
void write_surface_vtp(std::ostream& out, const LoopsRun& run);

}  // namespace isoloop
