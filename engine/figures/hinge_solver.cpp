// SPDX-License-Identifier: MIT
#include "engine/figures/hinge_solver.hpp"

#include <algorithm>

namespace impetus::inline figures {
namespace {

using Matrix56 = Eigen::Matrix<double, 5, 6>;

/// v of cross(r) w = r × w.
Matrix3 cross_matrix(const Vector3& r) {
  Matrix3 cross;
  cross << 0.0, -r.z(), r.y(), r.z(), 0.0, -r.x(), -r.y(), r.x(), 0.0;
  return cross;
}

/// How the anchor of a part moves, and how it turns across the axis.
Matrix56 rows_of(const Vector3& arm, const Vector3& across, const Vector3& across_too) {
  Matrix56 rows = Matrix56::Zero();
  rows.block<3, 3>(0, 0) = Matrix3::Identity();
  rows.block<3, 3>(0, 3) = -cross_matrix(arm);
  rows.block<1, 3>(3, 3) = across.transpose();
  rows.block<1, 3>(4, 3) = across_too.transpose();
  return rows;
}

Vector6 joined(const Vector3& linear, const Vector3& angular) {
  Vector6 both;
  both << linear, angular;
  return both;
}

bool are_equal(const Pose& a, const Pose& b) {
  return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs();
}

}  // namespace

HingeSolver::HingeSolver(const Figure& figure, const std::vector<BodyModel>& models)
    : nothing_(figure.hinges.size(), Vector5::Zero()) {
  parts_.resize(static_cast<std::size_t>(figure.part_count));
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const BodyModel& model = models[static_cast<std::size_t>(figure.first_part) + part];
    parts_[part].inverse_mass = model.inverse_mass;
    if (model.inverse_mass > 0.0) {
      parts_[part].own_inertia = model.inverse_inertia.inverse();
    }
  }
  for (const Hinge& hinge : figure.hinges) {
    Joint joint;
    joint.parent = static_cast<std::size_t>(hinge.parent - figure.first_part);
    joints_.push_back(joint);
    child_sides_.push_back(hinge.of_child);
    parent_sides_.push_back(hinge.of_parent);
  }
}

void HingeSolver::look_at(std::span<const BodyState> parts) {
  const bool as_before = is_placed_ && std::equal(parts_.begin(), parts_.end(), parts.begin(),
                                                  [](const Part& part, const BodyState& state) {
                                                    return are_equal(part.pose, state.pose);
                                                  });
  if (!as_before) {
    place(parts);
    is_placed_ = true;
    is_factored_ = false;
  }
}

void HingeSolver::place(std::span<const BodyState> parts) {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Part& part = parts_[i];
    part.pose = parts[i].pose;
    part.inertia.setZero();
    if (part.inverse_mass > 0.0) {
      const Matrix3 rotation = part.pose.orientation.toRotationMatrix();
      const Matrix3 inertia = rotation * part.own_inertia * rotation.transpose();
      part.inertia.block<3, 3>(0, 0) = 1.0 / part.inverse_mass * Matrix3::Identity();
      part.inertia.block<3, 3>(3, 3) = inertia;
      part.inverse_inertia = inertia.inverse();
    }
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Pose& child = parts_[i + 1].pose;
    const Pose& parent = parts_[joints_[i].parent].pose;
    const Vector3 meeting =
        0.5 * (child.transform(child_sides_[i].anchor) + parent.transform(parent_sides_[i].anchor));
    const Vector3 across = parent.orientation * parent_sides_[i].zero;
    const Vector3 across_too =
        parent.orientation * Vector3(parent_sides_[i].axis.cross(parent_sides_[i].zero));
    joints_[i].of_child = rows_of(meeting - child.position, across, across_too);
    joints_[i].of_parent = -rows_of(meeting - parent.position, across, across_too);
  }
}

void HingeSolver::factor() {
  is_factored_ = true;
  for (std::size_t i = joints_.size(); i-- > 0;) {
    Joint& joint = joints_[i];
    Part& child = parts_[i + 1];
    child.factor.factor(child.inertia);
    for (int row = 0; row < 5; ++row) {
      joint.child_response.row(row) =
          child.factor.solve(joint.of_child.row(row).transpose()).transpose();
    }
    joint.stiffness.factor(joint.child_response * joint.of_child.transpose());
    for (int column = 0; column < 6; ++column) {
      joint.parent_share.col(column) = joint.stiffness.solve(joint.of_parent.col(column));
    }
    parts_[joint.parent].inertia += joint.of_parent.transpose() * joint.parent_share;
  }
  if (parts_.front().inverse_mass > 0.0) {
    parts_.front().factor.factor(parts_.front().inertia);
  }
}

