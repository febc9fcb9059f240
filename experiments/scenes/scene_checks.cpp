// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_checks.hpp"

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "experiments/record/wall_names.hpp"
#include "experiments/scenes/crowd.hpp"
#include "experiments/scenes/distractors.hpp"
#include "experiments/scenes/engine_checks.hpp"
#include "experiments/scenes/figures/figure_checks.hpp"
#include "experiments/scenes/plane/scene_goal.hpp"
#include "experiments/scenes/plane/scene_launch.hpp"
#include "experiments/scenes/scene_appearance.hpp"
#include "experiments/scenes/scene_enclosure.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/scenes/scene_limits.hpp"
#include "experiments/scenes/scene_meeting.hpp"
#include "experiments/scenes/showing/scene_showing.hpp"
#include "experiments/scenes/showing/sound_settings.hpp"

namespace impetus::inline scenes {
namespace {

/// Of what is named one by one at `place`: bodies or figures.
template <typename Entries>
void add_name_problems(const Entries& entries, const std::string& list, SceneProblems& problems) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string place = list + "/" + std::to_string(i) + "/name";
    if (!names.insert(entries[i].name).second) {
      problems.add(place, "expected a name of its own, got " + problems.written(place) + " again");
    }
    if (entries[i].name.starts_with(kWallPrefix)) {
      problems.add_got(place, "expected a name that is no wall's");
    }
  }
}

void require_key(bool is_said, const std::string& key, const std::string& why,
                 SceneProblems& problems) {
  if (!is_said) {
    problems.add_missing("", key, why);
  }
}

void refuse_key(bool is_said, const std::string& key, const std::string& why,
                SceneProblems& problems) {
  if (is_said) {
    problems.add("/" + key, "expected none " + why);
  }
}

void add_order_problems(const SpinLimits& limits, const std::string& place,
                        SceneProblems& problems) {
  for (int i = 0; i < 3; ++i) {
    const std::string component = "/" + std::to_string(i);
    if (limits.most_rad_s[i] < limits.least_rad_s[i]) {
      problems.add_got(place + "/most_rad_s" + component,
                       "expected at least least_rad_s, which is " +
                           problems.written(place + "/least_rad_s" + component));
    }
  }
}

void add_random_spin_problems(const Scene& scene, SceneProblems& problems) {
  if (!scene.imposed || !scene.imposed->random_spin) {
    return;
  }
  const RandomSpin& rule = *scene.imposed->random_spin;
  const std::string place = "/imposed/random_spin";
  if (!scene.meeting) {
    problems.add(place, "expected none where no two bodies meet");
    return;
  }
  add_order_problems(rule.a, place + "/a", problems);
  add_order_problems(rule.b, place + "/b", problems);
  if (rule.on && scene.no_spin()) {
    problems.add(place + "/on", "expected false where no_spin keeps bodies from turning");
  }
}

void add_rebound_problems(const Scene& scene, SceneProblems& problems) {
  if (!scene.imposed || !scene.imposed->rebound) {
    return;
  }
  const ReboundSettings& rebound = *scene.imposed->rebound;
  const std::string place = "/imposed/rebound";
  if (!scene.meeting) {
    problems.add(place, "expected none where no two bodies meet");
  } else if (rebound.change == ReboundSettings::Change::kSlower && rebound.amount > 100.0) {
    problems.add_got(place + "/amount", "expected 100 percent slower at most");
  }
}

