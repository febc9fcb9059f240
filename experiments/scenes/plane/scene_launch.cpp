// SPDX-License-Identifier: MIT
#include "experiments/scenes/plane/scene_launch.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/scenes/plane/named_body.hpp"

namespace impetus::inline scenes {
namespace {

/// The projected sides of a mesh's triangles: those of its outline are among them.
class Sides {
 public:
  Sides(const TriangleMesh& mesh, const Pose& pose) {
    for (const Vector3& vertex : mesh.vertices) {
      corners_.push_back(pose.position + pose.orientation * vertex);
      heights_m.push_back(corners_.back().y());
    }
    for (const auto& triangle : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        sides_.emplace_back(corners_[triangle[i]], corners_[triangle[(i + 1) % 3]]);
      }
    }
  }

  /// How far they reach at this height, to the right (`sense` 1) or to the left (−1); none where
  /// nothing is.
  [[nodiscard]] std::optional<double> reach_m(double height_m, double sense) const {
    std::optional<double> furthest;
    const auto take = [&](double x_m) {
      furthest = std::max(furthest.value_or(sense * x_m), sense * x_m);
    };
    for (const auto& [from, to] : sides_) {
      if (height_m < std::min(from.y(), to.y()) || height_m > std::max(from.y(), to.y())) {
        continue;
      }
      if (from.y() == to.y()) {
        take(from.x());
        take(to.x());
      } else {
        take(from.x() + (to.x() - from.x()) * ((height_m - from.y()) / (to.y() - from.y())));
      }
    }
    return furthest;
  }

  [[nodiscard]] double width_m() const {
    const auto [least, most] =
        std::minmax_element(corners_.begin(), corners_.end(),
                            [](const Vector3& a, const Vector3& b) { return a.x() < b.x(); });
    return most->x() - least->x();
  }

  std::vector<double> heights_m;  ///< of the corners, between which reaches are straight

 private:
  std::vector<Vector3> corners_;
  std::vector<std::pair<Vector3, Vector3>> sides_;
};

/// How far the first must move along x to touch the second; none when it passes by.
std::optional<double> way_to_touch(const Sides& first, const Sides& second) {
  std::optional<double> way_m;
  const auto measure = [&](double height_m) {
    const auto right_m = first.reach_m(height_m, 1.0);
    const auto left_m = second.reach_m(height_m, -1.0);
    if (right_m && left_m) {
      const double here_m = -*left_m - *right_m;
      way_m = std::min(way_m.value_or(here_m), here_m);
    }
  };
  std::for_each(first.heights_m.begin(), first.heights_m.end(), measure);
  std::for_each(second.heights_m.begin(), second.heights_m.end(), measure);
  return way_m;
}

/// How far it reaches out of the plane.
double thickness_m(const BodyShape& shape) {
  double most_m = 0.0;
  for (const Vector3& vertex : shape.mesh->vertices) {
    most_m = std::max(most_m, std::abs(vertex.z()));
  }
  return most_m;
}

std::pair<std::size_t, std::size_t> pair_of(const Scene& scene) {
  return {place_of_body(scene, scene.launch->first), place_of_body(scene, scene.launch->second)};
}

bool has_outline(const ShapeSettings& shape) {
  return shape.kind == ShapeKind::kDisc || shape.kind == ShapeKind::kPrism ||
         shape.kind == ShapeKind::kBox;
}

/// What is wrong with one of the two.
void add_body_problems(const Scene& scene, const std::string& key, std::size_t place,
                       SceneProblems& problems) {
  const auto bodies = scene.named_bodies();
  const std::string name = "/launch/" + key;
  if (place == bodies.size()) {
    problems.add_got(name, "expected the name of a body");
    return;
  }
  const BodySettings& body = bodies[place];
  const std::string at_body = "/bodies/" + std::to_string(place);
  if (!has_outline(body.shape)) {
    problems.add(
        name, "expected a body that is a disc, a prism or a box, got " + name_of(body.shape.kind));
  }
  if (body.fixed.value_or(false)) {
    problems.add_got(name, "expected a body that is not fixed");
  }
  for (const char* said : {"/velocity_px_s", "/velocity_deg_s", "/spin_deg_s"}) {
    if (problems.says(at_body + said)) {
      problems.add_got(at_body + said, "expected none for a body of the launch");
    }
  }
}

}  // namespace

