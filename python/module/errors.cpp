#include "python/module/errors.h"

#include <exception>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "core/base/errors.h"
#include "tools/words/exit_code.h"
#include "tools/words/sentence.h"

namespace isoloop::python {
namespace {

namespace py = pybind11;

const char* fault_text(Fault fault) {
  switch (fault) {
    case Fault::damaged:
      return "damaged";
    case Fault::unreadable:
      return "unreadable";
    case Fault::unsupported:
      return "unsupported";
    case Fault::not_finite:
      return "not finite";
    case Fault::unwritable:
      return "unwritable";
  }
  return "damaged";
}

const char* unit_text(Excess::Unit unit) {
  if (unit == Excess::Unit::none) return "";
  return unit == Excess::Unit::bytes ? "bytes" : "voxels";
}

py::dict data_of(const Finding& finding, Option option) {
  std::vector<std::string> advice;
  for (const Advice each : finding.advice) advice.push_back(advice_text({each}));
  py::dict data;
  data["file"] = finding.file;
  data["place"] = finding.place;
  data["text"] = finding.text;
  data["advice"] = advice;
  data["option"] = flag_of(option == Option::none ? finding.about : option);
  return data;
}

/// The attributes, of errors that have some.
py::dict attributes_of(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const InvalidArgument& e) {
    return data_of(e.finding, e.option);
  } catch (const InvalidInput& e) {
    py::dict data = data_of(e.finding, Option::none);
    data["fault"] = fault_text(e.fault);
    return data;
  } catch (const LimitExceeded& e) {
    py::dict data = data_of(e.finding, Option::none);
    data["unit"] = unit_text(e.excess.unit);
    data["needed"] = e.excess.needed;
    data["limit"] = e.excess.limit;
    data["stage"] = e.excess.stage;
    return data;
  } catch (...) {
    return {};
  }
}

void raise(const std::exception_ptr& error) {
  const Failure failure = failure_of(error);
  const py::object made = py::module_::import("isoloop._errors")
                              .attr("error_of")(static_cast<int>(failure.code), failure.sentence,
                                                **attributes_of(error));
  PyErr_SetObject(py::type::handle_of(made).ptr(), made.ptr());
}

}  // namespace

void translate_errors() {
  py::register_local_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const Error&) {
      raise(error);
    } catch (const SelfCheckFailed&) {
      raise(error);
    } catch (const std::bad_alloc&) {
      raise(error);
    } catch (const std::system_error&) {
      raise(error);
    }
  });
}

}  // namespace isoloop::python
