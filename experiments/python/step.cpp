// SPDX-License-Identifier: MIT
#include "experiments/python/step.hpp"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "engine/trees/volume_tree.hpp"
#include "engine/volumes/volume.hpp"
#include "experiments/python/module.hpp"

namespace impetus::inline python {
namespace {

namespace py = pybind11;

using SphereRows = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

std::vector<std::string> words_of_degradations(std::uint32_t bits) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < kDegradationNames.size(); ++i) {
    if ((bits >> i & 1U) != 0) {
      words.emplace_back(kDegradationNames[i]);
    }
  }
  return words;
}

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

}  // namespace

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

}  // namespace impetus::inline python
