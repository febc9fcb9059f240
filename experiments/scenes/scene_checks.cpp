// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_checks.hpp"

#include <cmath>
#include <set>
#include <utility>

#include "experiments/record/wall_names.hpp"
#include "experiments/scenes/distractors.hpp"
#include "experiments/scenes/figures/scene_figure_checks.hpp"
#include "experiments/scenes/scene_enclosure.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/scenes/scene_limits.hpp"
#include "experiments/scenes/scene_meeting.hpp"
#include "experiments/scenes/scene_region.hpp"
#include "experiments/scenes/scene_schedule.hpp"
#include "experiments/scenes/scene_settings.hpp"
#include "experiments/scenes/scene_spin.hpp"
#include "experiments/scenes/scene_tree.hpp"
#include "experiments/scenes/shape_checks.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;
using Problems = std::vector<SceneProblem>;

/// Of what `list` names one by one: bodies or figures.
void add_name_problems(const json& scene, const std::string& list, Problems& problems) {
  const json entries = scene.value(list, json::array());
  std::set<std::string> names;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto name = entries[i]["name"].get<std::string>();
    const std::string place = "/" + list + "/" + std::to_string(i) + "/name";
    if (!names.insert(name).second) {
      problems.push_back(
          {place, "expected a name of its own, got " + json(name).dump() + " again"});
    }
    if (name.starts_with(kWallPrefix)) {
      problems.push_back({place, "expected a name that is no wall's, got " + json(name).dump()});
    }
  }
}

void require_key(const json& scene, const char* key, const std::string& why, Problems& problems) {
  if (!scene.contains(key)) {
    problems.push_back(
        {"", "expected the key \"" + std::string(key) + "\" " + why + ", which is missing"});
  }
}

void refuse_key(const json& scene, const char* key, const std::string& why, Problems& problems) {
  if (scene.contains(key)) {
    problems.push_back({"/" + std::string(key), "expected none " + why});
  }
}

void add_meeting_problems(const json& scene, Problems& problems) {
  const std::string why = "where bodies meet";
  require_key(scene, "imposed", why, problems);
  if (scene.contains("imposed") && !scene["imposed"].contains("contact_hold_ms")) {
    problems.push_back({"/imposed", "expected the key \"contact_hold_ms\", which is missing"});
  }
  refuse_key(scene, "duration_s", why + ", which lasts from lead_s to follow_s", problems);
  refuse_key(scene, "enclosure", why, problems);
  refuse_key(scene, "figures", why, problems);
  if (scene["bodies"].size() != 2) {
    problems.push_back({"/bodies", "expected two bodies that meet, got " +
                                       std::to_string(scene["bodies"].size())});
  }
  for (std::size_t i = 0; i < scene["bodies"].size(); ++i) {
    for (const char* key : {"position_deg", "velocity_deg_s", "spin_deg_s", "fixed"}) {
      if (scene["bodies"][i].contains(key)) {
        problems.push_back({"/bodies/" + std::to_string(i) + "/" + key, "expected none " + why});
      }
    }
  }
  const double step_hz = scene["engine"]["step_hz"].get<double>();
  const double steps = scene["meeting"]["lead_s"].get<double>() * step_hz;
  if (std::abs(steps - std::round(steps)) > 1e-9 * steps) {
    problems.push_back({"/meeting/lead_s", "expected a whole number of steps of 1/" +
                                               scene["engine"]["step_hz"].dump() + " s, got " +
                                               scene["meeting"]["lead_s"].dump()});
  }
}

/// `crowd` is the key of one of bodies or of figures.
void add_crowd_problems(const json& scene, const std::string& crowd, Problems& problems) {
  require_key(scene, "enclosure", "for a crowd", problems);
  require_key(scene, "duration_s", "for a crowd", problems);
  for (const char* key : {"bodies", "meeting", "distractors", "figures"}) {
    refuse_key(scene, key, "beside a crowd", problems);
  }
  if (problems.empty() && !crowd_has_room(scene)) {
    const std::string what = scene.contains("crowd") ? "bodies" : "figures";
    problems.push_back({"/" + crowd + "/count", "expected as many " + what +
                                                    " as the enclosure has room for, got " +
                                                    scene[crowd]["count"].dump()});
  }
}

void add_free_problems(const json& scene, Problems& problems) {
  require_key(scene, "duration_s", "where nothing meets", problems);
  const json bodies = scene.value("bodies", json::array());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const json& body = bodies[i];
    const std::string place = "/bodies/" + std::to_string(i);
    if (!body.contains("position_deg")) {
      problems.push_back(
          {place, "expected the key \"position_deg\" where nothing meets, which is missing"});
    }
    for (const char* key : {"velocity_deg_s", "spin_deg_s"}) {
      if (body.value("fixed", false) && body.contains(key)) {
        problems.push_back(
            {place + "/" + key, "expected none for a body that is fixed, got " + body[key].dump()});
      }
    }
  }
  if (scene.contains("distractors")) {
    problems.push_back({"/distractors", "expected none where no two bodies meet"});
  }
  if (scene.contains("enclosure") && scene["enclosure"].contains("edge_at_count")) {
    problems.push_back({"/enclosure/edge_at_count", "expected none without a crowd"});
  }
}

}  // namespace

std::vector<SceneProblem> scene_problems(const json& scene) {
  Problems problems = schedule_problems(scene["engine"]);
  add_region_problems(scene["engine"], problems);
  for (SceneProblem& problem : engine_problems(scene)) {
    problems.push_back(std::move(problem));
  }
  add_enclosure_problems(scene, problems);
  add_tree_problems(scene["engine"], problems);
  for (SceneProblem& problem : spin_problems(scene)) {
    problems.push_back(std::move(problem));
  }
  const json meshes = scene.value("meshes", json::object());
  if (has_figures(scene)) {
    add_figure_problems(scene, problems);
  }
  if (scene.contains("crowd")) {
    add_shape_problems(scene["crowd"]["shape"], meshes, "/crowd/shape", problems);
    refuse_key(scene, "figure_crowd", "beside a crowd", problems);
  }
  if (scene.contains("crowd") || scene.contains("figure_crowd")) {
    if (problems.empty()) {
      problems = limit_problems(scene);
    }
    if (problems.empty()) {
      add_crowd_problems(scene, scene.contains("crowd") ? "crowd" : "figure_crowd", problems);
    }
    return problems;
  }
  if (!scene.contains("bodies") && !scene.contains("figures")) {
    problems.push_back({"",
                        "expected one of the keys \"bodies\", \"figures\", \"crowd\" and "
                        "\"figure_crowd\", all are "
                        "missing"});
    return problems;
  }
  const json bodies = scene.value("bodies", json::array());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    add_shape_problems(bodies[i]["shape"], meshes, "/bodies/" + std::to_string(i) + "/shape",
                       problems);
  }
  if (problems.empty()) {
    problems = limit_problems(scene);
  }
  add_name_problems(scene, "bodies", problems);
  add_name_problems(scene, "figures", problems);
  if (scene.contains("meeting")) {
    if (!scene.contains("bodies")) {
      problems.push_back({"/meeting", "expected none without bodies"});
      return problems;
    }
    add_meeting_problems(scene, problems);
    if (problems.empty()) {
      problems = meeting_problems(scene);
    }
    if (problems.empty()) {
      problems = distractor_problems(scene);
    }
    return problems;
  }
  add_free_problems(scene, problems);
  if (problems.empty()) {
    add_overlap_problems(scene, problems);
  }
  return problems;
}

}  // namespace impetus::inline scenes
