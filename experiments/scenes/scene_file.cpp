// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_file.hpp"

#include <cmath>
#include <cstdlib>
#include <memory>
#include <utility>

#include "engine/numerics/trigonometry.hpp"
#include "experiments/scenes/embedded_schema.hpp"

namespace impetus {
namespace {

using nlohmann::json;

/// At contact the spheres overlap by this share of their radii: far below a pixel, far above what
/// rounding could make of the way there, so contact falls on its step on every machine.
constexpr double kTouchingOverlap = 1e-9;

std::array<float, 3> parse_colour(const std::string& text) {
  const auto number = static_cast<unsigned>(std::strtoul(text.c_str() + 1, nullptr, 16));
  const auto channel = [number](unsigned shift) {
    return static_cast<float>((number >> shift) & 0xffU) / 255.0F;
  };
  return {channel(16), channel(8), channel(0)};
}

struct MeetingBody {
  BodyModel model;
  BodyState state;
  DrawnBody look;
};

/// `side` is −1 for the body that comes along +x, +1 for the one that comes along −x.
MeetingBody meeting_body(const json& body, const json& meeting, double m_per_deg, double side) {
  const double radius_m = body["shape"]["radius_deg"].get<double>() * m_per_deg;
  const double speed_m_s = meeting["speed_deg_s"].get<double>() * m_per_deg;
  const MassProperties mass = solid_sphere(radius_m, body["density_kg_m3"].get<double>());

  MeetingBody result;
  result.model.name = body["name"].get<std::string>();
  result.model.tree =
      std::make_shared<const VolumeTree>(single_node_tree({Vector3::Zero(), radius_m}));
  result.model.inverse_mass = 1.0 / mass.mass_kg;
  result.model.inverse_inertia = mass.inertia.inverse();
  const double way_m = speed_m_s * meeting["lead_s"].get<double>();
  const double at_contact_m = radius_m * (1.0 - kTouchingOverlap);
  result.state.pose.position = Vector3(side * (at_contact_m + way_m), 0.0, 0.0);
  result.state.linear_momentum = Vector3(-side * speed_m_s * mass.mass_kg, 0.0, 0.0);
  result.look = {result.model.name, radius_m, parse_colour(body["colour"].get<std::string>())};
  return result;
}

double rounded_to_frames(double duration_s, double hz) {
  return std::floor(duration_s * hz + 0.5) / hz;
}

}  // namespace

const json& scene_schema() {
  static const json schema = json::parse(kSceneSchemaText);
  return schema;
}

const std::vector<FrameBoundValue>& frame_bound_values() {
  static const std::vector<FrameBoundValue> values{{"/meeting/lead_s", 1.0, false},
                                                   {"/imposed/contact_hold_ms", 1e-3, true}};
  return values;
}

std::vector<SceneProblem> scene_problems(const json& scene) {
  std::vector<SceneProblem> problems;
  const double step_hz = scene["engine"]["step_hz"].get<double>();
  const double steps = scene["meeting"]["lead_s"].get<double>() * step_hz;
  if (std::abs(steps - std::round(steps)) > 1e-9 * steps) {
    problems.push_back({"/meeting/lead_s", "expected a whole number of steps of 1/" +
                                               scene["engine"]["step_hz"].dump() + " s, got " +
                                               scene["meeting"]["lead_s"].dump()});
  }
  if (scene["bodies"][0]["name"] == scene["bodies"][1]["name"]) {
    problems.push_back({"/bodies/1/name", "expected a name of its own, got " +
                                              scene["bodies"][1]["name"].dump() + " again"});
  }
  return problems;
}

StagedScene build_scene(const json& scene, const ScreenGeometry& screen, double round_hold_to_hz) {
  const double m_per_deg = metres_per_degree(screen.viewing_distance_m);
  const json& meeting = scene["meeting"];
  MeetingBody left = meeting_body(scene["bodies"][0], meeting, m_per_deg, -1.0);
  MeetingBody right = meeting_body(scene["bodies"][1], meeting, m_per_deg, +1.0);

  const double intended_s = scene["imposed"]["contact_hold_ms"].get<double>() / 1e3;
  const double realised_s =
      round_hold_to_hz > 0.0 ? rounded_to_frames(intended_s, round_hold_to_hz) : intended_s;
  const WorldSettings settings{scene["engine"]["restitution"].get<double>(), realised_s};

  StagedScene staged{
      World({std::move(left.model), std::move(right.model)}, {left.state, right.state}, settings),
      viewer_at(screen, scene["viewer"]["azimuth_deg"].get<double>()),
      {std::move(left.look), std::move(right.look)}};
  staged.step_hz = scene["engine"]["step_hz"].get<double>();
  staged.contact_s = meeting["lead_s"].get<double>();
  staged.intended_hold_s = intended_s;
  staged.realised_hold_s = realised_s;
  staged.duration_s = staged.contact_s + realised_s + meeting["follow_s"].get<double>();
  return staged;
}

}  // namespace impetus
