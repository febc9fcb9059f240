// SPDX-License-Identifier: MIT
#include "experiments/scenes/figures/figure_checks.hpp"

#include <set>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/scenes/figures/figure_files.hpp"
#include "experiments/scenes/figures/figure_motion.hpp"
#include "experiments/scenes/figures/figure_parts.hpp"
#include "experiments/scenes/shape_checks.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;
using Problems = std::vector<SceneProblem>;

/// "12.5" where JSON would say so, too: angles come from files.
std::string text_of(double number) { return json(number).dump(); }

/// Words that speak of a shape as scenes have it, in a figure's measures.
std::string in_shares(std::string words) {
  const std::string degrees = "_deg";
  for (auto at = words.find(degrees); at != std::string::npos; at = words.find(degrees, at)) {
    words.replace(at, degrees.size(), "_share");
  }
  return words;
}

void add_part_shape_problems(const json& scene, const json& part, const std::string& place,
                             Problems& problems) {
  Problems of_shape;
  add_shape_problems(part_shape(part, 1.0, ""), scene.value("meshes", json::object()),
                     place + "/shape", of_shape);
  for (const SceneProblem& problem : of_shape) {
    problems.push_back({in_shares(problem.pointer), in_shares(problem.message)});
  }
}

void add_tree_problem(const json& part, const std::string& place, Problems& problems) {
  if (part.contains("tree")) {
    TreeSettings deep;
    deep.depth = part["tree"].value("depth", deep.depth);
    const std::string problem = problem_of(part_tree(part, deep));
    const std::string prefix = "tree: ";
    if (!problem.empty()) {
      problems.push_back(
          {place + "/tree", problem.starts_with(prefix) ? problem.substr(prefix.size()) : problem});
    }
  }
}

bool is_zero(const json& vector) {
  return vector[0].get<double>() == 0.0 && vector[1].get<double>() == 0.0 &&
         vector[2].get<double>() == 0.0;
}

/// Directions without one, and cores that no anchor tells.
void add_direction_problems(const json& hinge, const std::string& place, Problems& problems) {
  for (const char* key : {"axis", "core_of_parent", "core_of_part"}) {
    if (hinge.contains(key) && is_zero(hinge[key])) {
      problems.push_back({place + "/" + key, "expected a direction, got [0,0,0]"});
    }
  }
  for (const auto& [anchor, core] :
       {std::pair("on_parent", "core_of_parent"), std::pair("on_part", "core_of_part")}) {
    if (is_zero(hinge[anchor]) && !hinge.contains(core)) {
      problems.push_back({place, "expected the key \"" + std::string(core) + "\" where " + anchor +
                                     " is the centre, which is missing"});
    }
  }
}

void add_hinge_problems(const json& figure, std::size_t part, const std::string& place,
                        Problems& problems) {
  const json& hinge = figure["parts"][part]["hinge"];
  const std::size_t before = problems.size();
  if (part_named(figure, hinge["parent"].get<std::string>()) >= part) {
    problems.push_back(
        {place + "/parent", "expected the name of an earlier part, got " + hinge["parent"].dump()});
  }
  add_direction_problems(hinge, place, problems);
  if (hinge.contains("least_deg") != hinge.contains("most_deg")) {
    problems.push_back({place, "expected least_deg and most_deg, or neither, got one"});
  }
  if (problems.size() == before) {
    const std::string problem = problem_of(part_hinge(figure, part, 0, 1.0));
    if (!problem.empty()) {
      problems.push_back({place, problem});
    }
  }
}

/// Each part but the root hangs by a hinge; names are not used twice.
void add_part_problems(const json& scene, const json& figure, const std::string& place,
                       Problems& problems) {
  std::set<std::string> names;
  std::set<std::string> joints;
  const json& parts = figure["parts"];
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string of_part = place + "/parts/" + std::to_string(i);
    if (!names.insert(parts[i]["name"].get<std::string>()).second) {
      problems.push_back({of_part + "/name",
                          "expected a name of its own, got " + parts[i]["name"].dump() + " again"});
    }
    add_part_shape_problems(scene, parts[i], of_part, problems);
    add_tree_problem(parts[i], of_part, problems);
    if (i == 0 && parts[i].contains("hinge")) {
      problems.push_back({of_part + "/hinge", "expected none for the root"});
    } else if (i > 0 && !parts[i].contains("hinge")) {
      problems.push_back(
          {of_part,
           "expected the key \"hinge\" for a part that is not the root, which is missing"});
    } else if (i > 0) {
      const json& joint = parts[i]["hinge"]["name"];
      if (!joints.insert(joint.get<std::string>()).second) {
        problems.push_back({of_part + "/hinge/name",
                            "expected a name of its own, got " + joint.dump() + " again"});
      }
      add_hinge_problems(figure, i, of_part + "/hinge", problems);
    }
  }
}

