// SPDX-License-Identifier: MIT
#include "engine/figures/joint_motion.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline figures {
namespace {

double sine_of_turns(double turns) {
  return sine_cosine_deg(360.0 * (turns - std::floor(turns))).sine;
}

double angle_of(const JointWave& wave, double turns) {
  return wave.middle_rad + wave.amplitude_rad * sine_of_turns(wave.cycles * turns + wave.phase);
}

/// The time within the keys that `time_s` stands for.
double time_in_keys(const JointMotion& motion, double time_s) {
  const double length_s = motion.keys.back().time_s;
  if (!motion.repeats) {
    return std::min(time_s, length_s);
  }
  return time_s - length_s * std::floor(time_s / length_s);
}

/// The mean slope of a joint's angle about a key (rad/s).
double slope_at(const JointMotion& motion, std::size_t joint, std::size_t key) {
  const std::vector<JointKey>& keys = motion.keys;
  const std::size_t last = keys.size() - 1;
  const auto slope = [&](std::size_t from, std::size_t to, double extra_s) {
    return (keys[to].angles_rad[joint] - keys[from].angles_rad[joint]) /
           (keys[to].time_s - keys[from].time_s + extra_s);
  };
  if (motion.repeats && (key == 0 || key == last)) {
    return slope(last - 1, 1, keys[last].time_s);
  }
  return slope(key == 0 ? 0 : key - 1, key == last ? last : key + 1, 0.0);
}

double angle_between_keys(const JointMotion& motion, std::size_t joint, double time_s) {
  const std::vector<JointKey>& keys = motion.keys;
  const double time = time_in_keys(motion, time_s);
  const auto after =
      std::upper_bound(keys.begin(), keys.end(), time,
                       [](double wanted_s, const JointKey& key) { return wanted_s < key.time_s; });
  if (after == keys.end()) {
    return keys.back().angles_rad[joint];
  }
  const auto to = static_cast<std::size_t>(after - keys.begin());
  const std::size_t from = to - 1;
  const double span_s = keys[to].time_s - keys[from].time_s;
  const double s = (time - keys[from].time_s) / span_s;
  const double end = s * s * (3.0 - 2.0 * s);  // share of the later key
  return keys[from].angles_rad[joint] * (1.0 - end) + keys[to].angles_rad[joint] * end +
         span_s * (slope_at(motion, joint, from) * s * (1.0 - s) * (1.0 - s) -
                   slope_at(motion, joint, to) * s * s * (1.0 - s));
}

bool is_finite(const RootPath& root) {
  return root.start.position.allFinite() && root.start.orientation.coeffs().allFinite() &&
         root.velocity_m_s.allFinite() && root.spin_rad_s.allFinite() && root.bob_m.allFinite();
}

bool is_finite(const JointWave& wave) {
  return std::isfinite(wave.middle_rad) && std::isfinite(wave.amplitude_rad) &&
         std::isfinite(wave.phase);
}

bool is_finite(const JointKey& key) {
  return std::isfinite(key.time_s) &&
         std::all_of(key.angles_rad.begin(), key.angles_rad.end(),
                     [](double angle) { return std::isfinite(angle); });
}

std::string problem_of_keys(const JointMotion& motion, std::size_t joints) {
  const std::vector<JointKey>& keys = motion.keys;
  if (keys.size() < 2 || keys.front().time_s != 0.0) {
    return "expected two keys or more, the first at 0 s";
  }
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].angles_rad.size() != joints) {
      return "expected " + std::to_string(joints) + " angles in each key, got " +
             std::to_string(keys[i].angles_rad.size()) + " in key " + std::to_string(i);
    }
    if (!is_finite(keys[i])) {
      return "expected keys of finite numbers, got another in key " + std::to_string(i);
    }
    if (i > 0 && !(keys[i].time_s > keys[i - 1].time_s)) {
      return "expected keys at rising times, got " + std::to_string(keys[i].time_s) + " s after " +
             std::to_string(keys[i - 1].time_s) + " s";
    }
  }
  if (motion.repeats && keys.front().angles_rad != keys.back().angles_rad) {
    return "expected the last key of a motion that repeats to equal its first";
  }
  return "";
}

}  // namespace

double joint_angle(const JointMotion& motion, std::size_t joint, double time_s) {
  return motion.keys.empty() ? angle_of(motion.waves[joint], time_s / motion.period_s)
                             : angle_between_keys(motion, joint, time_s);
}

Pose root_pose(const JointMotion& motion, double time_s) {
  const RootPath& root = motion.root;
  Pose pose = root.start;
  pose.position += time_s * root.velocity_m_s;
  if (!root.bob_m.isZero(0.0)) {
    pose.position += sine_of_turns(2.0 * time_s / motion.period_s) * root.bob_m;
  }
  const double spin_rad_s = root.spin_rad_s.norm();
  if (spin_rad_s > 0.0) {
    const double turns = time_s * spin_rad_s * kDegreesPerRadian / 720.0;  // of half the angle
    const SineCosine half = sine_cosine_deg(360.0 * (turns - std::floor(turns)));
    const Vector3 axis = half.sine / spin_rad_s * root.spin_rad_s;
    pose.orientation =
        (Quaternion(half.cosine, axis.x(), axis.y(), axis.z()) * pose.orientation).normalized();
  }
  return pose;
}

std::string problem_of(const JointMotion& motion, std::size_t joints) {
  if (!is_finite(motion.root)) {
    return "expected a root path of finite numbers";
  }
  constexpr double kOfUnit = 1e-6;
  if (std::abs(motion.root.start.orientation.coeffs().norm() - 1.0) > kOfUnit) {
    return "expected a root's orientation of unit length, got one of " +
           std::to_string(motion.root.start.orientation.coeffs().norm());
  }
  if (!(motion.period_s > 0.0 && std::isfinite(motion.period_s))) {
    return "expected a period above 0 s, got " + std::to_string(motion.period_s);
  }
  if (!motion.keys.empty()) {
    return problem_of_keys(motion, joints);
  }
  if (motion.waves.size() != joints) {
    return "expected a wave for each of " + std::to_string(joints) + " joints, got " +
           std::to_string(motion.waves.size());
  }
  return std::all_of(motion.waves.begin(), motion.waves.end(),
                     [](const JointWave& wave) { return is_finite(wave); })
             ? ""
             : "expected waves of finite numbers, got another";
}

}  // namespace impetus::inline figures
