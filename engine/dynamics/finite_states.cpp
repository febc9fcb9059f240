// SPDX-License-Identifier: MIT
#include "engine/dynamics/finite_states.hpp"

#include <cmath>

#include "engine/dynamics/limits.hpp"

namespace impetus::inline dynamics {
namespace {

/// The sum of the sizes of a vector's coordinates.
double size_of(const Vector3& v) { return std::abs(v.x()) + std::abs(v.y()) + std::abs(v.z()); }

bool is_a_number(const Vector3& v) {
  return v.cwiseAbs().maxCoeff() <= kMostNumber && v.allFinite();
}

/// Far from what rounding makes of a unit length. What is no number compares as false.
bool turns(const Quaternion& q) {
  const double size = std::abs(q.w()) + std::abs(q.x()) + std::abs(q.y()) + std::abs(q.z());
  return size >= 0.5 && size <= 4.0;
}

/// Surely finite: one comparison for all numbers of a state.
bool is_fine(const BodyState& state) {
  const double size = size_of(state.pose.position) + size_of(state.linear_momentum) +
                      size_of(state.angular_momentum);
  return size <= kMostNumber && turns(state.pose.orientation);
}

/// Where it was, as far as it is known, without momentum.
void put_back(const BodyState& before, BodyState& state) {
  if (!is_a_number(state.pose.position) || !turns(state.pose.orientation)) {
    state.pose = before.pose;
  }
  state.linear_momentum.setZero();
  state.angular_momentum.setZero();
  state.held_s = 0.0;
  state.held_fraction = 0.0;
}

}  // namespace

std::optional<StateField> not_finite_field(const BodyState& state) {
  if (!is_a_number(state.pose.position)) {
    return StateField::kPosition;
  }
  if (!turns(state.pose.orientation)) {
    return StateField::kOrientation;
  }
  if (!is_a_number(state.linear_momentum)) {
    return StateField::kLinearMomentum;
  }
  if (!is_a_number(state.angular_momentum)) {
    return StateField::kAngularMomentum;
  }
  return std::nullopt;
}

void FiniteStates::begin(std::vector<BodyState>& states, std::vector<NotFiniteBody>& found) {
  for (std::size_t body = 0; body < states.size(); ++body) {
    check(body, states[body], found);
  }
  before_ = states;
}

void FiniteStates::check(std::size_t body, BodyState& state, std::vector<NotFiniteBody>& found) {
  if (is_fine(state)) {
    return;
  }
  const std::optional<StateField> field = not_finite_field(state);
  if (!field) {
    return;
  }
  put_back(before_[body], state);
  if (!is_out(body)) {
    is_out_[body] = 1;
    any_out_ = true;
    found.push_back({static_cast<std::int32_t>(body), *field});
  }
}

void FiniteStates::take_out(std::size_t body, BodyState& state) {
  put_back(before_[body], state);
  is_out_[body] = 1;
  any_out_ = true;
}

}  // namespace impetus::inline dynamics
