// SPDX-License-Identifier: MIT
#include "experiments/scenes/shape_checks.hpp"

#include <exception>
#include <map>
#include <optional>

#include "engine/shapes/knot_mesh.hpp"
#include "experiments/scenes/scene_meshes.hpp"

namespace impetus {
namespace {

using nlohmann::json;

struct Kind {
  std::vector<std::string> measures;
  bool takes_resolution;
};

const Kind& kind_of(const json& shape) {
  static const std::map<std::string, Kind> kKinds{
      {"sphere", {{"radius_deg"}, false}},
      {"box", {{"width_deg", "height_deg", "depth_deg"}, false}},
      {"plate", {{"width_deg", "height_deg", "thickness_deg"}, false}},
      {"l-block", {{"arm_deg", "thickness_deg"}, false}},
      {"torus", {{"radius_deg", "tube_deg"}, true}},
      {"knot", {{"radius_deg", "tube_deg"}, true}},
      {"creature", {{"length_deg"}, true}},
      {"mesh", {{"file", "size_deg"}, false}}};
  return kKinds.at(shape["kind"].get<std::string>());
}

std::optional<SceneProblem> wrong_keys(const json& shape, const std::string& place) {
  const Kind& kind = kind_of(shape);
  const auto name = shape["kind"].get<std::string>();
  std::string names;
  for (const std::string& measure : kind.measures) {
    if (!shape.contains(measure)) {
      return SceneProblem{
          place, "expected the key \"" + measure + "\" for kind " + name + ", which is missing"};
    }
    names += ", " + measure;
  }
  const bool has_resolution = shape.contains("resolution");
  const std::size_t measures = shape.size() - (has_resolution ? 2 : 1);
  if (measures != kind.measures.size()) {
    return SceneProblem{place, "expected the measures of kind " + name + " alone" + names +
                                   ", got " + std::to_string(measures)};
  }
  if (has_resolution && !kind.takes_resolution) {
    return SceneProblem{place + "/resolution",
                        "expected none for kind " + name + ", got " + shape["resolution"].dump()};
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

}  // namespace impetus
