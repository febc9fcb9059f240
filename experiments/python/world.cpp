// SPDX-License-Identifier: MIT
#include "experiments/python/module.hpp"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "engine/scheduling/metrics.hpp"
#include "engine/trees/volume_tree.hpp"
#include "engine/volumes/volume.hpp"
#include "experiments/record/wall_names.hpp"
#include "experiments/run/scene_run.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline python {
namespace {

namespace py = pybind11;

/// Indexed by StopReason.
constexpr const char* kStops[] = {"separated", "finest", "budget spent", "greatest level",
                                  "capped"};

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

/// A tree that outlives the world it is of.
struct TreeOfPython {
  std::shared_ptr<const VolumeTree> tree;

  [[nodiscard]] int checked(int level) const {
    if (level < 0 || level >= tree->level_count()) {
      throw py::index_error("expected a level from 0 to " +
                            std::to_string(tree->level_count() - 1) + ", got " +
                            std::to_string(level));
    }
    return level;
  }
  /// The spheres about the nodes that stand for the object: x, y, z, radius.
  [[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> spheres(int level) const {
    const std::vector<std::int32_t> nodes = tree->standing_at(checked(level));
    Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> rows(nodes.size(), 4);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Sphere sphere = bounding_sphere(tree->volume(nodes[i]));
      rows.row(static_cast<Eigen::Index>(i)) << sphere.centre.transpose(), sphere.radius_m;
    }
    return rows;
  }
};

/// A scene's world, stepped as the program steps it.
class WorldOfPython {
 public:
  WorldOfPython(StagedScene scene, std::uint64_t seed) : run_(std::move(scene), seed) {}

  StepOfPython step(std::optional<std::pair<double, double>> looks_at_m,
                    std::optional<std::int64_t> work) {
    require_whole();
    const Fixation fixation =
        looks_at_m ? Fixation(ScreenPoint{looks_at_m->first, looks_at_m->second}) : Fixation();
    broken_ = true;  // until the step is done: a metric of Python's may throw within
    const std::optional<GazeRegion> region = run_.next_region(fixation);
    const StepReport& report =
        work ? stepped_with(*work, fixation, region) : run_.step(fixation, region);
    broken_ = false;
    StepOfPython told{run_.number(), report, {}};
    for (const CollisionReport& each : report.collisions) {
      const auto first = report.contacts.begin() + each.first_contact;
      told.collisions.push_back({name_of(each.bodies.a),
                                 name_of(each.bodies.b),
                                 each,
                                 {first, first + each.contact_count}});
    }
    return told;
  }

  void set_metric(std::shared_ptr<const PriorityMetric> metric) {
    Schedule schedule = run_.world().settings().schedule;
    schedule.metric = std::move(metric);
    run_.world().set_schedule(std::move(schedule));
  }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const BodyModel& model : run_.world().models()) {
      all.push_back(model.name);
    }
    return all;
  }
  [[nodiscard]] std::size_t body(const std::string& name) const {
    const std::vector<BodyModel>& models = run_.world().models();
    for (std::size_t i = 0; i < models.size(); ++i) {
      if (models[i].name == name) {
        return i;
      }
    }
    throw py::key_error("expected a body of the world, got " + name);
  }

  /// Rows of one field of all states: the world's own memory.
  static py::array field(const py::object& self, std::size_t offset, py::ssize_t columns) {
    auto& world = self.cast<WorldOfPython&>();
    std::vector<BodyState>& states = world.run_.world().mutable_states();
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
  [[nodiscard]] double kinetic_energy_J() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < run_.world().states().size(); ++i) {
      sum += kinetic_energy(run_.world().models()[i], run_.world().states()[i]);
    }
    return sum;
  }

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
          "the world was left in the middle of a step by what a metric raised; make it anew");
    }
  }
  [[nodiscard]] std::string name_of(std::int32_t body) const {
    return is_wall(body) ? wall_name(body, wall_naming(run_.world().settings().enclosure))
                         : run_.world().models()[static_cast<std::size_t>(body)].name;
  }

  SceneRun run_;
  bool broken_{false};
};

