// SPDX-License-Identifier: MIT
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/scheduling/metrics.hpp"
#include "engine/trees/volume_tree.hpp"
#include "engine/volumes/volume.hpp"
#include "engine/world/world.hpp"
#include "experiments/python/module.hpp"
#include "experiments/record/wall_names.hpp"
#include "experiments/run/scene_run.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline python {
namespace {

namespace py = pybind11;

/// One collision of a step, by the bodies' names.
struct CollisionOfPython {
  std::string body_a;
  std::string body_b;
  CollisionReport report;
  std::vector<ReportedContact> contacts;
};

/// What a step told, kept by itself: the world's own report is overwritten by the next.
struct StepOfPython {
  std::int64_t number{0};
  StepReport report;
  std::vector<CollisionOfPython> collisions;
};

/// `bodies` are the names of the world's.
StepOfPython step_of(std::int64_t number, const StepReport& report,
                     const std::vector<std::string>& bodies, WallNaming walls) {
  StepOfPython told{number, report, {}};
  for (const CollisionReport& each : report.collisions) {
    const auto first = report.contacts.begin() + each.first_contact;
    told.collisions.push_back({body_or_wall_name(each.bodies.a, bodies, walls),
                               body_or_wall_name(each.bodies.b, bodies, walls),
                               each,
                               {first, first + each.contact_count}});
  }
  return told;
}

std::vector<std::string> words_of_degradations(std::uint32_t bits) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < kDegradationNames.size(); ++i) {
    if ((bits >> i & 1U) != 0) {
      words.emplace_back(kDegradationNames[i]);
    }
  }
  return words;
}

/// A tree that outlives the world it is of.
struct TreeOfPython {
  std::shared_ptr<const VolumeTree> tree;
};

using SphereRows = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

int checked_level(const TreeOfPython& of, int level) {
  if (level < 0 || level >= of.tree->level_count()) {
    throw py::index_error("expected a level from 0 to " +
                          std::to_string(of.tree->level_count() - 1) + ", got " +
                          std::to_string(level));
  }
  return level;
}

/// The spheres about the nodes that stand for the object: x, y, z, radius.
SphereRows spheres_of(const TreeOfPython& of, int level) {
  const std::vector<std::int32_t> nodes = of.tree->standing_at(checked_level(of, level));
  SphereRows rows(nodes.size(), 4);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Sphere sphere = bounding_sphere(of.tree->volume(nodes[i]));
    rows.row(static_cast<Eigen::Index>(i)) << sphere.centre.transpose(), sphere.radius_m;
  }
  return rows;
}

/// A scene's world, stepped as the program steps it.
class WorldOfPython {
 public:
  WorldOfPython(StagedScene scene, std::uint64_t seed) : run_(std::move(scene), seed) {
    names_ = body_names(run_.world());
  }

  StepOfPython step(std::optional<std::pair<double, double>> looks_at_m,
                    std::optional<std::int64_t> work) {
    if (looks_at_m && !(std::isfinite(looks_at_m->first) && std::isfinite(looks_at_m->second))) {
      throw py::value_error("looks_at_m: expected two finite numbers");
    }
    if (work && *work < 0) {
      throw py::value_error("work: expected 0 units or more, got " + std::to_string(*work));
    }
    require_whole();
    const Fixation fixation =
        looks_at_m ? Fixation(ScreenPoint{looks_at_m->first, looks_at_m->second}) : Fixation();
    broken_ = true;  // until the step is done: a metric of Python's may throw within
    const std::optional<GazeRegion> region = run_.next_region(fixation);
    const StepReport& report =
        work ? stepped_with(*work, fixation, region) : run_.step(fixation, region);
    broken_ = false;
    return step_of(run_.number(), report, names_, wall_naming(run_.world().settings().enclosure));
  }

  void set_metric(std::shared_ptr<const PriorityMetric> metric) {
    require_whole();  // within a step its metric is at work
    put_metric(run_.world(), std::move(metric));
  }

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] std::size_t body(const std::string& name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found != names_.end()) {
      return static_cast<std::size_t>(found - names_.begin());
    }
    throw py::key_error("expected a body of the world, got " + name);
  }

  /// Rows of one field of all states: the world's own memory.
  static py::array field(const py::object& self, std::size_t offset, py::ssize_t columns) {
    auto& world = self.cast<WorldOfPython&>();
    const std::span<BodyState> states = world.run_.world().mutable_states();
    auto* first = reinterpret_cast<double*>(reinterpret_cast<std::byte*>(states.data()) + offset);
    return py::array_t<double>(
        {static_cast<py::ssize_t>(states.size()), columns},
        {static_cast<py::ssize_t>(sizeof(BodyState)), static_cast<py::ssize_t>(sizeof(double))},
        first, self);
  }

  [[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> of_all(
      Vector3 (*value)(const BodyModel&, const BodyState&)) const {
    const World& world = run_.world();
    Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> rows(world.states().size(), 3);
    for (std::size_t i = 0; i < world.states().size(); ++i) {
      rows.row(static_cast<Eigen::Index>(i)) = value(world.models()[i], world.states()[i]);
    }
    return rows;
  }
  [[nodiscard]] double kinetic_energy_J() const { return run_.world().kinetic_energy_J(); }

  [[nodiscard]] const SceneRun& run() const { return run_; }

 private:
  const StepReport& stepped_with(std::int64_t work, const Fixation& fixation,
                                 const std::optional<GazeRegion>& region) {
    FixedWork meter(work);
    return run_.step(fixation, region, meter);
  }
  void require_whole() const {
    if (broken_) {
      throw std::runtime_error(
          "the world is in the middle of a step; where a metric has raised, make it anew");
    }
  }

  SceneRun run_;
  std::vector<std::string> names_;  ///< of the bodies
  bool broken_{false};
};

}  // namespace