Launch launch_of(const Scene& scene, double metres_per_degree, double hold_s, SceneBodies& bodies,
                 std::vector<BodyState>& states) {
  const LaunchSettings& said = *scene.launch;
  const double m_per_px = metres_per_degree / scene.plane->px_per_deg;
  Launch launch;
  std::tie(launch.first, launch.second) = pair_of(scene);
  const SineCosine angle = sine_cosine_deg(said.direction_deg);
  launch.along = Vector3(angle.cosine, angle.sine, 0.0);
  launch.speed_deg_s = said.speed_px_s / scene.plane->px_per_deg;
  launch.gap_deg = said.gap_px / scene.plane->px_per_deg;
  launch.hold_s = hold_s;
  const Quaternion to_right = turn_about(2, -said.direction_deg);
  const auto sides_of = [&](std::size_t body) {
    return Sides(*bodies.shapes[body]->mesh,
                 {Vector3::Zero(), to_right * states[body].pose.orientation});
  };
  const Sides of_second = sides_of(launch.second);
  launch.second_width_deg = of_second.width_m() / metres_per_degree;
  const double touching_m = way_to_touch(sides_of(launch.first), of_second).value_or(0.0);
  BodyState& first = states[launch.first];
  first.pose.position =
      states[launch.second].pose.position + (touching_m - said.gap_px * m_per_px) * launch.along;
  if (said.gap_px < 0.0) {  // in front of what it moves over
    first.pose.position.z() +=
        thickness_m(*bodies.shapes[launch.first]) + thickness_m(*bodies.shapes[launch.second]);
  }
  launch.stops = first.pose;
  first.pose.position -= said.speed_px_s * m_per_px * said.lead_s * launch.along;
  bodies.models[launch.first].passes_through = true;
  bodies.models[launch.second].passes_through = true;
  if (said.appears_px) {
    bodies.looks[launch.second].from_s =
        std::max(0.0, scene.showing.still_s + said.lead_s -
                          (*said.appears_px - said.gap_px) / said.speed_px_s);
  }
  return launch;
}

std::vector<ImposedMotion> motions_of(const Scene& scene, const Launch& launch,
                                      double metres_per_degree) {
  const LaunchSettings& said = *scene.launch;
  const double m_per_px = metres_per_degree / scene.plane->px_per_deg;
  const auto at_speed = [&](double px_s) { return Vector3(px_s * m_per_px * launch.along); };
  const auto step_at = [&](double moving_s) {
    return std::llround((scene.showing.still_s + moving_s) * scene.engine.step_hz);
  };
  return {{launch.first, 0, at_speed(said.speed_px_s)},
          {launch.first, step_at(said.lead_s), Vector3::Zero()},
          {launch.second, step_at(said.lead_s + launch.hold_s),
           at_speed(said.second_speed_px_s.value_or(said.speed_px_s))}};
}

void add_launch_problems(const Scene& scene, SceneProblems& problems) {
  if (!scene.launch) {
    return;
  }
  if (!scene.plane) {
    problems.add("/launch", "expected none without a plane, whose pixels it is said in");
  }
  if (scene.meeting) {
    problems.add("/launch", "expected none where two bodies meet");
  }
  if (scene.duration_s) {
    problems.add("/duration_s",
                 "expected none beside a launch, which lasts from lead_s to follow_s");
  }
  if (!scene.imposed || !scene.imposed->contact_hold_ms) {
    problems.add_missing("/imposed", "contact_hold_ms", "for the launch");
  }
  const auto [first, second] = pair_of(scene);
  add_body_problems(scene, "first", first, problems);
  add_body_problems(scene, "second", second, problems);
  if (first == second) {
    problems.add_got("/launch/second", "expected another body than the first");
  }
  if (problems.says("/bodies/" + std::to_string(first) + "/position_px") ||
      problems.says("/bodies/" + std::to_string(first) + "/position_deg")) {
    problems.add("/bodies/" + std::to_string(first),
                 "expected no position for the first body of the launch, which follows from it");
  }
  const double steps = scene.launch->lead_s * scene.engine.step_hz;
  if (std::abs(steps - std::round(steps)) > 1e-9 * steps) {
    problems.add_got("/launch/lead_s", "expected a whole number of steps of 1/" +
                                           problems.written("/engine/step_hz") + " s");
  }
}

}  // namespace impetus::inline scenes