void HingeSolver::solve(std::span<const Vector5> asked) {
  if (!is_factored_) {
    factor();
  }
  for (std::size_t i = joints_.size(); i-- > 0;) {
    Joint& joint = joints_[i];
    joint.impulse = joint.stiffness.solve(asked[i] - joint.child_response * parts_[i + 1].impulse);
    parts_[joint.parent].impulse += joint.of_parent.transpose() * joint.impulse;
  }
  Part& root = parts_.front();
  root.change = root.inverse_mass > 0.0 ? root.factor.solve(root.impulse) : Vector6::Zero();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    Joint& joint = joints_[i];
    Part& child = parts_[i + 1];
    joint.impulse -= joint.parent_share * parts_[joint.parent].change;
    child.change =
        child.factor.solve(child.impulse) + joint.child_response.transpose() * joint.impulse;
  }
}

void HingeSolver::add_hinge_impulses(std::vector<PartImpulse>& impulses) {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    parts_[i].impulse = joined(impulses[i].linear, impulses[i].angular);
  }
  solve(nothing_);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    add_impulse_of(i, joints_[i].impulse, impulses);
  }
}

void HingeSolver::find_hinge_impulses(std::span<const Vector5> asked,
                                      std::vector<Vector5>& of_hinges) {
  for (Part& part : parts_) {
    part.impulse.setZero();
  }
  solve(asked);
  of_hinges.clear();
  for (const Joint& joint : joints_) {
    of_hinges.push_back(joint.impulse);
  }
}

void HingeSolver::add_impulses_of(std::span<const Vector5> of_hinges,
                                  std::vector<PartImpulse>& impulses) const {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    add_impulse_of(i, of_hinges[i], impulses);
  }
}

void HingeSolver::add_impulse_of(std::size_t hinge, const Vector5& impulse,
                                 std::vector<PartImpulse>& impulses) const {
  const Joint& joint = joints_[hinge];
  const Vector6 on_child = joint.of_child.transpose() * impulse;
  const Vector6 on_parent = joint.of_parent.transpose() * impulse;
  impulses[hinge + 1].linear += on_child.head<3>();
  impulses[hinge + 1].angular += on_child.tail<3>();
  impulses[joint.parent].linear += on_parent.head<3>();
  impulses[joint.parent].angular += on_parent.tail<3>();
}

void HingeSolver::push_parts(std::span<const PartImpulse> impulses,
                             std::span<BodyState> parts) const {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i].inverse_mass > 0.0) {
      parts[i].linear_momentum += impulses[i].linear;
      parts[i].angular_momentum += impulses[i].angular;
    }
  }
}

Vector6 HingeSolver::velocity_of(std::size_t part, std::span<const BodyState> parts) const {
  return joined(parts_[part].inverse_mass * parts[part].linear_momentum,
                parts_[part].inverse_inertia * parts[part].angular_momentum);
}

Vector5 HingeSolver::speed_across(std::size_t hinge, std::span<const BodyState> parts) const {
  const Joint& joint = joints_[hinge];
  return joint.of_child * velocity_of(hinge + 1, parts) +
         joint.of_parent * velocity_of(joint.parent, parts);
}

bool HingeSolver::nothing_moves_across(double share, std::span<const BodyState> parts) const {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Vector6 of_child = velocity_of(i + 1, parts);
    const Vector6 of_parent = velocity_of(joints_[i].parent, parts);
    const Vector5 child = joints_[i].of_child * of_child;
    const Vector5 parent = joints_[i].of_parent * of_parent;
    const Vector5 across = child + parent;
    const double speed = child.head<3>().norm() + parent.head<3>().norm();
    const double spin = of_child.tail<3>().norm() + of_parent.tail<3>().norm();
    if (!(across.head<3>().norm() <= share * speed && across.tail<2>().norm() <= share * spin)) {
      return false;
    }
  }
  return true;
}

}  // namespace impetus::inline figures
