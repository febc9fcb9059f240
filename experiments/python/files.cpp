// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <optional>
#include <utility>

#include "experiments/files/protocol_files.hpp"
#include "experiments/files/scene_files.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/protocol_page.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/python/module.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline python {
namespace {

namespace py = pybind11;
using nlohmann::json;

/// What Python wrote becomes a document of this name; the text is what a file of it would hold.
JsonDocument document_of(const py::object& value, const std::string& name) {
  return parse_json(name, as_json(value, name).dump(2) + "\n");
}

Protocol protocol_of(const py::object& value, const std::string& path,
                     const std::optional<py::object>& scene) {
  std::optional<JsonDocument> own;
  if (scene) {
    own = document_of(*scene, "the scene of " + path);
  }
  return protocol_from(document_of(value, path), path, std::move(own));
}

/// The condition that names each factor once. Throws InputError.
Condition condition_of(const Protocol& protocol, const py::object& levels) {
  const json wanted = as_json(levels, "condition");
  std::string shown;
  for (const Condition& cell : cells(protocol.design)) {
    if (to_json(cell) == wanted) {
      return cell;
    }
    shown += (shown.empty() ? "" : ", ") + to_json(cell).dump();
  }
  throw InputError(protocol.document.name + ": expected one of its conditions (" + shown +
                   "), got " + wanted.dump());
}

py::list conditions(const Protocol& protocol) {
  py::list all;
  for (const Condition& cell : cells(protocol.design)) {
    all.append(as_python(to_json(cell)));
  }
  return all;
}

py::list plan(const Protocol& protocol, const std::string& participant, std::uint64_t seed) {
  py::list trials;
  for (const PlannedTrial& trial : plan_for(protocol, participant, seed)) {
    py::dict one;
    one["slot"] = trial.slot;
    one["phase"] = std::string(name_of(trial.phase));
    one["repetition"] = trial.repetition;
    one["block"] = trial.block;
    one["catch"] = trial.catch_trial;
    one["condition"] = as_python(to_json(trial.condition));
    one["seed"] = trial.seed;
    trials.append(std::move(one));
  }
  return trials;
}

py::object protocol_world(const Protocol& protocol, const py::object& levels, std::uint64_t seed) {
  const Condition condition = condition_of(protocol, levels);
  PlannedTrial trial;
  trial.condition = condition;
  trial.seed = seed;
  return world_of(ProtocolScenes(protocol, kUnroundedHold).stage(trial, assumed_screen()), seed);
}

/// With the files that it names held in it; its own rules are still to be looked at.
JsonDocument scene_of(const py::object& value, const std::string& path) {
  return with_files(document_of(value, path), path);
}

/// Checked and staged with the same bodies.
py::object scene_world(const JsonDocument& scene, std::uint64_t seed) {
  ShapeLibrary shapes;
  require_scene(scene, shapes);
  return world_of(staged_from(scene,
                              [&] {
                                return build_scene(scene.value, assumed_screen(), kUnroundedHold,
                                                   shapes, "preview", seed);
                              }),
                  seed);
}

}  // namespace

void add_files(py::module_& module) {
  py::class_<Protocol, std::shared_ptr<Protocol>>(module, "Protocol", "A protocol with its scene.")
      .def_property_readonly(
          "name", [](const Protocol& p) { return p.name; },
          "By which orders of trials and analyses go.")
      .def_property_readonly(
          "title", [](const Protocol& p) { return p.title; }, "For people.")
      .def_property_readonly(
          "hash", [](const Protocol& p) { return p.hash; },
          "Of both documents; white space does not count.")
      .def_property_readonly(
          "document", [](const Protocol& p) { return as_python(p.document.value); },
          "As its file has it.")
      .def_property_readonly(
          "scene", [](const Protocol& p) { return as_python(p.scene.value); },
          "With the meshes and figures that it names held in it.")
      .def("conditions", &conditions, "The design's cells, each a dictionary of levels.")
      .def("plan", &plan, py::arg("participant") = "P01", py::arg("seed") = 1,
           "The trials that a participant would be shown, in order.")
      .def(
          "page", [](const Protocol& p) { return protocol_page(p); },
          "The study explained whole, in Markdown.")
      .def(
          "check_frames",
          [](const Protocol& p, double refresh_hz, bool allow_rounding) {
            if (!(refresh_hz >= 20.0 && refresh_hz <= 1000.0)) {
              throw py::value_error("refresh_hz: expected 20 to 1000 Hz, got " +
                                    exact_number(refresh_hz));
            }
            check_frames(p, refresh_hz, allow_rounding);
          },
          py::arg("refresh_hz") = 60.0, py::arg("allow_rounding") = false,
          "Raises InputError where a time is no whole number of the display's frames.")
      .def("world", &protocol_world, py::arg("condition"), py::arg("seed") = 1,
           "The world of a condition at its start, before a screen of 37.6 cm by 30.1 cm seen\n"
           "from 57 cm.");
  module.def("load_protocol", [](const std::string& path) {
    return std::make_shared<Protocol>(load_protocol(path));
  });
  module.def("make_protocol", [](const py::object& value, const std::string& path,
                                 const std::optional<py::object>& scene) {
    return std::make_shared<Protocol>(protocol_of(value, path, scene));
  });
  module.def("load_scene",
             [](const std::string& path) { return as_python(load_scene(path).value); });
  module.def("make_scene", [](const py::object& value, const std::string& path) {
    const JsonDocument scene = scene_of(value, path);
    require_scene(scene);
    return as_python(scene.value);
  });
  module.def("scene_world",
             [](const py::object& value, const std::string& path, std::uint64_t seed) {
               return scene_world(scene_of(value, path), seed);
             });
  module.def("load_scene_world", [](const std::string& path, std::uint64_t seed) {
    return scene_world(read_scene(path), seed);
  });
}

}  // namespace impetus::inline python
