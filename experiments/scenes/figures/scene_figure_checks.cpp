// SPDX-License-Identifier: MIT
#include "experiments/scenes/figures/scene_figure_checks.hpp"

#include <set>

#include "experiments/scenes/figures/figure_checks.hpp"
#include "experiments/scenes/figures/figure_files.hpp"
#include "experiments/scenes/figures/figure_motion.hpp"
#include "experiments/scenes/scene_file.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;
using Problems = std::vector<SceneProblem>;

constexpr std::size_t kMostBodies = 1000;

std::string place_of(std::size_t figure) { return "/figures/" + std::to_string(figure); }

/// Manipulations of one body's collisions say nothing of a figure's.
void add_imposed_problems(const json& scene, Problems& problems) {
  const json imposed = scene.value("imposed", json::object());
  for (const char* key : {"contact_hold_ms", "random_spin", "no_spin"}) {
    if (imposed.contains(key)) {
      problems.push_back({"/imposed/" + std::string(key), "expected none with figures"});
    }
  }
}

void add_response_problem(const json& scene, Problems& problems) {
  if (scene["engine"].value("response", std::string()) == std::string("together")) {
    problems.push_back(
        {"/engine/response", "expected \"in-turn\" where there are figures, got \"together\""});
  }
}

void add_angle_problems(const json& entry, const json& figure, const std::string& place,
                        Problems& problems) {
  const json angles = entry.value("angles_deg", json::object());
  for (auto angle = angles.begin(); angle != angles.end(); ++angle) {
    const std::string problem = problem_of_angle(figure, angle.key(), angle.value().get<double>());
    if (!problem.empty()) {
      problems.push_back(
          {(json::json_pointer(place) / "angles_deg" / angle.key()).to_string(), problem});
    }
  }
}

std::string names_of(const json& object) {
  std::string names;
  for (auto entry = object.begin(); entry != object.end(); ++entry) {
    names += (names.empty() ? "" : ", ") + json(entry.key()).dump();
  }
  return names.empty() ? "none" : names;
}

/// Of a figure that a motion drives.
void add_driven_problems(const json& entry, const json& figure, const std::string& place,
                         Problems& problems) {
  const auto name = entry["motion"].get<std::string>();
  const json motions = figure.value("motions", json::object());
  if (!motions.contains(name)) {
    problems.push_back({place + "/motion", "expected a motion of the figure, which has " +
                                               names_of(motions) + ", got " + json(name).dump()});
    return;
  }
  for (const char* key : {"velocity_deg_s", "spin_deg_s"}) {
    if (entry.contains(key)) {
      problems.push_back({place + "/" + key,
                          "expected none beside motion; path_deg_s says where the figure goes"});
    }
  }
  const json angles = entry.value("angles_deg", json::object());
  for (const std::string& joint : joints_of(motions[name])) {
    if (angles.contains(joint)) {
      problems.push_back(
          {(json::json_pointer(place) / "angles_deg" / joint).to_string(),
           "expected none for a joint that the motion " + json(name).dump() + " moves"});
    }
  }
}

void add_entry_problems(const json& scene, std::size_t index, Problems& problems) {
  const json& entry = scene["figures"][index];
  const json& figure = figure_content(scene, entry["figure"].get<std::string>());
  const std::string place = place_of(index);
  add_angle_problems(entry, figure, place, problems);
  if (entry.contains("motion")) {
    add_driven_problems(entry, figure, place, problems);
  } else if (entry.contains("path_deg_s")) {
    problems.push_back({place + "/path_deg_s", "expected none without motion"});
  }
}

/// How many bodies the scene's figures and named bodies are.
std::size_t body_count(const json& scene) {
  std::size_t count = scene.value("bodies", json::array()).size();
  for (const FigureFile& named : figure_files_of(scene)) {
    const std::size_t parts = figure_content(scene, named.file)["parts"].size();
    const bool crowd = scene.contains("figure_crowd");
    count += parts * (crowd ? scene["figure_crowd"]["count"].get<std::size_t>() : 1);
  }
  return count;
}

