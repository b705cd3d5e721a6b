// What runs found, as arrays and text that Python's classes are made of.
#pragma once

#include <pybind11/pybind11.h>

namespace isoloop::python {

void bind_results(pybind11::module_& module);

}  // namespace isoloop::python
