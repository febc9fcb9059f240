// SPDX-License-Identifier: MIT
#include "experiments/trade/impacts/impact.hpp"

#include <cmath>
#include <utility>

#include "engine/dynamics/impulse.hpp"
#include "engine/numerics/elementary_functions.hpp"
#include "engine/shapes/mesh_distance.hpp"
#include "experiments/run/collision_truth.hpp"

namespace impetus::inline trade {
namespace {

constexpr double kLeastApproach = 0.2;  // of the speed: what touches more sidelong grazes
constexpr double kGap = 1e-7;           // of the smaller body's radius
constexpr double kStartApart = 4.0;     // reaches: further than any tree's bounds

double between(RandomStream& random, double least, double most) {
  return least + (most - least) * random.uniform();
}

/// Uniform in the ball of radius 1, in as many dimensions. (rejection: Marsaglia 1972)
template <int Dimensions>
Eigen::Matrix<double, Dimensions, 1> in_ball(RandomStream& random) {
  while (true) {
    Eigen::Matrix<double, Dimensions, 1> point;
    for (int i = 0; i < Dimensions; ++i) {
      point(i) = between(random, -1.0, 1.0);
    }
    if (point.squaredNorm() <= 1.0 && point.squaredNorm() > 1e-6) {
      return point;
    }
  }
}

Vector3 random_direction(RandomStream& random) { return in_ball<3>(random).normalized(); }

Quaternion random_turn(RandomStream& random) {
  const Eigen::Vector4d q = in_ball<4>(random).normalized();
  return {q(0), q(1), q(2), q(3)};
}

/// Uniform in the disc of radius 1 across `direction`.
Vector3 random_aside(RandomStream& random, const Vector3& direction) {
  const Vector3 across = direction.unitOrthogonal();
  const Eigen::Vector2d place = in_ball<2>(random);
  return place(0) * across + place(1) * direction.cross(across);
}

Pose moved(Pose pose, const Vector3& by) {
  pose.position += by;
  return pose;
}

void set_motion(const BodyModel& model, const Vector3& velocity_m_s, const Vector3& spin_rad_s,
                BodyState& state) {
  if (model.inverse_mass > 0.0) {
    state.linear_momentum = velocity_m_s / model.inverse_mass;
  }
  state.angular_momentum = angular_momentum_at(model, state.pose.orientation, spin_rad_s);
}

/// `drawn` is the motion of the scene; spins point anywhere.
struct DrawnMotion {
  double approach_m_s;
  Vector3 spin_a;
  Vector3 spin_b;
};

DrawnMotion drawn_motion(RandomStream& random, const ImpactPair& pair) {
  const MeetingMotion& motion = pair.motions[random.below(pair.motions.size())];
  const Vector3 axis_a = random_direction(random);
  const Vector3 axis_b = random_direction(random);
  return {motion.approach_m_s, motion.spin_a_rad_s * axis_a, motion.spin_b_rad_s * axis_b};
}

/// Of bodies that are `closest` once a has moved by `way_m`.
std::optional<ExactImpact> impact_of(const Approach& approach, const FirstTouch& found,
                                     const DrawnMotion& motion, const ImpactPair& pair) {
  ExactImpact impact;
  const ClosestPoints& closest = found.closest;
  impact.touch.normal = (closest.on_a - closest.on_b) / closest.distance_m;
  impact.touch.point = 0.5 * (closest.on_a + closest.on_b);
  impact.touch.depth_m = closest.distance_m;
  const double along = -impact.touch.normal.dot(approach.direction);
  if (along < kLeastApproach) {
    return std::nullopt;
  }
  BodyState of_a;
  BodyState of_b;
  const double way_m = found.way_m + 2.0 * closest.distance_m / along;
  of_a.pose = moved(approach.pose_a, way_m * approach.direction);
  of_b.pose = approach.pose_b;
  const Vector3 velocity = motion.approach_m_s * approach.direction;
  const bool moves_a = pair.a.model.inverse_mass > 0.0;
  set_motion(pair.a.model, moves_a ? velocity : Vector3::Zero(), motion.spin_a, of_a);
  set_motion(pair.b.model, moves_a ? Vector3::Zero() : Vector3(-velocity), motion.spin_b, of_b);
  impact.states = {of_a, of_b};
  impact.approach_m_s =
      -separation_speed({{0, 1}, impact.touch}, {pair.a.model, pair.b.model}, impact.states);
  const bool grazes = impact.approach_m_s < kLeastApproach * motion.approach_m_s;
  const bool crosses =
      closest_surfaces(pair.a.look, of_a.pose, pair.b.look, of_b.pose).distance_m <= 0.0;
  return grazes || !crosses ? std::nullopt : std::optional(std::move(impact));
}

}  // namespace

Approach next_approach(RandomStream& random, const ImpactPair& pair) {
  const double reach_m = pair.a.look.radius_m + pair.b.look.radius_m;
  Approach approach;
  approach.direction = random_direction(random);
  approach.pose_a.position = reach_m * random_aside(random, approach.direction) -
                             kStartApart * reach_m * approach.direction;
  approach.pose_a.orientation = random_turn(random);
  approach.pose_b.orientation = random_turn(random);
  const DrawnMotion motion = drawn_motion(random, pair);
  const auto closest_at = [&](double way_m) {
    return closest_surfaces(pair.a.look, moved(approach.pose_a, way_m * approach.direction),
                            pair.b.look, approach.pose_b);
  };
  const auto found =
      first_touch(closest_at, 0.5 * kGap * pair.size_m(), (kStartApart + 1.0) * reach_m);
  approach.touches = found.has_value();
  if (found) {
    approach.impact = impact_of(approach, *found, motion, pair);
  }
  return approach;
}

ImpactOutcome outcome_of(const std::vector<Contact>& contacts, const ExactImpact& impact,
                         const ImpactPair& pair, Responder& responder) {
  const std::vector<BodyModel> models{pair.a.model, pair.b.model};
  std::vector<BodyState> states = impact.states;
  ResponseRules rules;
  rules.method = pair.response;
  const ResponseResult& result = responder.respond(
      contacts, std::vector<double>(contacts.size(), pair.restitution), rules, models, states);
  ImpactOutcome outcome;
  outcome.net = net_contact(contacts, result.impulse_Ns);
  for (std::size_t body = 0; body < models.size(); ++body) {
    outcome.velocity_m_s[body] = velocity(models[body], states[body]);
    outcome.spin_rad_s[body] = angular_velocity(models[body], states[body]);
  }
  return outcome;
}

ImpactErrors errors_of(const ImpactOutcome& found, const ImpactOutcome& reference,
                       const ExactImpact& impact, const ImpactPair& pair) {
  const Vector3& x = found.net.normal;
  const Vector3& y = reference.net.normal;
  const std::array<double, 2> radii_m{pair.a.look.radius_m, pair.b.look.radius_m};
  double linear = 0.0;
  double angular = 0.0;
  for (std::size_t body = 0; body < radii_m.size(); ++body) {
    linear += (found.velocity_m_s[body] - reference.velocity_m_s[body]).squaredNorm();
    angular += radii_m[body] * radii_m[body] *
               (found.spin_rad_s[body] - reference.spin_rad_s[body]).squaredNorm();
  }
  return {degrees(atan2_rad(x.cross(y).norm(), x.dot(y))),
          (found.net.point - reference.net.point).norm() / pair.size_m(),
          std::sqrt(linear) / impact.approach_m_s, std::sqrt(angular) / impact.approach_m_s};
}

}  // namespace impetus::inline trade