/// The names of bodies and parts, each once.
void add_part_name_problems(const json& scene, Problems& problems) {
  std::set<std::string> names;
  for (const json& body : scene.value("bodies", json::array())) {
    names.insert(body["name"].get<std::string>());
  }
  const std::size_t figures = scene.contains("figures") ? scene["figures"].size() : 0;
  for (std::size_t i = 0; i < figures; ++i) {
    const json& entry = scene["figures"][i];
    const json& figure = figure_content(scene, entry["figure"].get<std::string>());
    for (const json& part : figure["parts"]) {
      const std::string name =
          entry["name"].get<std::string>() + "/" + part["name"].get<std::string>();
      if (!names.insert(name).second) {
        problems.push_back({place_of(i) + "/name",
                            "expected a name that gives its parts names of "
                            "their own, got " +
                                json(name).dump() + " again"});
        break;
      }
    }
  }
}

/// Which of the named figures the body is a part of; their number when of none.
std::size_t figure_with(const std::vector<Figure>& figures, std::int32_t body) {
  std::size_t found = 0;
  while (found < figures.size() && !figures[found].has_part(body)) {
    ++found;
  }
  return found;
}

}  // namespace

bool has_figures(const json& scene) {
  return scene.contains("figures") || scene.contains("figure_crowd");
}

void add_figure_problems(const json& scene, Problems& problems) {
  add_imposed_problems(scene, problems);
  add_response_problem(scene, problems);
  std::set<std::string> checked;
  for (const FigureFile& named : figure_files_of(scene)) {
    if (!scene.contains("figure_files") || !scene["figure_files"].contains(named.file)) {
      problems.push_back({named.pointer, "expected a figure whose content the scene holds, got " +
                                             json(named.file).dump()});
    } else if (checked.insert(named.file).second) {
      add_figure_file_problems(scene, named.file, problems);
    }
  }
  if (!problems.empty()) {
    return;
  }
  const std::size_t figures = scene.contains("figures") ? scene["figures"].size() : 0;
  for (std::size_t i = 0; i < figures; ++i) {
    add_entry_problems(scene, i, problems);
  }
  add_part_name_problems(scene, problems);
  if (body_count(scene) > kMostBodies) {
    problems.push_back({scene.contains("figures") ? "/figures" : "/figure_crowd/count",
                        "expected at most " + std::to_string(kMostBodies) +
                            " bodies and parts together, got " +
                            std::to_string(body_count(scene))});
  }
}

void add_overlap_problems(const json& scene, Problems& problems) {
  const StartingOverlaps overlaps = starting_overlaps_of(scene);
  const auto place = [&](std::int32_t body) {
    const std::size_t figure = figure_with(overlaps.figures, body);
    return figure < overlaps.figures.size() ? place_of(figure) : "/bodies/" + std::to_string(body);
  };
  for (const BodyPair& pair : overlaps.pairs) {
    const auto name = [&](std::int32_t body) {
      return json(overlaps.names[static_cast<std::size_t>(body)]).dump();
    };
    const std::size_t figure = figure_with(overlaps.figures, pair.a);
    const bool one = !is_wall(pair.b) && figure < overlaps.figures.size() &&
                     overlaps.figures[figure].has_part(pair.b);
    if (one) {
      problems.push_back({place_of(figure) + "/angles_deg",
                          "expected parts apart from each other at the start, but " + name(pair.a) +
                              " overlaps " + name(pair.b)});
    } else {
      problems.push_back({place(pair.a) + "/position_deg",
                          "expected a place apart from all else at the start, but " + name(pair.a) +
                              " overlaps " +
                              (is_wall(pair.b) ? std::string("the enclosure") : name(pair.b))});
    }
  }
  for (const std::int32_t folded : overlaps.folded) {
    const auto name = json(overlaps.names[static_cast<std::size_t>(folded)]).dump();
    problems.push_back(
        {place(folded) + "/angles_deg",
         "expected no part folded onto its neighbour at the start, but " + name + " is"});
  }
}

}  // namespace impetus::inline scenes
