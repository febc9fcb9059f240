// SPDX-License-Identifier: MIT
#include "experiments/scenes/figures/figure_checks.hpp"

#include <set>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/scenes/figures/figure_making.hpp"
#include "experiments/scenes/scene_file.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

/// "12.5" where JSON would say so, too: angles come from files.
std::string angle_text(double number) { return json(number).dump(); }

/// What is wrong with the angle (degrees) of the joint called `name`, in words; "" when nothing is:
/// the figure has none of the name, or the angle is beyond its limits.
std::string problem_of_angle(const FigureSettings& figure, const std::string& name,
                             double angle_deg) {
  const std::size_t joint = figure.joint_named(name);
  if (joint + 1 >= figure.parts.size()) {
    return "expected the name of a joint of the figure, got " + json(name).dump();
  }
  const HingeSettings& hinge = *figure.parts[joint + 1].hinge;
  if (!hinge.least_deg) {
    return "";
  }
  constexpr double kRounding_deg = 1e-9;
  return angle_deg >= *hinge.least_deg - kRounding_deg &&
                 angle_deg <= *hinge.most_deg + kRounding_deg
             ? ""
             : "expected an angle within the limits of the joint " + json(name).dump() + ", " +
                   angle_text(*hinge.least_deg) + " to " + angle_text(*hinge.most_deg) +
                   " degrees, got " + angle_text(angle_deg);
}

void add_part_tree_problem(const PartSettings& part, const std::string& place,
                           SceneProblems& problems) {
  if (part.tree) {
    TreeSettings deep;
    deep.depth = part.tree->depth.value_or(deep.depth);
    problems.add_tree_problem(place + "/tree", problem_of(part_tree(part, deep)));
  }
}

/// A direction that is none.
void add_zero_problem(const Vector3& direction, const std::string& place, SceneProblems& problems) {
  if (direction.isZero(0.0)) {
    problems.add(place, "expected a direction, got [0,0,0]");
  }
}

/// Directions without one, and cores that no anchor tells.
void add_direction_problems(const HingeSettings& hinge, const std::string& place,
                            SceneProblems& problems) {
  const Vector3 any = Vector3::UnitX();
  add_zero_problem(hinge.axis, place + "/axis", problems);
  add_zero_problem(hinge.core_of_parent.value_or(any), place + "/core_of_parent", problems);
  add_zero_problem(hinge.core_of_part.value_or(any), place + "/core_of_part", problems);
  const auto need_core = [&](const Vector3& anchor, const std::string& name,
                             const std::optional<Vector3>& core, const std::string& core_name) {
    if (anchor.isZero(0.0) && !core) {
      problems.add_missing(place, core_name, "where " + name + " is the centre");
    }
  };
  need_core(hinge.on_parent, "on_parent", hinge.core_of_parent, "core_of_parent");
  need_core(hinge.on_part, "on_part", hinge.core_of_part, "core_of_part");
}

void add_hinge_problems(const FigureSettings& figure, std::size_t part, const std::string& place,
                        SceneProblems& problems) {
  const HingeSettings& hinge = *figure.parts[part].hinge;
  const std::size_t before = problems.size();
  if (figure.part_named(hinge.parent) >= part) {
    problems.add_got(place + "/parent", "expected the name of an earlier part");
  }
  add_direction_problems(hinge, place, problems);
  if (hinge.least_deg.has_value() != hinge.most_deg.has_value()) {
    problems.add(place, "expected least_deg and most_deg, or neither, got one");
  }
  if (problems.size() == before) {
    const std::string problem = problem_of(part_hinge(figure, part, 0, 1.0));
    if (!problem.empty()) {
      problems.add(place, problem);
    }
  }
}

/// Each part but the root hangs by a hinge; names are not used twice.
void add_part_problems(const Scene& scene, const FigureSettings& figure, const std::string& place,
                       SceneProblems& problems) {
  std::set<std::string> names;
  std::set<std::string> joints;
  const auto require_own = [&](std::set<std::string>& known, const std::string& name,
                               const std::string& there) {
    if (!known.insert(name).second) {
      problems.add(there, "expected a name of its own, got " + problems.written(there) + " again");
    }
  };
  for (std::size_t i = 0; i < figure.parts.size(); ++i) {
    const PartSettings& part = figure.parts[i];
    const std::string of_part = place + "/parts/" + std::to_string(i);
    require_own(names, part.name, of_part + "/name");
    add_shape_problems(part_shape(part, 1.0), scene.meshes, of_part + "/shape", "_share", problems);
    add_part_tree_problem(part, of_part, problems);
    if (i == 0 && part.hinge) {
      problems.add(of_part + "/hinge", "expected none for the root");
    } else if (i > 0 && !part.hinge) {
      problems.add_missing(of_part, "hinge", "for a part that is not the root");
    } else if (i > 0) {
      require_own(joints, part.hinge->name, of_part + "/hinge/name");
      add_hinge_problems(figure, i, of_part + "/hinge", problems);
    }
  }
}

