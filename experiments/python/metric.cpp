// SPDX-License-Identifier: MIT
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <cmath>
#include <utility>

#include "engine/scheduling/metrics.hpp"
#include "experiments/python/module.hpp"

namespace impetus::inline python {
namespace {

namespace py = pybind11;

/// What a metric written in Python is given.
struct PairOfPython {
  PairBounds bounds;
  Viewer viewer;
  Fixation fixation;
};

/// Measures pairs by a function of Python's, for as long as the world lives that has it.
class FunctionMetric final : public PriorityMetric {
 public:
  FunctionMetric(py::function measure, Urgent urgent)
      : PriorityMetric(urgent), measure_(std::move(measure)) {}

  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& fixation) const override {
    const auto measured = measure_(PairOfPython{bounds, viewer, fixation}).cast<double>();
    if (!std::isfinite(measured)) {
      throw py::value_error("a metric: expected a finite number for every pair, got " +
                            std::to_string(measured));
    }
    return measured;
  }

 private:
  py::function measure_;
};

}  // namespace

std::shared_ptr<const PriorityMetric> metric_of_function(py::function measure,
                                                         const std::string& urgent) {
  if (urgent != "large" && urgent != "small") {
    throw py::value_error("urgent: expected \"large\" or \"small\", got \"" + urgent + "\"");
  }
  return std::make_shared<FunctionMetric>(std::move(measure),
                                          urgent == "large" ? Urgent::kLarge : Urgent::kSmall);
}

void put_metric(World& world, std::shared_ptr<const PriorityMetric> metric) {
  Schedule schedule = world.settings().schedule;
  schedule.metric = std::move(metric);
  world.set_schedule(std::move(schedule));
}

void add_metrics(py::module_& module) {
  py::class_<PairOfPython>(module, "Pair",
                           "What a metric may look at: two bodies, or one and a "
                           "wall, and the viewer (metres, m/s, world).")
      .def_property_readonly(
          "a", [](const PairOfPython& p) { return p.bounds.pair.a; }, "Index of the first body.")
      .def_property_readonly(
          "b", [](const PairOfPython& p) { return p.bounds.pair.b; },
          "Index of the second; below 0: the walls.")
      .def_property_readonly(
          "centre_a", [](const PairOfPython& p) { return p.bounds.a.centre; },
          "Of the sphere about the first body.")
      .def_property_readonly(
          "centre_b", [](const PairOfPython& p) { return p.bounds.b.centre; },
          "Of that about the second.")
      .def_property_readonly(
          "radius_a", [](const PairOfPython& p) { return p.bounds.a.radius_m; },
          "Of the sphere about the first body (m).")
      .def_property_readonly(
          "radius_b", [](const PairOfPython& p) { return p.bounds.b.radius_m; },
          "Of that about the second (m).")
      .def_property_readonly(
          "velocity_a", [](const PairOfPython& p) { return p.bounds.velocity_a; }, "m/s.")
      .def_property_readonly(
          "velocity_b", [](const PairOfPython& p) { return p.bounds.velocity_b; }, "m/s.")
      .def_property_readonly(
          "fit_error_m", [](const PairOfPython& p) { return p.bounds.fit_error_m; },
          "How far both trees together reach beyond the surfaces, at most.")
      .def_property_readonly(
          "place", [](const PairOfPython& p) { return collision_place(p.bounds); },
          "Where the bounds meet.")
      .def_property_readonly(
          "eye", [](const PairOfPython& p) { return p.viewer.eye; }, "Where the viewer's eye is.")
      .def_property_readonly(
          "fixation_m",
          [](const PairOfPython& p) -> py::object {
            return p.fixation ? py::object(py::make_tuple(p.fixation->x_m, p.fixation->y_m))
                              : py::object(py::none());
          },
          "Where the viewer looks, right of and above the screen's centre; None: not known.");
  module.def("metric_names", [] {
    std::vector<std::string> names;
    for (const std::string_view name : metric_names()) {
      names.emplace_back(name);
    }
    return names;
  });
}

}  // namespace impetus::inline python
