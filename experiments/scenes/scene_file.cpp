// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/world/starting_overlaps.hpp"
#include "experiments/scenes/crowd.hpp"
#include "experiments/scenes/distractors.hpp"
#include "experiments/scenes/embedded_schema.hpp"
#include "experiments/scenes/figures/figure_crowd.hpp"
#include "experiments/scenes/figures/figure_starts.hpp"
#include "experiments/scenes/figures/scene_figures.hpp"
#include "experiments/scenes/scene_bodies.hpp"
#include "experiments/scenes/scene_enclosure.hpp"
#include "experiments/scenes/scene_meeting.hpp"
#include "experiments/scenes/scene_region.hpp"
#include "experiments/scenes/scene_schedule.hpp"
#include "experiments/scenes/scene_settings.hpp"
#include "experiments/scenes/scene_spin.hpp"
#include "experiments/scenes/scene_timing.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

double rounded_to_frames(double duration_s, double hz) {
  return std::floor(duration_s * hz + 0.5) / hz;
}

std::vector<BodyState> free_states(const json& scene, const SceneBodies& bodies, double m_per_deg) {
  std::vector<BodyState> states;
  const std::size_t named = scene.contains("bodies") ? scene["bodies"].size() : 0;
  for (std::size_t i = 0; i < named; ++i) {
    const json& body = scene["bodies"][i];
    BodyState state;
    state.pose = {vector_of(body, "position_deg", m_per_deg), orientation_of(body)};
    if (bodies.models[i].inverse_mass > 0.0) {
      state.linear_momentum =
          vector_of(body, "velocity_deg_s", m_per_deg) / bodies.models[i].inverse_mass;
    }
    state.angular_momentum = angular_momentum_at(bodies.models[i], state.pose.orientation,
                                                 vector_of(body, "spin_deg_s", kRadiansPerDegree));
    states.push_back(state);
  }
  const double step_s = 1.0 / scene["engine"]["step_hz"].get<double>();
  const std::vector<BodyState> parts = figure_states(scene, bodies, m_per_deg, step_s);
  states.insert(states.end(), parts.begin(), parts.end());
  return states;
}

bool has_crowd(const json& scene) {
  return scene.contains("crowd") || scene.contains("figure_crowd");
}

std::optional<std::vector<BodyState>> crowd_states_of(const json& scene, const SceneBodies& bodies,
                                                      double m_per_deg, const Viewer& viewer,
                                                      const std::string& start) {
  const bool of_figures = scene.contains("figure_crowd");
  const json& crowd = scene[of_figures ? "figure_crowd" : "crowd"];
  const std::string name = "crowd of " + crowd["count"].dump() + "/" + start;
  const Enclosure walls = *enclosure_of(scene, m_per_deg, viewer);
  const CrowdStart how{crowd.value("start", std::uint64_t{1}), name,
                       bodies.models.front().tree->bounding_radius_m(),
                       crowd["speed_deg_s"].get<double>() * m_per_deg,
                       crowd["spin_deg_s"].get<double>() * kRadiansPerDegree};
  return of_figures ? figure_crowd_states(bodies.figures, bodies.models, walls, how)
                    : crowd_states(bodies.models, walls, how);
}

/// The two that meet, then their distractors.
std::vector<BodyState> meeting_states_of(const json& scene, const SceneBodies& bodies,
                                         const Viewer& viewer, double hold_s, std::uint64_t seed) {
  std::vector<BodyState> states = meeting_states(scene, viewer, bodies);
  const auto others = distractor_states(scene, bodies, states, viewer, hold_s, seed);
  if (!others) {
    throw std::runtime_error("the distractors found no room");
  }
  states.insert(states.end(), others->begin(), others->end());
  return states;
}

std::vector<BodyState> states_of(const json& scene, const SceneBodies& bodies, double m_per_deg,
                                 const Viewer& viewer, const std::string& start) {
  if (!has_crowd(scene)) {
    return free_states(scene, bodies, m_per_deg);
  }
  auto states = crowd_states_of(scene, bodies, m_per_deg, viewer, start);
  if (!states) {
    throw std::runtime_error("the crowd found no room to start in");
  }
  return *std::move(states);
}

/// Only crowds are drawn more coarsely than they are simulated.
void add_coarser_meshes(std::vector<DrawnBody>& looks, ShapeLibrary& library) {
  if (!is_crowd(looks.size())) {
    return;
  }
  for (DrawnBody& look : looks) {
    if (look.mesh) {
      look.coarser = library.coarser(look.mesh);
    }
  }
}

void set_timing(const json& scene, StagedScene& staged) {
  staged.step_hz = scene["engine"]["step_hz"].get<double>();
  if (scene.contains("meeting")) {
    staged.contact_s = scene["meeting"]["lead_s"].get<double>();
  }
  staged.duration_s = scene_duration_s(scene, staged.realised_hold_s);
}

