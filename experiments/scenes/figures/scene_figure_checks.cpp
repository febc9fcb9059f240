// SPDX-License-Identifier: MIT
#include "experiments/scenes/figures/scene_figure_checks.hpp"

#include <set>

#include "experiments/scenes/figures/figure_checks.hpp"
#include "experiments/scenes/figures/figure_making.hpp"
#include "experiments/scenes/scene_file.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

constexpr std::size_t kMostBodies = 1000;

std::string place_of_figure(std::size_t figure) { return "/figures/" + std::to_string(figure); }

/// Manipulations of one body's collisions say nothing of a figure's.
void add_imposed_problems(const ImposedSettings& imposed, SceneProblems& problems) {
  const auto refuse = [&](const std::string& key, bool is_said) {
    if (is_said) {
      problems.add("/imposed/" + key, "expected none with figures");
    }
  };
  refuse("contact_hold_ms", imposed.contact_hold_ms.has_value());
  refuse("random_spin", imposed.random_spin.has_value());
  refuse("no_spin", imposed.no_spin.has_value());
}

std::string listed_names(const std::map<std::string, MotionSettings>& motions) {
  std::string names;
  for (const auto& [name, motion] : motions) {
    names += (names.empty() ? "" : ", ") + json(name).dump();
  }
  return names.empty() ? "none" : names;
}

/// Of a figure that a motion drives.
void add_driven_problems(const NamedFigure& entry, const FigureSettings& figure,
                         const std::string& place, SceneProblems& problems) {
  const std::string& name = *entry.motion;
  const auto motions = figure.motions.value_or(std::map<std::string, MotionSettings>{});
  if (!motions.contains(name)) {
    problems.add_got(place + "/motion",
                     "expected a motion of the figure, which has " + listed_names(motions));
    return;
  }
  const auto refuse = [&](const std::string& key, bool is_said) {
    if (is_said) {
      problems.add(place + "/" + key,
                   "expected none beside motion; path_deg_s says where the figure goes");
    }
  };
  refuse("velocity_deg_s", entry.velocity_deg_s.has_value());
  refuse("spin_deg_s", entry.spin_deg_s.has_value());
  for (const std::string& joint : joints_of(motions.at(name))) {
    if (entry.angles_deg.contains(joint)) {
      problems.add((json::json_pointer(place) / "angles_deg" / joint).to_string(),
                   "expected none for a joint that the motion " + json(name).dump() + " moves");
    }
  }
}

void add_entry_problems(const NamedFigure& entry, const FigureSettings& figure,
                        const std::string& place, SceneProblems& problems) {
  for (const auto& [joint, angle_deg] : entry.angles_deg) {
    const std::string problem = problem_of_angle(figure, joint, angle_deg);
    if (!problem.empty()) {
      problems.add((json::json_pointer(place) / "angles_deg" / joint).to_string(), problem);
    }
  }
  if (entry.motion) {
    add_driven_problems(entry, figure, place, problems);
  } else if (entry.path_deg_s) {
    problems.add(place + "/path_deg_s", "expected none without motion");
  }
}

/// How many bodies the scene's figures and named bodies are.
std::size_t body_count(const Scene& scene) {
  std::size_t count = scene.named_bodies().size();
  for (const FigureFile& named : named_figure_files(scene)) {
    count += scene.figure_files.at(named.file).parts.size() *
             (scene.figure_crowd ? scene.figure_crowd->count : 1);
  }
  return count;
}

/// The names of bodies and parts, each once.
void add_part_name_problems(const Scene& scene, SceneProblems& problems) {
  std::set<std::string> names;
  for (const BodySettings& body : scene.named_bodies()) {
    names.insert(body.name);
  }
  const auto figures = scene.named_figures();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    for (const PartSettings& part : scene.figure_files.at(figures[i].making.figure).parts) {
      const std::string name = figures[i].name + "/" + part.name;
      if (!names.insert(name).second) {
        problems.add(place_of_figure(i) + "/name",
                     "expected a name that gives its parts names of their own, got " +
                         json(name).dump() + " again");
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

void add_figure_problems(const Scene& scene, SceneProblems& problems) {
  add_imposed_problems(scene.imposed.value_or(ImposedSettings{}), problems);
  if (scene.engine.world.response == ResponseMethod::kTogether) {
    problems.add_got("/engine/response", "expected \"in-turn\" where there are figures");
  }
  std::set<std::string> checked;
  for (const FigureFile& named : named_figure_files(scene)) {
    if (!scene.figure_files.contains(named.file)) {
      problems.add_got(named.pointer, "expected a figure whose content the scene holds");
    } else if (checked.insert(named.file).second) {
      add_figure_file_problems(scene, named.file, problems);
    }
  }
  if (!problems.empty()) {
    return;
  }
  const auto figures = scene.named_figures();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    add_entry_problems(figures[i], scene.figure_files.at(figures[i].making.figure),
                       place_of_figure(i), problems);
  }
  add_part_name_problems(scene, problems);
  if (body_count(scene) > kMostBodies) {
    problems.add(scene.figures ? "/figures" : "/figure_crowd/count",
                 "expected at most " + std::to_string(kMostBodies) +
                     " bodies and parts together, got " + std::to_string(body_count(scene)));
  }
}

void add_overlap_problems(const Scene& scene, SceneProblems& problems) {
  const StartingOverlaps overlaps = starting_overlaps_of(scene);
  const auto place = [&](std::int32_t body) {
    const std::size_t figure = figure_with(overlaps.figures, body);
    return figure < overlaps.figures.size() ? place_of_figure(figure)
                                            : "/bodies/" + std::to_string(body);
  };
  for (const BodyPair& pair : overlaps.pairs) {
    const auto name = [&](std::int32_t body) {
      return json(overlaps.names[static_cast<std::size_t>(body)]).dump();
    };
    const std::size_t figure = figure_with(overlaps.figures, pair.a);
    const bool one = !is_wall(pair.b) && figure < overlaps.figures.size() &&
                     overlaps.figures[figure].has_part(pair.b);
    if (one) {
      problems.add(place_of_figure(figure) + "/angles_deg",
                   "expected parts apart from each other at the start, but " + name(pair.a) +
                       " overlaps " + name(pair.b));
    } else {
      problems.add(place(pair.a) + "/position_deg",
                   "expected a place apart from all else at the start, but " + name(pair.a) +
                       " overlaps " +
                       (is_wall(pair.b) ? std::string("the enclosure") : name(pair.b)));
    }
  }
  for (const std::int32_t folded : overlaps.folded) {
    const auto name = json(overlaps.names[static_cast<std::size_t>(folded)]).dump();
    problems.add(place(folded) + "/angles_deg",
                 "expected no part folded onto its neighbour at the start, but " + name + " is");
  }
}

}  // namespace impetus::inline scenes