std::vector<std::string> words_of_degradations(std::uint32_t bits) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < kDegradationNames.size(); ++i) {
    if ((bits >> i & 1U) != 0) {
      words.emplace_back(kDegradationNames[i]);
    }
  }
  return words;
}

void add_pairs(py::module_& module) {
  py::class_<PairOfPython>(module, "Pair",
                           "What a metric may look at: two bodies, or one and a "
                           "wall, and the viewer (metres, m/s, world).")
      .def_property_readonly(
          "a", [](const PairOfPython& p) { return p.bounds.pair.a; }, "Index of the first body.")
      .def_property_readonly(
          "b", [](const PairOfPython& p) { return p.bounds.pair.b; },
          "Index of the second; below 0: the walls.")
      .def_property_readonly("centre_a", [](const PairOfPython& p) { return p.bounds.a.centre; })
      .def_property_readonly("centre_b", [](const PairOfPython& p) { return p.bounds.b.centre; })
      .def_property_readonly("radius_a", [](const PairOfPython& p) { return p.bounds.a.radius_m; })
      .def_property_readonly("radius_b", [](const PairOfPython& p) { return p.bounds.b.radius_m; })
      .def_property_readonly("velocity_a",
                             [](const PairOfPython& p) { return p.bounds.velocity_a; })
      .def_property_readonly("velocity_b",
                             [](const PairOfPython& p) { return p.bounds.velocity_b; })
      .def_property_readonly(
          "fit_error_m", [](const PairOfPython& p) { return p.bounds.fit_error_m; },
          "How far both trees together reach beyond the surfaces, at most.")
      .def_property_readonly(
          "place", [](const PairOfPython& p) { return collision_place(p.bounds); },
          "Where the bounds meet.")
      .def_property_readonly("eye", [](const PairOfPython& p) { return p.viewer.eye; })
      .def_property_readonly(
          "fixation_m",
          [](const PairOfPython& p) -> py::object {
            return p.fixation ? py::object(py::make_tuple(p.fixation->x_m, p.fixation->y_m))
                              : py::object(py::none());
          },
          "Where the viewer looks, right of and above the screen's centre; None: not known.");
}

