// SPDX-License-Identifier: MIT
#include "engine/figures/figure.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/numerics/at.hpp"

namespace impetus::inline figures {
namespace {

/// The angular velocity that turns one orientation into the other in a second, by the chord of
/// their difference: to the second order of the angle.
Vector3 turn_between(const Quaternion& from, const Quaternion& to) {
  const Quaternion turn = to * from.conjugate();
  return (turn.w() < 0.0 ? -2.0 : 2.0) * turn.vec();
}

BodyState moving_state(const BodyModel& model, const Pose& pose, const Vector3& velocity_m_s,
                       const Vector3& spin_rad_s) {
  BodyState state;
  state.pose = pose;
  if (model.inverse_mass > 0.0) {
    state.linear_momentum = velocity_m_s / model.inverse_mass;
    state.angular_momentum = angular_momentum_at(model, pose.orientation, spin_rad_s);
  }
  return state;
}

/// How far the points of a part stay from one of its points, by its tree.
double reach_from(const BodyModel& model, const Vector3& anchor) {
  return anchor.norm() + model.tree->bounding_radius_m();
}

std::string problem_of_parts(const Figure& figure, const std::vector<BodyModel>& models) {
  const auto count = static_cast<std::int64_t>(models.size());
  if (figure.part_count < 1 || figure.first_part < 0 ||
      std::int64_t{figure.first_part} + figure.part_count > count) {
    return "expected parts among the " + std::to_string(count) + " bodies";
  }
  if (figure.hinges.size() + 1 != at(figure.part_count)) {
    return "expected a hinge for each part but the root, got " +
           std::to_string(figure.hinges.size()) + " for " + std::to_string(figure.part_count) +
           " parts";
  }
  for (std::int32_t part = 0; part < figure.part_count; ++part) {
    const BodyModel& model = models[at(figure.first_part + part)];
    const bool moves = model.inverse_mass > 0.0 && !model.inverse_inertia.isZero(0.0);
    const bool fixed_root = part == 0 && !figure.driven && model.inverse_mass == 0.0;
    if (!moves && !fixed_root) {
      return "expected a mass and inertia of the part \"" + model.name + "\"";
    }
  }
  return "";
}

std::string problem_of_hinges(const Figure& figure) {
  for (std::size_t i = 0; i < figure.hinges.size(); ++i) {
    const Hinge& hinge = figure.hinges[i];
    const std::int32_t child = figure.first_part + static_cast<std::int32_t>(i) + 1;
    if (hinge.child != child || hinge.parent < figure.first_part || hinge.parent >= child) {
      return "expected hinge " + std::to_string(i) + " to join part " + std::to_string(i + 1) +
             " to an earlier part";
    }
    const std::string problem = problem_of(hinge);
    if (!problem.empty()) {
      return "hinge " + std::to_string(i) + ": " + problem;
    }
  }
  return "";
}

/// Parts that are not at their hinges, beyond what motion leaves: nothing would bring them there.
std::string problem_of_places(const Figure& figure, const std::vector<BodyModel>& models,
                              const std::vector<BodyState>& states) {
  constexpr double kSlack = 0.01;  // of a part's reach, and in radians
  for (std::size_t i = 0; i < figure.hinges.size(); ++i) {
    const Hinge& hinge = figure.hinges[i];
    const Pose& child = states[at(hinge.child)].pose;
    const Pose& parent = states[at(hinge.parent)].pose;
    const double gap_m = anchor_gap_m(hinge, child, parent);
    if (gap_m > kSlack * models[at(hinge.child)].tree->bounding_radius_m()) {
      return "expected the two parts of hinge " + std::to_string(i) +
             " where it joins them, got its places " + std::to_string(gap_m) + " m apart";
    }
    const Vector3 across =
        (child.orientation * hinge.of_child.axis).cross(parent.orientation * hinge.of_parent.axis);
    if (across.norm() > kSlack) {
      return "expected the two parts of hinge " + std::to_string(i) +
             " to turn about one axis, got two";
    }
  }
  return "";
}

}  // namespace

void find_poses(const Figure& figure, const Pose& root, const std::vector<double>& angles_rad,
                std::vector<Pose>& poses) {
  poses.assign(1, root);
  for (std::size_t i = 0; i < figure.hinges.size(); ++i) {
    const Hinge& hinge = figure.hinges[i];
    poses.push_back(hung_from(hinge, poses[at(hinge.parent - figure.first_part)], angles_rad[i]));
  }
}

std::vector<Pose> poses_of(const Figure& figure, const Pose& root,
                           const std::vector<double>& angles_rad) {
  std::string problem = problem_of_hinges(figure);
  if (problem.empty() && angles_rad.size() != figure.hinges.size()) {
    problem = "expected an angle of each of " + std::to_string(figure.hinges.size()) +
              " hinges, got " + std::to_string(angles_rad.size());
  }
  if (!problem.empty()) {
    throw std::invalid_argument(problem);
  }
  std::vector<Pose> poses;
  find_poses(figure, root, angles_rad, poses);
  return poses;
}

std::vector<double> rest_angles(const Figure& figure) {
  std::vector<double> angles;
  for (const Hinge& hinge : figure.hinges) {
    angles.push_back(hinge.rest_rad);
  }
  return angles;
}

std::vector<BodyState> states_of(const Figure& figure, const std::vector<BodyModel>& models,
                                 const std::vector<Pose>& poses, const Vector3& velocity_m_s,
                                 const Vector3& spin_rad_s) {
  std::vector<BodyState> states;
  for (std::size_t part = 0; part < poses.size(); ++part) {
    const Vector3 arm = poses[part].position - poses.front().position;
    states.push_back(moving_state(models[at(figure.first_part) + part], poses[part],
                                  velocity_m_s + spin_rad_s.cross(arm), spin_rad_s));
  }
  return states;
}

std::vector<BodyState> driven_states(const Figure& figure, const std::vector<BodyModel>& models,
                                     double time_s, double dt_s) {
  std::vector<BodyState> all(models.size());
  DrivenMotion().drive(figure, models, time_s, dt_s, all);
  const auto first = all.begin() + figure.first_part;
  return {first, first + figure.part_count};
}

void DrivenMotion::find_poses_at(const Figure& figure, double time_s, std::vector<Pose>& poses) {
  angles_rad_.clear();
  for (std::size_t joint = 0; joint < figure.hinges.size(); ++joint) {
    angles_rad_.push_back(joint_angle(*figure.driven, joint, time_s));
  }
  find_poses(figure, root_pose(*figure.driven, time_s), angles_rad_, poses);
}

void DrivenMotion::drive(const Figure& figure, const std::vector<BodyModel>& models, double time_s,
                         double dt_s, std::vector<BodyState>& states) {
  const bool begins = time_s < dt_s;
  find_poses_at(figure, time_s, poses_);
  find_poses_at(figure, begins ? time_s + dt_s : time_s - dt_s, others_);
  const double per_s = dt_s > 0.0 ? (begins ? -1.0 : 1.0) / dt_s : 0.0;
  for (std::size_t part = 0; part < poses_.size(); ++part) {
    const Vector3 velocity = per_s * (poses_[part].position - others_[part].position);
    const Vector3 spin = per_s * turn_between(others_[part].orientation, poses_[part].orientation);
    const std::size_t body = at(figure.first_part) + part;
    states[body] = moving_state(models[body], poses_[part], velocity, spin);
  }
}

double top_bound_m(const Figure& figure, const std::vector<BodyModel>& models) {
  // A part hangs from its anchor at whatever angle: what hangs from the part lies within reach of
  // the anchor by which it hangs. Worst where each limb points away from the root.
  std::vector<double> beyond_m(at(figure.part_count), 0.0);  // of a part's own anchor, leaves first
  for (std::size_t part = beyond_m.size(); part-- > 1;) {
    const Hinge& hinge = figure.hinges[part - 1];
    const Vector3& own = hinge.of_child.anchor;
    double reach = std::max(beyond_m[part], reach_from(models[at(hinge.child)], own));
    beyond_m[part] = reach;
    // As seen from the parent's own anchor (the root's from its centre of mass).
    const auto parent = at(hinge.parent - figure.first_part);
    const Vector3 from =
        parent == 0 ? Vector3(Vector3::Zero()) : figure.hinges[parent - 1].of_child.anchor;
    beyond_m[parent] = std::max(beyond_m[parent], (hinge.of_parent.anchor - from).norm() + reach);
  }
  return std::max(beyond_m.front(), models[at(figure.first_part)].tree->bounding_radius_m());
}

std::string problem_of(const Figure& figure, const std::vector<BodyModel>& models) {
  for (const std::string& problem :
       {problem_of_parts(figure, models), problem_of_hinges(figure),
        figure.driven ? problem_of(*figure.driven, figure.hinges.size()) : std::string()}) {
    if (!problem.empty()) {
      return "figure \"" + figure.name + "\": " + problem;
    }
  }
  return "";
}

std::string problem_of(const std::vector<Figure>& figures, const std::vector<BodyModel>& models,
                       const std::vector<BodyState>& states) {
  std::int32_t first_free = 0;
  for (const Figure& figure : figures) {
    std::string problem = problem_of(figure, models);
    if (!problem.empty()) {
      return problem;
    }
    if (figure.first_part < first_free) {
      return "figure \"" + figure.name + "\": expected parts after those of the figure before it";
    }
    problem = figure.driven ? "" : problem_of_places(figure, models, states);
    if (!problem.empty()) {
      return "figure \"" + figure.name + "\": " + problem;
    }
    first_free = figure.first_part + figure.part_count;
  }
  return "";
}

}  // namespace impetus::inline figures
