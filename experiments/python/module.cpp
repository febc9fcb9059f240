// SPDX-License-Identifier: MIT
#include "experiments/python/module.hpp"

#include "experiments/provenance/build_name.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/store/study_file.hpp"
#include "experiments/tables/csv_line.hpp"

namespace impetus::inline python {

namespace py = pybind11;

py::object as_python(const nlohmann::json& value) {
  return py::module_::import("json").attr("loads")(value.dump());
}

nlohmann::json as_json(const py::object& value, const std::string& name) {
  const auto refuse = [&](const std::string& why) -> InputError {
    return InputError(name + ": expected what a JSON file can hold, got something else (" + why +
                      ")");
  };
  const py::cpp_function of_a_number([](const py::object& other) {  // numpy's, as of a data frame
    if (!py::hasattr(other, "item")) {
      throw py::type_error("Object of type " +
                           other.get_type().attr("__name__").cast<std::string>() +
                           " is not JSON serializable");
    }
    return other.attr("item")();
  });
  const py::dict strict(py::arg("allow_nan") = false, py::arg("default") = of_a_number);
  try {
    const py::object text = py::module_::import("json").attr("dumps")(value, **strict);
    return nlohmann::json::parse(text.cast<std::string>());
  } catch (const py::error_already_set& error) {
    if (error.matches(PyExc_ValueError) || error.matches(PyExc_TypeError) ||
        error.matches(PyExc_RecursionError)) {
      throw refuse(py::str(error.value()).cast<std::string>());
    }
    throw;
  } catch (const nlohmann::json::exception&) {
    throw refuse("half a letter: a lone surrogate");
  }
}

std::string bits_of(std::uint64_t bits) { return bits_text(static_cast<std::int64_t>(bits)); }

}  // namespace impetus::inline python

PYBIND11_MODULE(_impetus, module) {
  namespace py = pybind11;
  module.doc() = "The engine and the files of Impetus; use the package `impetus`.";
  py::register_exception<impetus::InputError>(module, "InputError", PyExc_ValueError).doc() =
      "What a user gave is wrong: one sentence naming file, place, what was expected and there.";
  py::register_exception<impetus::StoreError>(module, "StoreError", PyExc_OSError).doc() =
      "A study could not be read or written.";
  module.def("version", &impetus::version_text,
             "Which build this is, as `impetus --version` says.");
  module.def(
      "build_name", [] { return std::string(impetus::build_name()); },
      "What a recording would name as its build.");
  impetus::add_metrics(module);
  impetus::add_steps(module);
  impetus::add_trees(module);
  impetus::add_worlds(module);
  impetus::add_files(module);
  impetus::add_studies(module);
  impetus::add_pilots(module);
}
