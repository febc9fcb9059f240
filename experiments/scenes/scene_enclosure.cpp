// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_enclosure.hpp"

#include <string>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

constexpr const char* kFrustum = "view-frustum";

std::string kind_of_enclosure(const json& enclosure) {
  return enclosure.value("kind", std::string("closed-cube"));
}

ClosedCube cube_of(const json& scene, double metres_per_degree) {
  const json& enclosure = scene["enclosure"];
  double edge_m = enclosure["edge_deg"].get<double>() * metres_per_degree;
  for (const char* crowd : {"crowd", "figure_crowd"}) {
    if (scene.contains(crowd) && enclosure.contains("edge_at_count")) {
      edge_m *=
          cube_root(scene[crowd]["count"].get<double>() / enclosure["edge_at_count"].get<double>());
    }
  }
  return {0.5 * edge_m};
}

}  // namespace

std::optional<Enclosure> enclosure_of(const json& scene, double metres_per_degree,
                                      const Viewer& viewer) {
  if (!scene.contains("enclosure")) {
    return std::nullopt;
  }
  const json& enclosure = scene["enclosure"];
  if (kind_of_enclosure(enclosure) != kFrustum) {
    return cube_of(scene, metres_per_degree);
  }
  return view_frustum(viewer, enclosure["front_deg"].get<double>() * metres_per_degree,
                      enclosure["back_deg"].get<double>() * metres_per_degree);
}

ScreenGeometry screen_for_checks() { return {0.376, 0.301, 1280, 1024, 0.57}; }

void add_enclosure_problems(const json& scene, std::vector<SceneProblem>& problems) {
  if (!scene.contains("enclosure")) {
    return;
  }
  const json& enclosure = scene["enclosure"];
  const std::string kind = kind_of_enclosure(enclosure);
  const auto need = [&](const char* key) {
    if (!enclosure.contains(key)) {
      problems.push_back({"/enclosure", "expected the key \"" + std::string(key) + "\" for kind " +
                                            kind + ", which is missing"});
    }
  };
  const auto refuse = [&](const char* key) {
    if (enclosure.contains(key)) {
      problems.push_back({std::string("/enclosure/") + key,
                          "expected none for kind " + kind + ", got " + enclosure[key].dump()});
    }
  };
  if (kind == kFrustum) {
    need("front_deg");
    need("back_deg");
    refuse("edge_deg");
    refuse("edge_at_count");
  } else {
    need("edge_deg");
    refuse("front_deg");
    refuse("back_deg");
  }
}

}  // namespace impetus::inline scenes
