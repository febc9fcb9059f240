// SPDX-License-Identifier: MIT
#include "experiments/scenes/shape_checks.hpp"

#include <algorithm>
#include <exception>
#include <map>
#include <optional>

#include "engine/shapes/solids/ring_meshes.hpp"
#include "experiments/scenes/scene_meshes.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

struct ShapeKind {
  std::vector<std::string> measures;
  std::vector<std::string> choices;  ///< keys that may be left out
};

const ShapeKind& kind_of_shape(const json& shape) {
  static const std::map<std::string, ShapeKind> kKinds{
      {"sphere", {{"radius_deg"}, {}}},
      {"box", {{"width_deg", "height_deg", "depth_deg"}, {}}},
      {"plate", {{"width_deg", "height_deg", "thickness_deg"}, {}}},
      {"l-block", {{"arm_deg", "thickness_deg"}, {}}},
      {"torus", {{"radius_deg", "tube_deg"}, {"resolution"}}},
      {"knot", {{"radius_deg", "tube_deg"}, {"resolution"}}},
      {"creature", {{"length_deg"}, {"resolution"}}},
      {"line-swept", {{"length_deg", "radius_deg"}, {"resolution", "coarsest", "deeper"}}},
      {"rectangle-swept",
       {{"width_deg", "height_deg", "radius_deg"}, {"resolution", "coarsest", "deeper"}}},
      {"mesh", {{"file", "size_deg"}, {}}}};
  return kKinds.at(shape["kind"].get<std::string>());
}

std::optional<SceneProblem> wrong_keys(const json& shape, const std::string& place) {
  const ShapeKind& kind = kind_of_shape(shape);
  const auto name = shape["kind"].get<std::string>();
  std::string names;
  for (const std::string& measure : kind.measures) {
    if (!shape.contains(measure)) {
      return SceneProblem{
          place, "expected the key \"" + measure + "\" for kind " + name + ", which is missing"};
    }
    names += ", " + measure;
  }
  std::size_t measures = shape.size() - 1;
  for (const char* choice : {"resolution", "coarsest", "deeper"}) {
    measures -= shape.contains(choice) ? 1 : 0;
  }
  if (measures != kind.measures.size()) {
    return SceneProblem{place, "expected the measures of kind " + name + " alone" + names +
                                   ", got " + std::to_string(measures)};
  }
  for (const char* choice : {"resolution", "coarsest", "deeper"}) {
    const bool may = std::count(kind.choices.begin(), kind.choices.end(), choice) > 0;
    if (shape.contains(choice) && !may) {
      return SceneProblem{place + "/" + choice,
                          "expected none for kind " + name + ", got " + shape[choice].dump()};
    }
  }
  return {};
}

/// Whether `measure` reaches `limit` of another.
std::optional<SceneProblem> not_less(const json& shape, const char* measure, const char* limit,
                                     const std::string& place) {
  if (shape[measure].get<double>() < shape[limit].get<double>()) {
    return {};
  }
  return SceneProblem{place + "/" + measure, "expected less than " + std::string(limit) + ", got " +
                                                 shape[measure].dump()};
}

/// Measures that, each allowed by itself, make no solid together.
std::optional<SceneProblem> unfit_measures(const json& shape, const std::string& place) {
  const auto kind = shape["kind"].get<std::string>();
  if (kind == "l-block") {
    return not_less(shape, "thickness_deg", "arm_deg", place);
  }
  if (kind == "plate") {
    const auto too_thick = not_less(shape, "thickness_deg", "width_deg", place);
    return too_thick ? too_thick : not_less(shape, "thickness_deg", "height_deg", place);
  }
  if (kind == "torus") {
    return not_less(shape, "tube_deg", "radius_deg", place);
  }
  if (kind == "knot" &&
      shape["tube_deg"].get<double>() > kThickestKnot * shape["radius_deg"].get<double>()) {
    return SceneProblem{place + "/tube_deg",
                        "expected at most a quarter of radius_deg, or the knot would touch itself, "
                        "got " +
                            shape["tube_deg"].dump()};
  }
  return {};
}

/// A mesh is known by its content: a file may change after a scene was recorded.
std::optional<SceneProblem> content_problem(const json& shape, const json& meshes,
                                            const std::string& place) {
  const auto file = shape["file"].get<std::string>();
  if (!meshes.contains(file)) {
    return SceneProblem{place + "/file",
                        "expected a mesh whose content the scene holds, got " + json(file).dump()};
  }
  try {
    mesh_content(meshes, file);
  } catch (const std::exception& error) {
    return SceneProblem{place + "/file", std::string(error.what()) + " for " + json(file).dump()};
  }
  return {};
}

}  // namespace

void add_shape_problems(const json& shape, const json& meshes, const std::string& place,
                        std::vector<SceneProblem>& problems) {
  auto problem = wrong_keys(shape, place);
  if (!problem) {
    problem = unfit_measures(shape, place);
  }
  if (!problem && is_mesh(shape)) {
    problem = content_problem(shape, meshes, place);
  }
  if (problem) {
    problems.push_back(*problem);
  }
}

}  // namespace impetus::inline scenes
