// SPDX-License-Identifier: MIT
#include "experiments/scenes/figures/figure_motion.hpp"

#include <set>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/scenes/figures/figure_parts.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

Vector3 vector_at(const json& motion, const char* key, double unit) {
  const auto numbers = motion.value(key, std::vector<double>{0.0, 0.0, 0.0});
  return unit * Vector3(numbers[0], numbers[1], numbers[2]);
}

JointWave wave_from(const json& entry) {
  JointWave wave;
  wave.middle_rad = entry["middle_deg"].get<double>() * kRadiansPerDegree;
  wave.amplitude_rad = entry["amplitude_deg"].get<double>() * kRadiansPerDegree;
  wave.phase = entry.value("phase", wave.phase);
  wave.cycles = entry.value("cycles", wave.cycles);
  return wave;
}

std::vector<JointWave> waves_of(const json& figure, const json& entries,
                                const std::vector<double>& angles_rad) {
  std::vector<JointWave> waves;
  waves.reserve(angles_rad.size());
  for (const double angle_rad : angles_rad) {
    waves.push_back({angle_rad, 0.0});
  }
  for (auto entry = entries.begin(); entry != entries.end(); ++entry) {
    waves[joint_named(figure, entry.key())] = wave_from(entry.value());
  }
  return waves;
}

std::vector<JointKey> keys_of(const json& figure, const json& entries,
                              const std::vector<double>& angles_rad) {
  std::vector<JointKey> keys;
  for (const json& entry : entries) {
    JointKey key{entry["time_s"].get<double>(), angles_rad};
    const json& angles = entry["angles_deg"];
    for (auto angle = angles.begin(); angle != angles.end(); ++angle) {
      key.angles_rad[joint_named(figure, angle.key())] =
          angle.value().get<double>() * kRadiansPerDegree;
    }
    keys.push_back(std::move(key));
  }
  return keys;
}

}  // namespace

JointMotion figure_motion(const json& figure, const std::string& name, double height_m,
                          const std::vector<double>& angles_rad) {
  const json& entry = figure["motions"][name];
  JointMotion motion;
  motion.root.bob_m = vector_at(entry, "bob_share", height_m);
  motion.root.spin_rad_s = vector_at(entry, "root_spin_deg_s", kRadiansPerDegree);
  motion.period_s = entry.value("period_s", motion.period_s);
  motion.waves = waves_of(figure, entry.value("waves", json::object()), angles_rad);
  motion.keys = keys_of(figure, entry.value("keys", json::array()), angles_rad);
  motion.repeats = entry.value("repeats", false);
  return motion;
}

std::vector<std::string> joints_of(const json& motion) {
  std::set<std::string> names;
  const auto add = [&](const json& by_joint) {
    for (auto entry = by_joint.begin(); entry != by_joint.end(); ++entry) {
      names.insert(entry.key());
    }
  };
  add(motion.value("waves", json::object()));
  for (const json& key : motion.value("keys", json::array())) {
    add(key["angles_deg"]);
  }
  return {names.begin(), names.end()};
}

}  // namespace impetus::inline scenes
