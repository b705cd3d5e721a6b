// The runs of count, loops, scan, repair and view on an array: what Python's functions call.
#pragma once

#include <pybind11/pybind11.h>

namespace isoloop::python {

void bind_runs(pybind11::module_& module);

}  // namespace isoloop::python