void add_wave_problems(const json& figure, const json& waves, const std::string& place,
                       Problems& problems) {
  for (auto wave = waves.begin(); wave != waves.end(); ++wave) {
    const auto middle_deg = wave.value()["middle_deg"].get<double>();
    const auto amplitude_deg = wave.value()["amplitude_deg"].get<double>();
    for (const double extreme_deg : {middle_deg - amplitude_deg, middle_deg + amplitude_deg}) {
      const std::string problem = problem_of_angle(figure, wave.key(), extreme_deg);
      if (!problem.empty()) {
        problems.push_back({(json::json_pointer(place) / wave.key()).to_string(), problem});
        break;
      }
    }
  }
}

void add_key_problems(const json& figure, const json& keys, const std::string& place,
                      Problems& problems) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const json& angles = keys[i]["angles_deg"];
    for (auto angle = angles.begin(); angle != angles.end(); ++angle) {
      const std::string problem =
          problem_of_angle(figure, angle.key(), angle.value().get<double>());
      if (!problem.empty()) {
        problems.push_back(
            {(json::json_pointer(place) / i / "angles_deg" / angle.key()).to_string(), problem});
      }
    }
  }
}

/// Between keys angles may swing beyond both.
void add_swing_problems(const json& figure, const JointMotion& motion, const std::string& place,
                        Problems& problems) {
  constexpr int kSamples = 16;
  for (std::size_t key = 0; key + 1 < motion.keys.size(); ++key) {
    const double from_s = motion.keys[key].time_s;
    const double span_s = motion.keys[key + 1].time_s - from_s;
    for (std::size_t joint = 0; joint + 1 < figure["parts"].size(); ++joint) {
      const auto name = figure["parts"][joint + 1]["hinge"]["name"].get<std::string>();
      for (int sample = 1; sample < kSamples; ++sample) {
        const double angle_deg =
            kDegreesPerRadian * joint_angle(motion, joint, from_s + span_s * sample / kSamples);
        const std::string problem = problem_of_angle(figure, name, angle_deg);
        if (!problem.empty()) {
          problems.push_back({place + "/" + std::to_string(key),
                              "from here to the next key the joint " + json(name).dump() +
                                  " swings too far: " + problem});
          return;
        }
      }
    }
  }
}

void add_motion_problems(const json& figure, const std::string& name, const std::string& place,
                         Problems& problems) {
  const json& motion = figure["motions"][name];
  const std::size_t before = problems.size();
  if (motion.contains("waves") && motion.contains("keys")) {
    problems.push_back({place, "expected waves or keys, got both"});
  }
  for (const char* key : {"period_s", "bob_share"}) {
    if (motion.contains("keys") && motion.contains(key)) {
      problems.push_back({place + "/" + key, "expected none beside keys"});
    }
  }
  if (motion.contains("repeats") && !motion.contains("keys")) {
    problems.push_back({place + "/repeats", "expected none without keys"});
  }
  add_wave_problems(figure, motion.value("waves", json::object()), place + "/waves", problems);
  add_key_problems(figure, motion.value("keys", json::array()), place + "/keys", problems);
  if (problems.size() > before) {
    return;
  }
  const std::vector<double> rest = joint_angles(figure, json::object());
  const JointMotion made = figure_motion(figure, name, 1.0, rest);
  const std::string problem = problem_of(made, rest.size());
  if (!problem.empty()) {
    problems.push_back({place, problem});
    return;
  }
  add_swing_problems(figure, made, place + "/keys", problems);
}

}  // namespace

void add_figure_file_problems(const json& scene, const std::string& file, Problems& problems) {
  const std::size_t before = problems.size();
  const json& figure = figure_content(scene, file);
  const std::string place = figure_place(file);
  add_part_problems(scene, figure, place, problems);
  if (problems.size() > before || !figure.contains("motions")) {
    return;
  }
  const json& motions = figure["motions"];
  for (auto motion = motions.begin(); motion != motions.end(); ++motion) {
    add_motion_problems(figure, motion.key(),
                        (json::json_pointer(place) / "motions" / motion.key()).to_string(),
                        problems);
  }
}

std::string problem_of_angle(const json& figure, const std::string& name, double angle_deg) {
  const std::size_t joint = joint_named(figure, name);
  if (joint + 1 >= figure["parts"].size()) {
    return "expected the name of a joint of the figure, got " + json(name).dump();
  }
  const json& hinge = figure["parts"][joint + 1]["hinge"];
  if (!hinge.contains("least_deg")) {
    return "";
  }
  constexpr double kRounding_deg = 1e-9;
  const auto least_deg = hinge["least_deg"].get<double>();
  const auto most_deg = hinge["most_deg"].get<double>();
  return angle_deg >= least_deg - kRounding_deg && angle_deg <= most_deg + kRounding_deg
             ? ""
             : "expected an angle within the limits of the joint " + json(name).dump() + ", " +
                   text_of(least_deg) + " to " + text_of(most_deg) + " degrees, got " +
                   text_of(angle_deg);
}

}  // namespace impetus::inline scenes
