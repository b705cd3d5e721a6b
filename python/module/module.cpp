// isoloop._core: what the Python package is made of. Its functions take what the package has
// already put in order, and are no interface of their own.
#include <pybind11/pybind11.h>

#include "python/module/errors.h"
#include "python/module/flags.h"
#include "python/module/input.h"
#include "python/module/results.h"
#include "python/module/runs.h"
#include "python/module/watched.h"

PYBIND11_MODULE(_core, module) {
  namespace python = isoloop::python;
  module.doc() = "The workings of the package isoloop.";
  module.attr("version") = ISOLOOP_VERSION;
  python::translate_errors();
  python::bind_flags(module);
  python::bind_input(module);
  python::bind_results(module);
  python::bind_runs(module);
  pybind11::module_::import("atexit").attr("register")(
      pybind11::cpp_function(&python::end_leftovers));
}