void add_wave_problems(const FigureSettings& figure, const MotionSettings& motion,
                       const std::string& place, SceneProblems& problems) {
  if (!motion.waves) {
    return;
  }
  for (const auto& [joint, wave] : *motion.waves) {
    for (const double extreme_deg :
         {wave.middle_deg - wave.amplitude_deg, wave.middle_deg + wave.amplitude_deg}) {
      const std::string problem = problem_of_angle(figure, joint, extreme_deg);
      if (!problem.empty()) {
        problems.add((json::json_pointer(place) / joint).to_string(), problem);
        break;
      }
    }
  }
}

void add_key_problems(const FigureSettings& figure, const MotionSettings& motion,
                      const std::string& place, SceneProblems& problems) {
  for (std::size_t i = 0; motion.keys && i < motion.keys->size(); ++i) {
    for (const auto& [joint, angle_deg] : (*motion.keys)[i].angles_deg) {
      const std::string problem = problem_of_angle(figure, joint, angle_deg);
      if (!problem.empty()) {
        problems.add((json::json_pointer(place) / i / "angles_deg" / joint).to_string(), problem);
      }
    }
  }
}

/// Between keys angles may swing beyond both.
void add_swing_problems(const FigureSettings& figure, const JointMotion& motion,
                        const std::string& place, SceneProblems& problems) {
  constexpr int kSamples = 16;
  for (std::size_t key = 0; key + 1 < motion.keys.size(); ++key) {
    const double from_s = motion.keys[key].time_s;
    const double span_s = motion.keys[key + 1].time_s - from_s;
    for (std::size_t joint = 0; joint + 1 < figure.parts.size(); ++joint) {
      const std::string& name = figure.parts[joint + 1].hinge->name;
      for (int sample = 1; sample < kSamples; ++sample) {
        const double angle_deg =
            kDegreesPerRadian * joint_angle(motion, joint, from_s + span_s * sample / kSamples);
        const std::string problem = problem_of_angle(figure, name, angle_deg);
        if (!problem.empty()) {
          problems.add(place + "/" + std::to_string(key), "from here to the next key the joint " +
                                                              json(name).dump() +
                                                              " swings too far: " + problem);
          return;
        }
      }
    }
  }
}

void add_motion_problems(const FigureSettings& figure, const MotionSettings& motion,
                         const std::string& place, SceneProblems& problems) {
  const std::size_t before = problems.size();
  if (motion.waves && motion.keys) {
    problems.add(place, "expected waves or keys, got both");
  }
  if (motion.keys && motion.period_s) {
    problems.add(place + "/period_s", "expected none beside keys");
  }
  if (motion.keys && motion.bob_share) {
    problems.add(place + "/bob_share", "expected none beside keys");
  }
  if (motion.repeats && !motion.keys) {
    problems.add(place + "/repeats", "expected none without keys");
  }
  add_wave_problems(figure, motion, place + "/waves", problems);
  add_key_problems(figure, motion, place + "/keys", problems);
  if (problems.size() > before) {
    return;
  }
  const std::vector<double> rest = joint_angles(figure, {});
  const JointMotion made = joint_motion(figure, motion, 1.0, rest);
  const std::string problem = problem_of(made, rest.size());
  if (!problem.empty()) {
    problems.add(place, problem);
    return;
  }
  add_swing_problems(figure, made, place + "/keys", problems);
}

/// Of the figure that the scene holds for `file`, each place once.
void add_figure_file_problems(const Scene& scene, const std::string& file,
                              SceneProblems& problems) {
  const std::size_t before = problems.size();
  const FigureSettings& figure = scene.figure_files.at(file);
  const std::string place = figure_place(file);
  add_part_problems(scene, figure, place, problems);
  if (problems.size() > before || !figure.motions) {
    return;
  }
  for (const auto& [name, motion] : *figure.motions) {
    add_motion_problems(figure, motion, (json::json_pointer(place) / "motions" / name).to_string(),
                        problems);
  }
}

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
  refuse("rebound", imposed.rebound.has_value());
  refuse("no_spin", imposed.no_spin.has_value());
}

std::string listed_names(const std::map<std::string, MotionSettings>& motions) {
  const std::string names =
      listed(motions, [](const auto& each) { return json(each.first).dump(); });
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

void add_overlap_problems(const Scene& scene, ShapeLibrary& library, SceneProblems& problems) {
  const StartingOverlaps overlaps = starting_overlaps_of(scene, library);
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
