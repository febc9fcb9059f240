// SPDX-License-Identifier: MIT
#include "experiments/scenes/swept_shape.hpp"

#include <string>

#include "engine/shapes/solids/ball_meshes.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

constexpr int kUsualResolution = 4;

bool is_line(const json& shape) {
  return shape["kind"].get<std::string>() == std::string("line-swept");
}

}  // namespace

bool is_swept(const json& shape) {
  return is_line(shape) || shape["kind"].get<std::string>() == std::string("rectangle-swept");
}

SweptShape swept_shape(const json& shape, double metres_per_degree) {
  const auto half_m = [&](const char* key) {
    return 0.5 * shape[key].get<double>() * metres_per_degree;
  };
  const double radius_m = 2.0 * half_m("radius_deg");
  const int cells = 2 * shape.value("resolution", kUsualResolution) - 3;
  const SweptLevels levels{shape.value("coarsest", std::string()) == std::string("sphere"),
                           shape.value("deeper", false)};
  if (is_line(shape)) {
    const double half_y_m = half_m("length_deg");
    return {swept_mesh(0.0, half_y_m, radius_m, cells),
            LineSwept{Vector3::Zero(), half_y_m * Vector3::UnitY(), radius_m}, levels};
  }
  const double half_x_m = half_m("width_deg");
  const double half_y_m = half_m("height_deg");
  return {swept_mesh(half_x_m, half_y_m, radius_m, cells),
          RectangleSwept{Vector3::Zero(), half_x_m * Vector3::UnitX(), half_y_m * Vector3::UnitY(),
                         radius_m},
          levels};
}

}  // namespace impetus::inline scenes