void add_meeting_problems(const Scene& scene, SceneProblems& problems) {
  const std::string why = "where bodies meet";
  require_key(scene.imposed.has_value(), "imposed", why, problems);
  if (scene.imposed && !scene.imposed->contact_hold_ms) {
    problems.add_missing("/imposed", "contact_hold_ms", "");
  }
  refuse_key(scene.duration_s.has_value(), "duration_s",
             why + ", which lasts from lead_s to follow_s", problems);
  refuse_key(scene.enclosure.has_value(), "enclosure", why, problems);
  refuse_key(scene.figures.has_value(), "figures", why, problems);
  const std::vector<BodySettings>& bodies = *scene.bodies;
  if (bodies.size() != 2) {
    problems.add("/bodies", "expected two bodies that meet, got " + std::to_string(bodies.size()));
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string place = "bodies/" + std::to_string(i) + "/";
    for (const char* key : {"position_deg", "position_px", "velocity_deg_s", "velocity_px_s"}) {
      refuse_key(problems.says("/" + place + key), place + key, why, problems);
    }
    refuse_key(bodies[i].spin_deg_s.has_value(), place + "spin_deg_s", why, problems);
    refuse_key(bodies[i].fixed.has_value(), place + "fixed", why, problems);
  }
  const double steps = scene.meeting->lead_s * scene.engine.step_hz;
  if (std::abs(steps - std::round(steps)) > 1e-9 * steps) {
    problems.add_got("/meeting/lead_s", "expected a whole number of steps of 1/" +
                                            problems.written("/engine/step_hz") + " s");
  }
}

/// Of bodies or of figures.
void add_crowd_problems(const Scene& scene, ShapeLibrary& library, SceneProblems& problems) {
  require_key(scene.enclosure.has_value(), "enclosure", "for a crowd", problems);
  require_key(scene.duration_s.has_value(), "duration_s", "for a crowd", problems);
  const std::string why = "beside a crowd";
  refuse_key(scene.bodies.has_value(), "bodies", why, problems);
  refuse_key(scene.meeting.has_value(), "meeting", why, problems);
  refuse_key(scene.distractors.has_value(), "distractors", why, problems);
  refuse_key(scene.figures.has_value(), "figures", why, problems);
  if (!problems.empty()) {
    return;
  }
  switch (problem_of_crowd(scene, library)) {
    case CrowdProblem::kNone:
      break;
    case CrowdProblem::kNoRoom:
      problems.add_got(scene.crowd ? "/crowd/count" : "/figure_crowd/count",
                       std::string("expected as many ") + (scene.crowd ? "bodies" : "figures") +
                           " as the enclosure has room for");
      break;
    case CrowdProblem::kNoPosture:
      problems.add("/figure_crowd/figure",
                   "expected parts that can be apart from each other, but at the coarsest level of "
                   "their trees some overlap in each of " +
                       std::to_string(kMostDraws) +
                       " postures: \"coarsest\": \"volume\" lets them lie closer, "
                       "\"self_collision\": {\"others\": false} lets them overlap");
      break;
  }
}

void add_free_problems(const Scene& scene, SceneProblems& problems) {
  if (!scene.launch) {
    require_key(scene.duration_s.has_value(), "duration_s", "where nothing meets", problems);
  }
  const auto bodies = scene.named_bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodySettings& body = bodies[i];
    const std::string place = "/bodies/" + std::to_string(i);
    if (!body.position_deg) {
      problems.add_missing(place, "position_deg", "where nothing meets");
    }
    const auto refuse_moving = [&](const std::string& key, bool is_said) {
      if (is_said && body.fixed.value_or(false)) {
        problems.add_got(place + "/" + key, "expected none for a body that is fixed");
      }
    };
    refuse_moving(body.velocity_px_s ? "velocity_px_s" : "velocity_deg_s",
                  body.velocity_deg_s.has_value());
    refuse_moving("spin_deg_s", body.spin_deg_s.has_value());
  }
  refuse_key(scene.distractors.has_value(), "distractors", "where no two bodies meet", problems);
  refuse_key(scene.enclosure && scene.enclosure->edge_at_count, "enclosure/edge_at_count",
             "without a crowd", problems);
}

const std::string kWithoutPixels = "without a plane that has pixels";

void add_px_problem(const Scene& scene, const ShapeSettings& shape, const std::string& place,
                    SceneProblems& problems) {
  if (shape.has_px && !scene.plane) {
    problems.add(place, "expected no measures in pixels " + kWithoutPixels);
  }
}

