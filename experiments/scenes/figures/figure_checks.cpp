// SPDX-License-Identifier: MIT
#include "experiments/scenes/figures/figure_checks.hpp"

#include <set>
#include <utility>

#include "engine/numerics/trigonometry.hpp"
#include "experiments/scenes/figures/figure_making.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

/// "12.5" where JSON would say so, too: angles come from files.
std::string angle_text(double number) { return json(number).dump(); }

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

}  // namespace

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

}  // namespace impetus::inline scenes