/// All but the coarser meshes of a crowd, which only drawing needs.
StagedScene staged_scene(const json& scene, const ScreenGeometry& screen, double round_hold_to_hz,
                         ShapeLibrary& library, const std::string& start, std::uint64_t seed,
                         int deepest_level) {
  const double m_per_deg = metres_per_degree(screen.viewing_distance_m);
  const json& engine = scene["engine"];
  const json imposed = scene.value("imposed", json::object());
  const Viewer viewer = viewer_at(screen, scene["viewer"]["azimuth_deg"].get<double>());
  SceneBodies bodies = bodies_of(scene, m_per_deg, library, deepest_level);
  const double intended_s = intended_hold_s(scene);
  const double realised_s =
      round_hold_to_hz > 0.0 ? rounded_to_frames(intended_s, round_hold_to_hz) : intended_s;
  std::vector<BodyState> states;
  if (scene.contains("meeting")) {
    add_distractors(scene, bodies);
    add_shells(scene, viewer, bodies);
    states = meeting_states_of(scene, bodies, viewer, realised_s, seed);
  } else {
    states = states_of(scene, bodies, m_per_deg, viewer, start);
  }
  WorldSettings settings = engine_settings_of(scene);
  settings.imposed_spin = imposed_spin_of(scene, seed);
  settings.imposed_hold_s = realised_s;
  settings.enclosure = enclosure_of(scene, m_per_deg, viewer);
  settings.schedule = schedule_of(engine, m_per_deg);
  settings.figures = std::move(bodies.figures);

  StagedScene staged{World(std::move(bodies.models), std::move(states), std::move(settings)),
                     viewer, std::move(bodies.looks)};
  staged.no_spin = imposed.value("no_spin", false);
  staged.gaze_latency_s = imposed.value("gaze_latency_ms", 0.0) / 1e3;
  staged.intended_hold_s = intended_s;
  staged.realised_hold_s = realised_s;
  staged.region = region_of(engine, m_per_deg);
  staged.budget = budget_of(engine);
  staged.depends_on_gaze = depends_on_gaze(engine);
  staged.scheduler = scheduler_of(engine);
  staged.turn = {scene["viewer"]["azimuth_deg"].get<double>(),
                 scene["viewer"].value("turn_deg_s", 0.0)};
  staged.metric_options = metric_options_of(engine, m_per_deg);
  staged.reduction = engine.value("contacts", json::object()).value("reduction", "");
  set_timing(scene, staged);
  return staged;
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

StagedScene build_scene(const json& scene, const ScreenGeometry& screen, double round_hold_to_hz,
                        ShapeLibrary& library, const std::string& start, std::uint64_t seed,
                        int deepest_level) {
  StagedScene staged =
      staged_scene(scene, screen, round_hold_to_hz, library, start, seed, deepest_level);
  add_coarser_meshes(staged.looks, library);
  return staged;
}

bool crowd_has_room(const json& scene) {
  constexpr int kRoot = 0;  // it holds the whole body
  ShapeLibrary library;
  const ScreenGeometry screen = screen_for_checks();
  const double m_per_deg = metres_per_degree(screen.viewing_distance_m);
  const Viewer viewer = viewer_at(screen, scene["viewer"]["azimuth_deg"].get<double>());
  const SceneBodies bodies = bodies_of(scene, m_per_deg, library, kRoot);
  constexpr int kStarts = 10;
  for (int repetition = 1; repetition <= kStarts; ++repetition) {
    if (!crowd_states_of(scene, bodies, m_per_deg, viewer, "main/" + std::to_string(repetition))) {
      return false;
    }
  }
  return true;
}

StartingOverlaps starting_overlaps_of(const json& scene) {
  ShapeLibrary library;
  const StagedScene staged = staged_scene(scene, screen_for_checks(), 0.0, library, "check",
                                          /*seed=*/1, kGreatestTreeDepth);
  const World& world = staged.world;
  int coarsest = kUnlimitedLevel;
  for (const PriorityList& list : world.settings().schedule.lists) {
    coarsest = std::min(coarsest, list.greatest_level);
  }
  StartingOverlaps found;
  found.figures = world.settings().figures;
  for (const BodyModel& model : world.models()) {
    found.names.push_back(model.name);
  }
  found.pairs = overlapping_at_start(world, coarsest);
  for (const Figure& figure : found.figures) {
    std::erase_if(found.pairs, [&](const BodyPair& pair) {
      return !is_wall(pair.b) && leaves_out(figure, pair.a, pair.b);
    });
    const auto first = world.states().begin() + figure.first_part;
    std::vector<Pose> poses;
    std::transform(first, first + figure.part_count, std::back_inserter(poses),
                   [](const BodyState& state) { return state.pose; });
    if (const Hinge* folded = folded_hinge(figure, poses)) {
      found.folded.push_back(folded->child);
    }
  }
  return found;
}

}  // namespace impetus::inline scenes