/// Adds what is said in pixels without a plane, or in degrees as well.
void add_plane_problems(const Scene& scene, SceneProblems& problems) {
  if (scene.crowd) {
    add_px_problem(scene, scene.crowd->shape, "/crowd/shape", problems);
  }
  const auto bodies = scene.named_bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string place = "/bodies/" + std::to_string(i);
    add_px_problem(scene, bodies[i].shape, place + "/shape", problems);
    for (const auto& [px, deg] :
         {std::pair("position_px", "position_deg"), std::pair("velocity_px_s", "velocity_deg_s")}) {
      const std::string in_px = place + "/" + px;
      if (problems.says(in_px) && !scene.plane) {
        problems.add_got(in_px, "expected none " + kWithoutPixels);
      } else if (problems.says(in_px) && problems.says(place + "/" + deg)) {
        problems.add_got(in_px, std::string("expected none beside ") + deg);
      }
    }
  }
}

/// Of each part of the scene by itself.
void add_part_problems(const Scene& scene, SceneProblems& problems) {
  add_schedule_problems(scene.engine, problems);
  add_region_problems(scene.engine, problems);
  add_material_problems(scene, problems);
  add_budget_problems(scene.engine, problems);
  add_enclosure_problems(scene, problems);
  add_tree_problems(scene.engine, problems);
  add_random_spin_problems(scene, problems);
  add_rebound_problems(scene, problems);
  add_appearance_problems(scene, problems);
  add_plane_problems(scene, problems);
  add_goal_problems(scene, problems);
  add_launch_problems(scene, problems);
  add_showing_problems(scene, problems);
  add_sound_problems(scene, problems);
  if (scene.has_figures()) {
    add_figure_problems(scene, problems);
  }
}

/// Of a scene with a crowd.
void add_problems_of_crowd(const Scene& scene, ShapeLibrary& library, SceneProblems& problems) {
  if (scene.crowd) {
    add_shape_problems(scene.crowd->shape, scene.meshes, "/crowd/shape",
                       suffix_of(scene.crowd->shape), problems);
    refuse_key(scene.figure_crowd.has_value(), "figure_crowd", "beside a crowd", problems);
  }
  if (problems.empty()) {
    add_limit_problems(scene, library, problems);
  }
  if (problems.empty()) {
    add_crowd_problems(scene, library, problems);
  }
}

/// Of a scene whose bodies and figures are named.
void add_problems_of_named(const Scene& scene, ShapeLibrary& library, SceneProblems& problems) {
  const auto bodies = scene.named_bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    add_shape_problems(bodies[i].shape, scene.meshes, "/bodies/" + std::to_string(i) + "/shape",
                       suffix_of(bodies[i].shape), problems);
  }
  if (problems.empty()) {
    add_limit_problems(scene, library, problems);
  }
  add_name_problems(bodies, "/bodies", problems);
  add_name_problems(scene.named_figures(), "/figures", problems);
  if (!scene.meeting) {
    add_free_problems(scene, problems);
    if (problems.empty()) {
      add_overlap_problems(scene, library, problems);
    }
    return;
  }
  if (!scene.bodies) {
    problems.add("/meeting", "expected none without bodies");
    return;
  }
  add_meeting_problems(scene, problems);
  if (problems.empty()) {
    add_touching_problems(scene, library, problems);
  }
  if (problems.empty()) {
    add_distractor_problems(scene, library, problems);
  }
}

}  // namespace

std::vector<SceneProblem> scene_problems(const nlohmann::json& scene, ShapeLibrary& library) {
  const Scene settings(scene);
  SceneProblems problems(scene);
  add_part_problems(settings, problems);
  if (settings.has_crowd()) {
    add_problems_of_crowd(settings, library, problems);
  } else if (!settings.bodies && !settings.figures) {
    problems.add("",
                 "expected one of the keys \"bodies\", \"figures\", \"crowd\" and "
                 "\"figure_crowd\", all are missing");
  } else {
    add_problems_of_named(settings, library, problems);
  }
  return problems.list();
}

std::vector<SceneProblem> scene_problems(const nlohmann::json& scene) {
  ShapeLibrary library;
  return scene_problems(scene, library);
}

}  // namespace impetus::inline scenes