void add_collisions(py::module_& module) {
  py::class_<ReportedContact>(module, "Contact", "A contact that the response got.")
      .def_property_readonly("point", [](const ReportedContact& c) { return c.touch.point; })
      .def_property_readonly(
          "normal", [](const ReportedContact& c) { return c.touch.normal; },
          "Unit, from b towards a.")
      .def_property_readonly("depth_m", [](const ReportedContact& c) { return c.touch.depth_m; })
      .def_readonly("approach_m_s", &ReportedContact::approach_m_s)
      .def_readonly("impulse_Ns", &ReportedContact::impulse_Ns);
  py::class_<CollisionOfPython>(module, "Collision", "A pair in contact at the end of a step.")
      .def_readonly("body_a", &CollisionOfPython::body_a)
      .def_readonly("body_b", &CollisionOfPython::body_b, "A body's name, or a wall's.")
      .def_readonly("contacts", &CollisionOfPython::contacts)
      .def_property_readonly(
          "level", [](const CollisionOfPython& c) { return c.report.level; },
          "Of its trees: the last that was complete.")
      .def_property_readonly(
          "stopped",
          [](const CollisionOfPython& c) {
            return kStops[static_cast<std::size_t>(c.report.stop)];
          },
          "Why it went no deeper.")
      .def_property_readonly("priority_list",
                             [](const CollisionOfPython& c) { return c.report.list; })
      .def_property_readonly(
          "measured", [](const CollisionOfPython& c) { return c.report.measured; },
          "By the schedule's metric; None without one.")
      .def_property_readonly("began", [](const CollisionOfPython& c) { return c.report.began; })
      .def_property_readonly(
          "point", [](const CollisionOfPython& c) { return c.report.contact.touch.point; })
      .def_property_readonly(
          "normal", [](const CollisionOfPython& c) { return c.report.contact.touch.normal; })
      .def_property_readonly("approach_m_s",
                             [](const CollisionOfPython& c) { return c.report.approach_m_s; })
      .def_property_readonly("impulse_Ns",
                             [](const CollisionOfPython& c) { return c.report.impulse_Ns; })
      .def("__repr__", [](const CollisionOfPython& c) {
        return "<collision of " + c.body_a + " and " + c.body_b + " at level " +
               std::to_string(c.report.level) + ">";
      });
  py::class_<StepOfPython>(module, "Step", "What a step of a world told.")
      .def_readonly("number", &StepOfPython::number)
      .def_readonly("collisions", &StepOfPython::collisions)
      .def_property_readonly(
          "hash", [](const StepOfPython& s) { return bits_of(s.report.state.hash); },
          "Of the state after it, as an export has it.")
      .def_property_readonly("work_granted",
                             [](const StepOfPython& s) { return s.report.work_granted; })
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
      .def_property_readonly("levels", [](const TreeOfPython& t) { return t.tree->level_count(); })
      .def_property_readonly("nodes", [](const TreeOfPython& t) { return t.tree->node_count(); })
      .def_property_readonly("bounding_radius_m",
                             [](const TreeOfPython& t) { return t.tree->bounding_radius_m(); })
      .def("spheres", &TreeOfPython::spheres, py::arg("level"),
           "The spheres about the nodes that stand for the body at a level: x, y, z, radius (m).")
      .def(
          "fit_error_m",
          [](const TreeOfPython& t, int level) { return t.tree->fit_error_m(t.checked(level)); },
          py::arg("level"), "How far these reach beyond the body, at worst.");
}

}  // namespace

std::shared_ptr<const PriorityMetric> metric_of_function(py::function measure,
                                                         const std::string& urgent) {
  if (urgent != "large" && urgent != "small") {
    throw py::value_error("urgent: expected \"large\" or \"small\", got \"" + urgent + "\"");
  }
  return std::make_shared<FunctionMetric>(std::move(measure),
                                          urgent == "large" ? Urgent::kLarge : Urgent::kSmall);
}

py::object world_of(StagedScene scene, std::uint64_t seed) {
  if (scene.budget.ns_per_step > 0) {
    throw InputError(
        "a world in Python: expected a scene without a budget in milliseconds, which no clock "
        "grants here; step(work=...) gives one in units of work");
  }
  return py::cast(new WorldOfPython(std::move(scene), seed),
                  py::return_value_policy::take_ownership);
}

void add_worlds(py::module_& module) {
  add_pairs(module);
  add_collisions(module);
  add_trees(module);
  module.def("metric_names", [] {
    std::vector<std::string> names;
    for (const std::string_view name : metric_names()) {
      names.emplace_back(name);
    }
    return names;
  });
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
      .def_property_readonly("step_hz",
                             [](const WorldOfPython& w) { return w.run().scene().step_hz; })
      .def_property_readonly("time_s",
                             [](const WorldOfPython& w) {
                               return static_cast<double>(w.run().number()) /
                                      w.run().scene().step_hz;
                             })
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
      .def_property_readonly("kinetic_energy_J", &WorldOfPython::kinetic_energy_J)
      .def(
          "tree",
          [](const WorldOfPython& w, const std::string& body) {
            return TreeOfPython{w.run().world().models()[w.body(body)].tree};
          },
          py::arg("body"))
      .def("__repr__", [](const WorldOfPython& w) {
        return "<world of " + std::to_string(w.names().size()) + " bodies after step " +
               std::to_string(w.run().number()) + ">";
      });
}

}  // namespace impetus::inline python
