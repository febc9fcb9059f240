// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/numerics/random_stream.hpp"
#include "engine/world/starting_overlaps.hpp"
#include "experiments/scenes/crowd.hpp"
#include "experiments/scenes/distractors.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/figures/scene_figures.hpp"
#include "experiments/scenes/plane/scene_goal.hpp"
#include "experiments/scenes/plane/scene_launch.hpp"
#include "experiments/scenes/scene_appearance.hpp"
#include "experiments/scenes/scene_bodies.hpp"
#include "experiments/scenes/scene_enclosure.hpp"
#include "experiments/scenes/scene_meeting.hpp"
#include "experiments/scenes/showing/scene_showing.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline scenes {
namespace {

double rounded_to_frames(double duration_s, double hz) {
  return std::floor(duration_s * hz + 0.5) / hz;
}

/// "... on a screen of 37.6 cm x 30.1 cm seen from 57 cm, got 250"
[[noreturn]] void refuse_start(const std::string& pointer, const std::string& what,
                               const std::string& limit, const ScreenGeometry& screen,
                               std::size_t count) {
  const std::string of_screen =
      printed(" on a screen of %g cm x %g cm seen from %g cm", 100.0 * screen.width_m,
              100.0 * screen.height_m, 100.0 * screen.viewing_distance_m);
  throw NoRoom(pointer, "expected as many " + what + " as " + limit + of_screen + ", got " +
                            std::to_string(count));
}

std::vector<BodyState> free_states(const Scene& scene, const SceneBodies& bodies,
                                   double m_per_deg) {
  const Vector3 none = Vector3::Zero();
  std::vector<BodyState> states;
  const auto named = scene.named_bodies();
  for (std::size_t i = 0; i < named.size(); ++i) {
    const BodySettings& body = named[i];
    const BodyModel& model = bodies.models[i];
    BodyState state;
    state.pose = {m_per_deg * body.position_deg.value_or(none), body.orientation};
    if (model.inverse_mass > 0.0) {
      state.linear_momentum = m_per_deg * body.velocity_deg_s.value_or(none) / model.inverse_mass;
    }
    state.angular_momentum = angular_momentum_at(
        model, state.pose.orientation, kRadiansPerDegree * body.spin_deg_s.value_or(none));
    states.push_back(state);
  }
  const std::vector<BodyState> parts =
      figure_states(scene, bodies, m_per_deg, 1.0 / scene.engine.step_hz);
  states.insert(states.end(), parts.begin(), parts.end());
  return states;
}

CrowdStart crowd_start_of(const Scene& scene, const SceneBodies& bodies, double m_per_deg,
                          const std::string& start) {
  const CrowdSettings& crowd = scene.any_crowd();
  return {crowd.start, "crowd of " + std::to_string(crowd.count) + "/" + start,
          bodies.models.front().tree->bounding_radius_m(), crowd.speed_deg_s * m_per_deg,
          crowd.spin_deg_s * kRadiansPerDegree};
}

std::optional<std::vector<BodyState>> crowd_states_of(const Scene& scene, const SceneBodies& bodies,
                                                      double m_per_deg, const Viewer& viewer,
                                                      const std::string& start) {
  const Enclosure walls = *enclosure_of(scene, m_per_deg, viewer);
  const CrowdStart how = crowd_start_of(scene, bodies, m_per_deg, start);
  return scene.figure_crowd ? figure_crowd_states(bodies.figures, bodies.models, walls, how)
                            : crowd_states(bodies.models, walls, how);
}

/// The two that meet, then their distractors.
std::vector<BodyState> meeting_states_of(const Scene& scene, const SceneBodies& bodies,
                                         const Viewer& viewer, double hold_s, std::uint64_t seed) {
  std::vector<BodyState> states = meeting_states(scene, viewer, bodies);
  const auto others = distractor_states(scene, bodies, states, viewer, hold_s, seed);
  if (!others) {
    refuse_start("/distractors/count", "bodies", "there is room for beside the two", viewer.screen,
                 bodies.models.size() - states.size());
  }
  states.insert(states.end(), others->begin(), others->end());
  return states;
}

/// Where nothing meets.
std::vector<BodyState> starting_states(const Scene& scene, const SceneBodies& bodies,
                                       double m_per_deg, const Viewer& viewer,
                                       const std::string& start) {
  if (!scene.has_crowd()) {
    return free_states(scene, bodies, m_per_deg);
  }
  auto states = crowd_states_of(scene, bodies, m_per_deg, viewer, start);
  if (!states) {
    refuse_start(scene.crowd ? "/crowd/count" : "/figure_crowd/count",
                 scene.crowd ? "bodies" : "figures", "the enclosure has room for", viewer.screen,
                 scene.any_crowd().count);
  }
  return *std::move(states);
}

Vector3 drawn_spin(const SpinLimits& limits, RandomStream& stream) {
  Vector3 spin;
  for (int i = 0; i < 3; ++i) {
    const double least = limits.least_rad_s[i];
    spin[i] = least + (limits.most_rad_s[i] - least) * stream.uniform();
  }
  return spin;
}

/// What /imposed/random_spin imposes in the trial of this seed: each component uniform between its
/// limits, from a stream of its own; none where it is left out or off.
std::optional<ImposedSpinRule> imposed_spin_of(const Scene& scene, std::uint64_t seed) {
  if (!scene.imposed || !scene.imposed->random_spin || !scene.imposed->random_spin->on) {
    return std::nullopt;
  }
  const RandomSpin& rule = *scene.imposed->random_spin;
  RandomStream stream(seed, "random spin");
  const Vector3 a = drawn_spin(rule.a, stream);
  const Vector3 b = drawn_spin(rule.b, stream);
  return ImposedSpinRule{rule.at_level, {a, b}};
}

/// What /imposed/rebound imposes, in the plane of the viewer's screen; none where it is left out.
std::optional<ImposedRebound> imposed_rebound_of(const Scene& scene, const Viewer& viewer) {
  if (!scene.imposed || !scene.imposed->rebound) {
    return std::nullopt;
  }
  using Change = ReboundSettings::Change;
  const auto& [change, amount] = *scene.imposed->rebound;
  ImposedRebound rebound{.axis = viewer.right.cross(viewer.up)};
  switch (change) {
    case Change::kWider:
      rebound.wider_deg = amount;
      break;
    case Change::kNarrower:
      rebound.wider_deg = -amount;
      break;
    case Change::kFaster:
      rebound.speed_ratio = 1.0 + amount / 100.0;
      break;
    case Change::kSlower:
      rebound.speed_ratio = 1.0 - amount / 100.0;
      break;
  }
  return rebound;
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

/// All but what only drawing needs: the scene's appearance, and a crowd's coarser meshes.
StagedScene staged_scene(const Scene& scene, const ScreenGeometry& screen, double round_hold_to_hz,
                         ShapeLibrary& library, const std::string& start, std::uint64_t seed,
                         int deepest_level) {
  const double m_per_deg = metres_per_degree(screen.viewing_distance_m);
  const EngineSettings& engine = scene.engine;
  const Viewer viewer = scene.viewer_on(screen);
  SceneBodies bodies = bodies_of(scene, m_per_deg, library, deepest_level);
  const double intended_s = scene.intended_hold_s();
  const double realised_s =
      round_hold_to_hz > 0.0 ? rounded_to_frames(intended_s, round_hold_to_hz) : intended_s;
  std::vector<BodyState> states;
  if (scene.meeting) {
    add_distractors(scene, bodies);
    add_shells(scene, viewer, bodies);
    states = meeting_states_of(scene, bodies, viewer, realised_s, seed);
  } else {
    states = starting_states(scene, bodies, m_per_deg, viewer, start);
  }
  std::optional<Launch> launch;
  if (scene.launch) {
    launch = launch_of(scene, m_per_deg, realised_s, bodies, states);
  }
  WorldSettings settings = world_settings_of(scene);
  settings.imposed_spin = imposed_spin_of(scene, seed);
  settings.imposed_rebound = imposed_rebound_of(scene, viewer);
  settings.imposed_hold_s = realised_s;
  settings.enclosure = enclosure_of(scene, m_per_deg, viewer);
  settings.schedule = schedule_of(engine, m_per_deg, bodies.models.size());
  settings.figures = std::move(bodies.figures);

  StagedScene staged{World(std::move(bodies.models), std::move(states), std::move(settings)),
                     viewer, std::move(bodies.looks)};
  staged.start = staged.world.states();
  if (launch) {
    staged.imposed_motions = motions_of(scene, *launch, m_per_deg);
  }
  staged.launch = launch;
  staged.step_hz = engine.step_hz;
  apply_showing(scene, realised_s, staged);
  staged.sound = sound_of(scene);
  staged.goal = goal_of(scene, m_per_deg);
  staged.contact_s = scene.meeting_s() > 0.0 ? staged.still_s + scene.meeting_s() : 0.0;
  staged.intended_hold_s = intended_s;
  staged.no_spin = scene.no_spin();
  staged.realised_hold_s = realised_s;
  staged.region = region_of(engine, m_per_deg);
  staged.budget = budget_of(engine);
  staged.depends_on_gaze = depends_on_gaze(engine);
  staged.scheduler = engine.scheduler();
  staged.metric_options = metric_options_of(engine, m_per_deg, staged.world.models().size());
  staged.reduction = engine.contacts.reduction;
  staged.turn = {scene.viewer.azimuth_deg, scene.viewer.turn_deg_s, scene.viewer.elevation_deg};
  staged.gaze_latency_s = scene.imposed ? scene.imposed->gaze_latency_ms / 1e3 : 0.0;
  return staged;
}

}  // namespace

const std::vector<FrameBoundValue>& frame_bound_values() {
  static const std::vector<FrameBoundValue> values{{"/still_s", 1.0, false},
                                                   {"/meeting/lead_s", 1.0, false},
                                                   {"/launch/lead_s", 1.0, false},
                                                   {"/imposed/contact_hold_ms", 1e-3, true}};
  return values;
}

StagedScene build_scene(const Scene& scene, const ScreenGeometry& screen, double round_hold_to_hz,
                        ShapeLibrary& library, const std::string& start, std::uint64_t seed,
                        int deepest_level) {
  StagedScene staged =
      staged_scene(scene, screen, round_hold_to_hz, library, start, seed, deepest_level);
  apply_appearance(scene, metres_per_degree(screen.viewing_distance_m), staged);
  add_coarser_meshes(staged.looks, library);
  return staged;
}

CrowdProblem problem_of_crowd(const Scene& scene, ShapeLibrary& library) {
  constexpr int kRoot = 0;  // it holds the whole body
  const ScreenGeometry screen = screen_for_checks();
  const double m_per_deg = metres_per_degree(screen.viewing_distance_m);
  const Viewer viewer = scene.viewer_on(screen);
  const SceneBodies bodies = bodies_of(scene, m_per_deg, library, kRoot);
  constexpr int kStarts = 10;
  for (int repetition = 1; repetition <= kStarts; ++repetition) {
    const std::string start = "main/" + std::to_string(repetition);
    if (!crowd_states_of(scene, bodies, m_per_deg, viewer, start)) {
      const bool can_stand =
          scene.crowd || has_posture(bodies.figures.front(), bodies.models,
                                     crowd_start_of(scene, bodies, m_per_deg, start));
      return can_stand ? CrowdProblem::kNoRoom : CrowdProblem::kNoPosture;
    }
  }
  return CrowdProblem::kNone;
}

StartingOverlaps starting_overlaps_of(const Scene& scene, ShapeLibrary& library) {
  const StagedScene staged = staged_scene(scene, screen_for_checks(), 0.0, library, "check",
                                          /*seed=*/1, kGreatestTreeDepth);
  const World& world = staged.world;
  int coarsest = kUnlimitedLevel;
  for (const PriorityList& list : world.settings().schedule.lists) {
    coarsest = std::min(coarsest, list.greatest_level);
  }
  StartingOverlaps found;
  found.figures = world.settings().figures;
  found.names = body_names(world);
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
