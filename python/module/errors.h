// The errors of isoloop as exceptions of Python.
#pragma once

namespace isoloop::python {

/// From now on the four errors, and a lack of memory, are raised as the classes of
/// isoloop/_errors.py, with what happened as attributes.
void translate_errors();

}  // namespace isoloop::python
