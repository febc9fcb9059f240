// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "engine/dynamics/limits.hpp"
#include "engine/numerics/elementary_functions.hpp"
#include "engine/trees/builders/part_shape.hpp"
#include "experiments/scenes/figures/figure_files.hpp"
#include "experiments/scenes/figures/figure_parts.hpp"
#include "experiments/scenes/scene_bodies.hpp"
#include "experiments/scenes/scene_enclosure.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;
using Problems = std::vector<SceneProblem>;

/// "1e-06 m"
std::string text_of(double number, const char* unit) {
  char text[48];
  std::snprintf(text, sizeof text, "%g%s", number, unit);
  return text;
}

/// Each measure of a shape: the least of them is what a body is thin by.
void add_size_problems(const json& shape, const std::string& place, double m_per_deg,
                       Problems& problems) {
  for (const char* measure : {"size_deg", "radius_deg", "width_deg", "height_deg", "depth_deg",
                              "arm_deg", "thickness_deg", "tube_deg", "length_deg"}) {
    const double size_m = shape.value(measure, 1.0) * m_per_deg;
    if (size_m < kLeastSize_m) {
      problems.push_back({place + "/" + measure, "expected " + text_of(kLeastSize_m, " m") +
                                                     " or more, seen on the screen, got " +
                                                     text_of(size_m, " m")});
    }
  }
}

/// Of each part of each figure, as high as the scene has it.
void add_figure_size_problems(const json& scene, double m_per_deg, Problems& problems) {
  for (const FigureFile& named : figure_files_of(scene)) {
    const json::json_pointer entry = json::json_pointer(named.pointer).parent_pointer();
    const auto height_deg = scene[entry]["height_deg"].get<double>();
    const json& parts = figure_content(scene, named.file)["parts"];
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Problems of_part;
      add_size_problems(part_shape(parts[i], height_deg, ""), "", m_per_deg, of_part);
      for (const SceneProblem& problem : of_part) {
        problems.push_back({entry.to_string() + "/height_deg",
                            "of the part " + parts[i]["name"].dump() + ", " +
                                problem.pointer.substr(1) + ": " + problem.message});
      }
    }
  }
}

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
std::string shape_place(const json& scene, const SceneBodies& bodies, std::size_t body) {
  if (scene.contains("crowd")) {
    return "/crowd/shape";
  }
  for (std::size_t i = 0; i < bodies.figures.size(); ++i) {
    const Figure& figure = bodies.figures[i];
    if (figure.has_part(static_cast<std::int32_t>(body))) {
      const std::size_t named = scene.contains("figure_crowd") ? 0 : i;
      return part_place(figure_files_of(scene)[named].file,
                        body - static_cast<std::size_t>(figure.first_part)) +
             "/shape";
    }
  }
  return "/bodies/" + std::to_string(body) + "/shape";
}

void add_weight_problems(const json& scene, double m_per_deg, Problems& problems) {
  json shallow = scene;  // the mass is that of the mesh, whatever the tree
  shallow["engine"]["tree_depth"] = 0;
  ShapeLibrary library;
  const SceneBodies bodies = bodies_of(shallow, m_per_deg, library);
  const std::size_t shapes = scene.contains("crowd") ? 1 : bodies.shapes.size();
  for (std::size_t i = 0; i < shapes; ++i) {
    const double ratio = inertia_ratio(bodies.shapes[i]->unit_mass.inertia);
    if (!(ratio <= kMostInertiaRatio)) {
      problems.push_back({shape_place(scene, bodies, i), "expected moments of inertia at most " +
                                                             text_of(kMostInertiaRatio, "") +
                                                             " to one, got " + text_of(ratio, "")});
    }
  }
  const Weights weights = weights_of(bodies);
  if (weights.most_kg > kMostMassRatio * weights.least_kg) {
    problems.push_back({"/bodies", "expected masses at most " + text_of(kMostMassRatio, "") +
                                       " to one, got " + text_of(weights.most_kg, " kg") + " and " +
                                       text_of(weights.least_kg, " kg")});
  }
}

/// Where nothing is in the way, a body falls as long as the scene lasts.
void add_fall_problems(const json& scene, Problems& problems) {
  const json& engine = scene["engine"];
  if (!engine.contains("gravity_m_s2") || !scene.contains("duration_s") ||
      scene.contains("enclosure")) {
    return;
  }
  const auto gravity = engine["gravity_m_s2"].get<std::array<double, 3>>();
  const double size_m_s2 = Vector3(gravity[0], gravity[1], gravity[2]).norm();
  const auto duration_s = scene["duration_s"].get<double>();
  const double way_m = 0.5 * size_m_s2 * duration_s * duration_s;
  if (way_m > kMostDistance_m) {
    problems.push_back(
        {"/engine/gravity_m_s2", "expected a fall of " + text_of(kMostDistance_m, " m") +
                                     " at most in the " + text_of(duration_s, " s") +
                                     " that the scene lasts, got " + text_of(way_m, " m")});
  }
}

/// What may be drawn for each body of a random spin.
void add_spin_problems(const json& scene, Problems& problems) {
  const json::json_pointer place("/imposed/random_spin");
  if (!scene.contains(place)) {
    return;
  }
  for (const char* body : {"a", "b"}) {
    const json& limits = scene[place][body];
    Vector3 most;
    for (int i = 0; i < 3; ++i) {
      const auto component = static_cast<std::size_t>(i);
      most[i] = std::max(std::abs(limits["least_rad_s"][component].get<double>()),
                         std::abs(limits["most_rad_s"][component].get<double>()));
    }
    if (most.norm() > kMostSpin_rad_s) {
      problems.push_back({place.to_string() + "/" + body,
                          "expected a spin of " + text_of(kMostSpin_rad_s, " rad/s") +
                              " at most, got " + text_of(most.norm(), " rad/s")});
    }
  }
}

}  // namespace

std::vector<SceneProblem> limit_problems(const json& scene) {
  const double m_per_deg = metres_per_degree(screen_for_checks().viewing_distance_m);
  Problems problems;
  if (scene.contains("crowd")) {
    add_size_problems(scene["crowd"]["shape"], "/crowd/shape", m_per_deg, problems);
  }
  const json bodies = scene.value("bodies", json::array());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    add_size_problems(bodies[i]["shape"], "/bodies/" + std::to_string(i) + "/shape", m_per_deg,
                      problems);
  }
  add_figure_size_problems(scene, m_per_deg, problems);
  if (problems.empty()) {
    add_weight_problems(scene, m_per_deg, problems);
  }
  add_fall_problems(scene, problems);
  add_spin_problems(scene, problems);
  return problems;
}

}  // namespace impetus::inline scenes