py::object world_of(StagedScene scene, std::uint64_t seed) {
  if (scene.budget.ns_per_step > 0) {
    throw InputError(
        "a world in Python: expected a scene without a budget in milliseconds, which no clock "
        "grants here; step(work=...) gives one in units of work");
  }
  return py::cast(std::make_unique<WorldOfPython>(std::move(scene), seed));
}

void add_steps(py::module_& module) {
  py::class_<ReportedContact>(module, "Contact", "A contact that the response got.")
      .def_property_readonly(
          "point", [](const ReportedContact& c) { return c.touch.point; }, "In world (m).")
      .def_property_readonly(
          "normal", [](const ReportedContact& c) { return c.touch.normal; },
          "Unit, from b towards a.")
      .def_property_readonly(
          "depth_m", [](const ReportedContact& c) { return c.touch.depth_m; },
          "Of the overlap, along the normal.")
      .def_readonly("approach_m_s", &ReportedContact::approach_m_s,
                    "Along the normal, before the response.")
      .def_readonly("impulse_Ns", &ReportedContact::impulse_Ns, "Along the normal.");
  py::class_<CollisionOfPython>(module, "Collision", "A pair in contact at the end of a step.")
      .def_readonly("body_a", &CollisionOfPython::body_a, "A body's name.")
      .def_readonly("body_b", &CollisionOfPython::body_b, "A body's name, or a wall's.")
      .def_readonly("contacts", &CollisionOfPython::contacts, "Those that the response got.")
      .def_property_readonly(
          "level", [](const CollisionOfPython& c) { return c.report.level; },
          "Of its trees: the last that was complete.")
      .def_property_readonly(
          "stopped", [](const CollisionOfPython& c) { return name_of(c.report.stop); },
          "Why it went no deeper.")
      .def_property_readonly(
          "priority_list", [](const CollisionOfPython& c) { return c.report.list; },
          "In which it was refined, from 0.")
      .def_property_readonly(
          "measured", [](const CollisionOfPython& c) { return c.report.measured; },
          "By the schedule's metric; None without one.")
      .def_property_readonly(
          "began", [](const CollisionOfPython& c) { return c.report.began; },
          "Whether the pair was apart in the step before.")
      .def_property_readonly(
          "point", [](const CollisionOfPython& c) { return c.report.contact.touch.point; },
          "In world (m).")
      .def_property_readonly(
          "normal", [](const CollisionOfPython& c) { return c.report.contact.touch.normal; },
          "Unit, from b towards a.")
      .def_property_readonly(
          "approach_m_s", [](const CollisionOfPython& c) { return c.report.approach_m_s; },
          "Along the normal, before the response.")
      .def_property_readonly(
          "impulse_Ns", [](const CollisionOfPython& c) { return c.report.impulse_Ns; },
          "Along the normal.")
      .def("__repr__", [](const CollisionOfPython& c) {
        return "<collision of " + c.body_a + " and " + c.body_b + " at level " +
               std::to_string(c.report.level) + ">";
      });
  py::class_<StepOfPython>(module, "Step", "What a step of a world told.")
      .def_readonly("number", &StepOfPython::number, "From 1; the start has the number 0.")
      .def_readonly("collisions", &StepOfPython::collisions, "Pairs in contact at its end.")
      .def_property_readonly(
          "hash", [](const StepOfPython& s) { return bits_of(s.report.state.hash); },
          "Of the state after it, as an export has it.")
      .def_property_readonly(
          "work_granted", [](const StepOfPython& s) { return s.report.work_granted; },
          "Units that refinement was granted.")
      .def_property_readonly(
          "work_spent", [](const StepOfPython& s) { return s.report.work_spent; },
          "Units of work, on all phases.")
      .def_property_readonly(
          "work_floor", [](const StepOfPython& s) { return s.report.work_floor; },
          "What is done whatever the budget.")
      .def_property_readonly(
          "degradations",
          [](const StepOfPython& s) { return words_of_degradations(s.report.degradations); },
          "What kept it from being what it should, in words.")
      .def_property_readonly(
          "pops", [](const StepOfPython& s) { return s.report.pops.size(); },
          "Pairs that fell to a coarser level while they touched.")
      .def("__repr__", [](const StepOfPython& s) {
        return "<step " + std::to_string(s.number) + ": " + std::to_string(s.collisions.size()) +
               " in contact>";
      });
}

