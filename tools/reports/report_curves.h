// The loops as curves, for the tools that people have.
#pragma once

#include <ostream>
#include <string>

#include "tools/runs/run_result.h"

namespace isoloop {

/// The writer for the file's extension: .vtp, .obj or .mrk.json. Throws InvalidArgument for
/// another.
LoopsReport curves_report(const std::string& name);

/// A VTK file of closed polylines, the first point joined again at the end. Cell data: "loop" (its
/// id), "kind" (0 handle, 1 tunnel, 2 loop), "size" (-1: infinite) and "length".
void write_curves_vtp(std::ostream& out, const LoopsRun& run);

/// A Wavefront file: an object for each loop, a polyline for each of its curves.
void write_curves_obj(std::ostream& out, const LoopsRun& run);

/// Markups of 3D Slicer, schema 1.0.3: a ClosedCurve for each curve, coloured by kind. Frames other
/// than RAS are given as LPS, since the schema knows no others.
void write_curves_mrk(std::ostream& out, const LoopsRun& run);

}  // namespace isoloop
