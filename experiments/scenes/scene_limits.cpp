// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_limits.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "engine/dynamics/limits.hpp"
#include "engine/numerics/elementary_functions.hpp"
#include "engine/trees/builders/part_shape.hpp"
#include "experiments/scenes/figures/figure_making.hpp"
#include "experiments/scenes/scene_bodies.hpp"
#include "experiments/scenes/scene_enclosure.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline scenes {
namespace {

/// "1e-06 m"
std::string text_of(double number, const char* unit) { return printed("%g%s", number, unit); }

/// A measure of a shape that is too small, seen on the screen.
struct SmallMeasure {
  std::string key;
  std::string message;
};

/// Of each measure of a shape: the least of them is what a body is thin by.
std::vector<SmallMeasure> small_measures(const ShapeSettings& shape, double m_per_deg) {
  std::vector<SmallMeasure> found;
  for (const ShapeMeasure& measure : shape_measures()) {
    const double size_m = (shape.*measure.place).value_or(1.0) * m_per_deg;
    if (size_m < kLeastSize_m) {
      found.push_back({measure.name + suffix_of(shape), "expected " + text_of(kLeastSize_m, " m") +
                                                            " or more, seen on the screen, got " +
                                                            text_of(size_m, " m")});
    }
  }
  return found;
}

void add_size_problems(const ShapeSettings& shape, const std::string& place, double m_per_deg,
                       SceneProblems& problems) {
  for (const SmallMeasure& small : small_measures(shape, m_per_deg)) {
    problems.add(place + "/" + small.key, small.message);
  }
}

/// Of each part of a figure, as high as the scene has it.
void add_figure_size_problems(const FigureSettings& figure, const FigureMaking& making,
                              const std::string& place, double m_per_deg, SceneProblems& problems) {
  for (const PartSettings& part : figure.parts) {
    for (const SmallMeasure& small :
         small_measures(part_shape(part, making.height_deg), m_per_deg)) {
      problems.add(place + "/height_deg", "of the part " + nlohmann::json(part.name).dump() + ", " +
                                              small.key + ": " + small.message);
    }
  }
}

void add_figure_size_problems(const Scene& scene, double m_per_deg, SceneProblems& problems) {
  const auto add = [&](const FigureMaking& making, const std::string& place) {
    add_figure_size_problems(scene.figure_files.at(making.figure), making, place, m_per_deg,
                             problems);
  };
  if (scene.figure_crowd) {
    add(scene.figure_crowd->making, "/figure_crowd");
  }
  const auto figures = scene.named_figures();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    add(figures[i].making, "/figures/" + std::to_string(i));
  }
}

/// The lightest and the heaviest body.
struct Weights {
  double least_kg{0.0};
  double most_kg{0.0};
};

Weights weights_of(const SceneBodies& bodies) {
  Weights weights;
  for (const BodyModel& model : bodies.models) {
    if (model.inverse_mass > 0.0) {
      const double mass_kg = 1.0 / model.inverse_mass;
      weights.least_kg = weights.most_kg > 0.0 ? std::min(weights.least_kg, mass_kg) : mass_kg;
      weights.most_kg = std::max(weights.most_kg, mass_kg);
    }
  }
  return weights;
}

/// Of the greatest principal moment to the least.
double inertia_ratio(const Matrix3& inertia) {
  const Matrix3 axes = eigenvectors_of(inertia);
  const Vector3 moments = (axes.transpose() * inertia * axes).diagonal();
  return moments.maxCoeff() / moments.minCoeff();
}

/// Where the scene says what shape a body has.
std::string shape_place(const Scene& scene, const SceneBodies& bodies, std::size_t body) {
  if (scene.crowd) {
    return "/crowd/shape";
  }
  for (std::size_t i = 0; i < bodies.figures.size(); ++i) {
    const Figure& figure = bodies.figures[i];
    if (figure.has_part(static_cast<std::int32_t>(body))) {
      const std::size_t named = scene.figure_crowd ? 0 : i;
      return part_place(named_figure_files(scene)[named].file,
                        body - static_cast<std::size_t>(figure.first_part)) +
             "/shape";
    }
  }
  return "/bodies/" + std::to_string(body) + "/shape";
}

void add_weight_problems(const Scene& scene, double m_per_deg, ShapeLibrary& library,
                         SceneProblems& problems) {
  Scene shallow = scene;  // the mass is that of the mesh, whatever the tree
  shallow.engine.tree_depth = 0;
  const SceneBodies bodies = bodies_of(shallow, m_per_deg, library);
  const std::size_t shapes = scene.crowd ? 1 : bodies.shapes.size();
  for (std::size_t i = 0; i < shapes; ++i) {
    const double ratio = inertia_ratio(bodies.shapes[i]->unit_mass.inertia);
    if (!(ratio <= kMostInertiaRatio)) {
      problems.add(shape_place(scene, bodies, i), "expected moments of inertia at most " +
                                                      text_of(kMostInertiaRatio, "") +
                                                      " to one, got " + text_of(ratio, ""));
    }
  }
  const Weights weights = weights_of(bodies);
  if (weights.most_kg > kMostMassRatio * weights.least_kg) {
    problems.add("/bodies", "expected masses at most " + text_of(kMostMassRatio, "") +
                                " to one, got " + text_of(weights.most_kg, " kg") + " and " +
                                text_of(weights.least_kg, " kg"));
  }
}

/// Where nothing is in the way, a body falls as long as the scene lasts.
void add_fall_problems(const Scene& scene, SceneProblems& problems) {
  const auto& gravity_m_s2 = scene.engine.gravity_m_s2;
  if (!gravity_m_s2 || !scene.duration_s || scene.enclosure) {
    return;
  }
  const double duration_s = *scene.duration_s;
  const double way_m = 0.5 * gravity_m_s2->norm() * duration_s * duration_s;
  if (way_m > kMostDistance_m) {
    problems.add("/engine/gravity_m_s2", "expected a fall of " + text_of(kMostDistance_m, " m") +
                                             " at most in the " + text_of(duration_s, " s") +
                                             " that the scene lasts, got " + text_of(way_m, " m"));
  }
}

/// What may be drawn for a body of a random spin.
void add_spin_problem(const SpinLimits& limits, const std::string& place, SceneProblems& problems) {
  const Vector3 most = limits.least_rad_s.cwiseAbs().cwiseMax(limits.most_rad_s.cwiseAbs());
  if (most.norm() > kMostSpin_rad_s) {
    problems.add(place, "expected a spin of " + text_of(kMostSpin_rad_s, " rad/s") +
                            " at most, got " + text_of(most.norm(), " rad/s"));
  }
}

}  // namespace

void add_limit_problems(const Scene& scene, ShapeLibrary& library, SceneProblems& problems) {
  const double m_per_deg = metres_per_degree(screen_for_checks().viewing_distance_m);
  if (scene.crowd) {
    add_size_problems(scene.crowd->shape, "/crowd/shape", m_per_deg, problems);
  }
  const auto bodies = scene.named_bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    add_size_problems(bodies[i].shape, "/bodies/" + std::to_string(i) + "/shape", m_per_deg,
                      problems);
  }
  add_figure_size_problems(scene, m_per_deg, problems);
  if (problems.empty()) {
    add_weight_problems(scene, m_per_deg, library, problems);
  }
  add_fall_problems(scene, problems);
  if (scene.imposed && scene.imposed->random_spin) {
    add_spin_problem(scene.imposed->random_spin->a, "/imposed/random_spin/a", problems);
    add_spin_problem(scene.imposed->random_spin->b, "/imposed/random_spin/b", problems);
  }
}

}  // namespace impetus::inline scenes
