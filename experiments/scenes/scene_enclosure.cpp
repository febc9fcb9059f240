// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_enclosure.hpp"

#include <string>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline scenes {
namespace {

ClosedCube cube_of(const Scene& scene, double metres_per_degree) {
  const EnclosureSettings& enclosure = *scene.enclosure;
  double edge_m = *enclosure.edge_deg * metres_per_degree;
  if (scene.has_crowd() && enclosure.edge_at_count) {
    edge_m *= cube_root(static_cast<double>(scene.any_crowd().count) / *enclosure.edge_at_count);
  }
  return {0.5 * edge_m};
}

}  // namespace

std::optional<Enclosure> enclosure_of(const Scene& scene, double metres_per_degree,
                                      const Viewer& viewer) {
  if (!scene.enclosure) {
    return std::nullopt;
  }
  if (scene.enclosure->kind == EnclosureKind::kClosedCube) {
    return cube_of(scene, metres_per_degree);
  }
  return view_frustum(viewer, *scene.enclosure->front_deg * metres_per_degree,
                      *scene.enclosure->back_deg * metres_per_degree);
}

ScreenGeometry screen_for_checks() { return {0.376, 0.301, 1280, 1024, 0.57}; }

void add_enclosure_problems(const Scene& scene, SceneProblems& problems) {
  if (!scene.enclosure) {
    return;
  }
  const EnclosureSettings& enclosure = *scene.enclosure;
  const std::string why = "for kind " + name_of(enclosure.kind);
  const auto need = [&](const char* key, bool is_said) {
    if (!is_said) {
      problems.add_missing("/enclosure", key, why);
    }
  };
  const auto refuse = [&](const std::string& key, bool is_said) {
    if (is_said) {
      problems.add_got("/enclosure/" + key, "expected none " + why);
    }
  };
  if (enclosure.kind == EnclosureKind::kViewFrustum) {
    need("front_deg", enclosure.front_deg.has_value());
    need("back_deg", enclosure.back_deg.has_value());
    refuse("edge_deg", enclosure.edge_deg.has_value());
    refuse("edge_at_count", enclosure.edge_at_count.has_value());
  } else {
    need("edge_deg", enclosure.edge_deg.has_value());
    refuse("front_deg", enclosure.front_deg.has_value());
    refuse("back_deg", enclosure.back_deg.has_value());
  }
}

}  // namespace impetus::inline scenes