void add_trees(py::module_& module) {
  py::class_<TreeOfPython>(module, "Tree", "The volume tree of a body, in the body's frame.")
      .def_property_readonly(
          "levels", [](const TreeOfPython& t) { return t.tree->level_count(); },
          "How many, the root counted.")
      .def_property_readonly(
          "nodes", [](const TreeOfPython& t) { return t.tree->node_count(); }, "Of all levels.")
      .def_property_readonly(
          "bounding_radius_m", [](const TreeOfPython& t) { return t.tree->bounding_radius_m(); },
          "About the centre of mass, of all of the body.")
      .def("spheres", &spheres_of, py::arg("level"),
           "The spheres about the nodes that stand for the body at a level: x, y, z, radius (m).")
      .def(
          "fit_error_m",
          [](const TreeOfPython& t, int level) {
            return t.tree->fit_error_m(checked_level(t, level));
          },
          py::arg("level"), "How far these reach beyond the body, at worst.");
}

void add_worlds(py::module_& module) {
  py::class_<WorldOfPython>(
      module, "World",
      "A scene's world, stepped by the program's own engine: the same bits, the same hashes.\n\n"
      "Fields of states are NumPy arrays of the world's own memory, a row for each body, and show\n"
      "each step without a copy; writing to them moves the bodies.")
      .def(
          "step", &WorldOfPython::step, py::kw_only(), py::arg("looks_at_m") = py::none(),
          py::arg("work") = py::none(),
          "Takes a step and returns what it told. `looks_at_m`: where the viewer looks, right of\n"
          "and above the screen's centre (m). `work`: units granted to refinement; None: what the\n"
          "scene's own budget says.")
      .def(
          "set_metric",
          [](WorldOfPython& world, const std::string& name) {
            try {
              world.set_metric(make_metric(name));
            } catch (const std::invalid_argument& error) {
              throw py::value_error(error.what());
            }
          },
          py::arg("metric"))
      .def(
          "set_metric",
          [](WorldOfPython& world, py::function measure, const std::string& urgent) {
            world.set_metric(metric_of_function(std::move(measure), urgent));
          },
          py::arg("metric"), py::arg("urgent") = "large",
          "What orders pairs from the next step on: the name of a metric, or a function of a Pair\n"
          "that returns a number, of which the `urgent` (\"large\" or \"small\") come first.")
      .def_property_readonly("bodies", &WorldOfPython::names, "Names, in the order of all rows.")
      .def_property_readonly(
          "number", [](const WorldOfPython& w) { return w.run().number(); },
          "How many steps were taken.")
      .def_property_readonly(
          "step_hz", [](const WorldOfPython& w) { return w.run().scene().step_hz; },
          "Steps per second.")
      .def_property_readonly(
          "time_s",
          [](const WorldOfPython& w) {
            return static_cast<double>(w.run().number()) / w.run().scene().step_hz;
          },
          "Of the stimulus, after the last step.")
      .def_property_readonly(
          "ends_s", [](const WorldOfPython& w) { return w.run().ends_s(); },
          "When the stimulus ends, as far as is known now.")
      .def_property_readonly(
          "hash",
          [](const WorldOfPython& w) { return bits_of(hash_state(w.run().world().states()).hash); },
          "Of the state now, as an export has it.")
      .def_property_readonly(
          "positions",
          [](const py::object& self) {
            return WorldOfPython::field(self, offsetof(BodyState, pose.position), 3);
          },
          "Centres of mass (m), n × 3; no copy.")
      .def_property_readonly(
          "orientations",
          [](const py::object& self) {
            return WorldOfPython::field(self, offsetof(BodyState, pose.orientation), 4);
          },
          "Unit quaternions x, y, z, w, n × 4; no copy.")
      .def_property_readonly(
          "linear_momenta",
          [](const py::object& self) {
            return WorldOfPython::field(self, offsetof(BodyState, linear_momentum), 3);
          },
          "kg m/s, n × 3; no copy.")
      .def_property_readonly(
          "angular_momenta",
          [](const py::object& self) {
            return WorldOfPython::field(self, offsetof(BodyState, angular_momentum), 3);
          },
          "kg m²/s about the centres of mass, n × 3; no copy.")
      .def_property_readonly(
          "velocities", [](const WorldOfPython& w) { return w.of_all(velocity); },
          "m/s, n × 3; computed.")
      .def_property_readonly(
          "spins", [](const WorldOfPython& w) { return w.of_all(angular_velocity); },
          "rad/s, n × 3; computed.")
      .def_property_readonly("kinetic_energy_J", &WorldOfPython::kinetic_energy_J,
                             "Of all bodies, of motion and turning.")
      .def(
          "tree",
          [](const WorldOfPython& w, const std::string& body) {
            return TreeOfPython{w.run().world().models()[w.body(body)].tree};
          },
          py::arg("body"),
          "The volume tree of the body of this name; raises KeyError where there is none.")
      .def("__repr__", [](const WorldOfPython& w) {
        return "<world of " + std::to_string(w.names().size()) + " bodies after step " +
               std::to_string(w.run().number()) + ">";
      });
}

}  // namespace impetus::inline python
