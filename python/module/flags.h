// What the keyword arguments of Python's functions fill: the flags of the command, as typed there.
#pragma once

#include <pybind11/pybind11.h>

namespace isoloop::python {

void bind_flags(pybind11::module_& module);

}  // namespace isoloop::python
