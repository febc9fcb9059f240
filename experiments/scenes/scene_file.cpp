// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_file.hpp"

#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include "engine/numerics/trigonometry.hpp"
#include "experiments/scenes/embedded_schema.hpp"
#include "experiments/scenes/meeting.hpp"

namespace impetus {
namespace {

using nlohmann::json;

/// At contact the bodies overlap by this share of their distance: far below a pixel, far above what
/// rounding could make of the way there, so contact falls on its step on every machine.
constexpr double kTouchingOverlap = 1e-9;

std::array<float, 3> parse_colour(const std::string& text) {
  const auto number = static_cast<unsigned>(std::strtoul(text.c_str() + 1, nullptr, 16));
  const auto channel = [number](unsigned shift) {
    return static_cast<float>((number >> shift) & 0xffU) / 255.0F;
  };
  return {channel(16), channel(8), channel(0)};
}

Quaternion turned(const json& body) {
  Quaternion orientation = Quaternion::Identity();
  for (const json& turn : body.value("orientation", json::array())) {
    const SineCosine half = sine_cosine_deg(0.5 * turn["angle_deg"].get<double>());
    const auto axis = turn["axis"].get<std::string>();
    const Quaternion one(half.cosine, axis == "x" ? half.sine : 0.0, axis == "y" ? half.sine : 0.0,
                         axis == "z" ? half.sine : 0.0);
    orientation = one * orientation;
  }
  return orientation;
}

double mass_of(const json& body, const BodyShape& shape) {
  return body["density_kg_m3"].get<double>() * shape.unit_mass.mass_kg;
}

BodyModel model_of(const json& body, const BodyShape& shape, bool no_spin) {
  const double density = body["density_kg_m3"].get<double>();
  BodyModel model;
  model.name = body["name"].get<std::string>();
  model.tree = shape.tree;
  model.inverse_mass = 1.0 / mass_of(body, shape);
  if (!no_spin) {
    model.inverse_inertia = Matrix3(density * shape.unit_mass.inertia).inverse();
  }
  return model;
}

DrawnBody look_of(const json& body, const BodyShape& shape) {
  return {body["name"].get<std::string>(), shape.radius_m,
          parse_colour(body["colour"].get<std::string>()), shape.mesh};
}

/// Starts a body `way_m` before the place where it touches, moving there along x.
BodyState on_its_way(double mass_kg, const Quaternion& orientation, double touch_m, double way_m,
                     double speed_m_s) {
  const double side = touch_m < 0.0 ? -1.0 : 1.0;
  BodyState state;
  state.pose = {Vector3(touch_m * (1.0 - kTouchingOverlap) + side * way_m, 0.0, 0.0), orientation};
  state.linear_momentum = Vector3(-side * speed_m_s * mass_kg, 0.0, 0.0);
  return state;
}

/// The level that collisions stop at: the finest unless the scene says otherwise.
Schedule schedule_of(const json& engine) {
  Schedule schedule;
  if (engine.contains("level")) {
    const int level = engine["level"].get<int>();
    schedule.lists.front().least_level = level;
    schedule.lists.front().greatest_level = level;
  }
  return schedule;
}

/// Each kind of shape needs its own measures and takes no other's.
void add_shape_problems(const json& scene, std::vector<SceneProblem>& problems) {
  static const std::map<std::string, std::vector<std::string>> kMeasures{
      {"sphere", {"radius_deg"}}, {"l-block", {"arm_deg", "thickness_deg"}}};
  for (std::size_t i = 0; i < scene["bodies"].size(); ++i) {
    const json& shape = scene["bodies"][i]["shape"];
    const std::string place = "/bodies/" + std::to_string(i) + "/shape";
    const auto kind = shape["kind"].get<std::string>();
    const std::vector<std::string>& measures = kMeasures.at(kind);
    for (const std::string& measure : measures) {
      if (!shape.contains(measure)) {
        problems.push_back({place, "expected the key \"" + measure + "\" for kind " + kind +
                                       ", which is missing"});
        return;
      }
    }
    if (shape.size() != measures.size() + 1) {
      std::string names;
      for (const std::string& measure : measures) {
        names += ", " + measure;
      }
      problems.push_back({place, "expected the measures of kind " + kind + " alone" + names +
                                     ", got " + std::to_string(shape.size() - 1)});
    } else if (kind == "l-block" && shape["thickness_deg"] >= shape["arm_deg"]) {
      problems.push_back({place + "/thickness_deg",
                          "expected less than arm_deg, got " + shape["thickness_deg"].dump()});
    }
  }
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
  add_shape_problems(scene, problems);
  const json& engine = scene["engine"];
  if (engine.contains("level") && engine["level"] > engine.value("tree_depth", 0)) {
    problems.push_back(
        {"/engine/level", "expected at most " + std::to_string(engine.value("tree_depth", 0)) +
                              ", the deepest level of the trees, got " + engine["level"].dump()});
  }
  if (scene["bodies"][0]["name"] == scene["bodies"][1]["name"]) {
    problems.push_back({"/bodies/1/name", "expected a name of its own, got " +
                                              scene["bodies"][1]["name"].dump() + " again"});
  }
  return problems;
}

StagedScene build_scene(const json& scene, const ScreenGeometry& screen, double round_hold_to_hz,
                        ShapeLibrary& library) {
  const double m_per_deg = metres_per_degree(screen.viewing_distance_m);
  const json& engine = scene["engine"];
  const json& meeting = scene["meeting"];
  const bool no_spin = scene["imposed"].value("no_spin", false);
  const int tree_depth = engine.value("tree_depth", 0);

  std::vector<BodyModel> models;
  std::vector<DrawnBody> looks;
  std::vector<double> masses_kg;
  for (const json& body : scene["bodies"]) {
    const BodyShape& shape = library.shape(body["shape"], m_per_deg, tree_depth);
    models.push_back(model_of(body, shape, no_spin));
    looks.push_back(look_of(body, shape));
    masses_kg.push_back(mass_of(body, shape));
  }
  const Quaternion turn_a = turned(scene["bodies"][0]);
  const Quaternion turn_b = turned(scene["bodies"][1]);
  const MeetingPlaces touch = meeting_places(*models[0].tree, turn_a, *models[1].tree, turn_b,
                                             engine.value("level", tree_depth));
  const double speed_m_s = meeting["speed_deg_s"].get<double>() *
                           meeting.value("speed_percent", 100.0) / 100.0 * m_per_deg;
  const double way_m = speed_m_s * meeting["lead_s"].get<double>();
  std::vector<BodyState> states{on_its_way(masses_kg[0], turn_a, touch.a_m, way_m, speed_m_s),
                                on_its_way(masses_kg[1], turn_b, touch.b_m, way_m, speed_m_s)};

  const double intended_s = scene["imposed"]["contact_hold_ms"].get<double>() / 1e3;
  const double realised_s =
      round_hold_to_hz > 0.0 ? rounded_to_frames(intended_s, round_hold_to_hz) : intended_s;
  WorldSettings settings;
  settings.restitution = engine["restitution"].get<double>();
  settings.imposed_hold_s = realised_s;
  settings.schedule = schedule_of(engine);

  StagedScene staged{World(std::move(models), std::move(states), std::move(settings)),
                     viewer_at(screen, scene["viewer"]["azimuth_deg"].get<double>()),
                     std::move(looks)};
  staged.step_hz = engine["step_hz"].get<double>();
  staged.contact_s = meeting["lead_s"].get<double>();
  staged.no_spin = no_spin;
  staged.intended_hold_s = intended_s;
  staged.realised_hold_s = realised_s;
  staged.duration_s = staged.contact_s + realised_s + meeting["follow_s"].get<double>();
  return staged;
}

}  // namespace impetus
