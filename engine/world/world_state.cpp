// SPDX-License-Identifier: MIT
#include "engine/world/world_state.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/dynamics/limits.hpp"

namespace impetus::inline world {
namespace {

/// Whether it can be squared, and so can its inverse.
bool is_usable(double number) { return number >= 0.0 && number <= kMostNumber; }

const Vector3& vector_of(const BodyState& state, StateField field) {
  return field == StateField::kPosition         ? state.pose.position
         : field == StateField::kLinearMomentum ? state.linear_momentum
                                                : state.angular_momentum;
}

std::string text_of(const Vector3& v) {
  return "(" + std::to_string(v.x()) + ", " + std::to_string(v.y()) + ", " + std::to_string(v.z()) +
         ")";
}

/// Whether a symmetric matrix is 0 or more along every direction, to rounding: its principal minors
/// are.
bool is_never_negative(const Matrix3& matrix) {
  constexpr double kRounding = 1e-6;
  const double most = matrix.cwiseAbs().maxCoeff();
  const Matrix3 m = most > 0.0 ? Matrix3(matrix / most) : matrix;
  const auto minor = [&](int i, int j) { return m(i, i) * m(j, j) - m(i, j) * m(j, i); };
  return m.diagonal().minCoeff() >= -kRounding && minor(0, 1) >= -kRounding &&
         minor(0, 2) >= -kRounding && minor(1, 2) >= -kRounding && m.determinant() >= -kRounding;
}

std::string problem_of(const BodyModel& model) {
  if (model.tree == nullptr) {
    return "a volume tree, got none";
  }
  if (!is_usable(model.tree->bounding_radius_m())) {
    return "a tree of a finite size, got a radius of " +
           std::to_string(model.tree->bounding_radius_m()) + " m";
  }
  if (!is_usable(model.inverse_mass)) {
    return "an inverse mass of 0 or more, a finite number, got " +
           std::to_string(model.inverse_mass) + " 1/kg";
  }
  const Matrix3& inverse = model.inverse_inertia;
  if (!inverse.allFinite() || !is_usable(inverse.cwiseAbs().maxCoeff()) ||
      !(inverse.diagonal().minCoeff() >= 0.0)) {
    return "an inverse inertia of finite numbers, those on its diagonal 0 or more, got another";
  }
  const double rounding = 1e-6 * inverse.cwiseAbs().maxCoeff();
  if ((inverse - inverse.transpose()).cwiseAbs().maxCoeff() > rounding) {
    return "an inverse inertia that equals its transpose, got another";
  }
  return is_never_negative(inverse)
             ? ""
             : "an inverse inertia of 0 or more about every axis, got one below 0";
}

std::string problem_of(const BodyState& state) {
  if (!is_usable(state.held_s)) {
    return "to be held for 0 s or more, a finite number, got " + std::to_string(state.held_s) +
           " s";
  }
  constexpr double kOfUnit = 1e-6;
  const std::optional<StateField> field =
      std::abs(state.pose.orientation.coeffs().norm() - 1.0) > kOfUnit ? StateField::kOrientation
                                                                       : not_finite_field(state);
  if (!field) {
    return "";
  }
  const std::string name(name_of(*field));
  return *field == StateField::kOrientation
             ? "an orientation of unit length, got one of " +
                   std::to_string(state.pose.orientation.coeffs().norm())
             : (name.front() == 'a' ? "an " : "a ") + name + " of finite numbers, got " +
                   text_of(vector_of(state, *field));
}

}  // namespace

std::string problem_of(const std::vector<BodyModel>& models, const std::vector<BodyState>& states) {
  if (models.size() != states.size()) {
    return "world: one state per body model is needed";
  }
  for (std::size_t body = 0; body < models.size(); ++body) {
    for (const std::string& expected : {problem_of(models[body]), problem_of(states[body])}) {
      if (!expected.empty()) {
        return "world: body " + std::to_string(body) + " \"" + models[body].name + "\": expected " +
               expected;
      }
    }
  }
  return "";
}

WorldState::WorldState(std::vector<BodyModel> bodies, std::vector<BodyState> begun,
                       const WorldSettings& settings)
    : models(std::move(bodies)), states(std::move(begun)), finite(states) {
  std::string problem = problem_of(models, states);
  if (problem.empty()) {
    problem = problem_of(settings);
  }
  if (problem.empty()) {
    problem = problem_of(settings.figures, models, states);
    problem.insert(0, problem.empty() ? "" : "world: ");
  }
  if (!problem.empty()) {
    throw std::invalid_argument(problem);
  }
  for (BodyModel& body : models) {
    if (body.inverse_mass == 0.0) {
      body.inverse_inertia.setZero();
    }
    some_pass_through = some_pass_through || body.passes_through;
    placed.emplace_back(*body.tree);
  }
  order_bodies();
  if (!settings.figures.empty()) {
    figures = ValuePointer(Figures(settings.figures, models));
    figures->begin(settings.figures, states);
  }
}

/// Bodies are put in order along the axes at the start, which takes many times as long as keeping
/// them so.
void WorldState::order_bodies() {
  std::vector<MovedBound> bounds;
  for (std::size_t body = 0; body < models.size(); ++body) {
    const Sphere bound{states[body].pose.position, models[body].tree->bounding_radius_m()};
    bounds.push_back({bound, 0.0, models[body].inverse_mass > 0.0});
  }
  std::vector<BodyPair> pairs;
  broad_phase.find(bounds, pairs);
}

const TouchingPair* WorldState::touched_before(BodyPair bodies) const {
  const auto found = std::lower_bound(touching.begin(), touching.end(), bodies,
                                      [](const TouchingPair& pair, const BodyPair& wanted) {
                                        return std::pair(pair.bodies.a, pair.bodies.b) <
                                               std::pair(wanted.a, wanted.b);
                                      });
  return found != touching.end() && found->bodies == bodies ? &*found : nullptr;
}

}  // namespace impetus::inline world
