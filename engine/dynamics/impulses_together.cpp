// SPDX-License-Identifier: MIT
#include "engine/dynamics/impulses_together.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impetus {
namespace {

constexpr std::int32_t kNone = ContactArms::kNone;

/// Of the largest incoming speed: what the solver leaves, far below kNegligibleApproach.
constexpr double kTolerance = 1e-12;

/// C with C Cᵀ = `square`, symmetric and not negative: columns of no length where it is singular.
Matrix3 cholesky(const Matrix3& square) {
  Matrix3 factor = Matrix3::Zero();
  for (int j = 0; j < 3; ++j) {
    double pivot = square(j, j);
    for (int k = 0; k < j; ++k) {
      pivot -= factor(j, k) * factor(j, k);
    }
    if (!(pivot > 0.0)) {
      continue;
    }
    factor(j, j) = std::sqrt(pivot);
    for (int i = j + 1; i < 3; ++i) {
      double sum = square(i, j);
      for (int k = 0; k < j; ++k) {
        sum -= factor(i, k) * factor(j, k);
      }
      factor(i, j) = sum / factor(j, j);
    }
  }
  return factor;
}

double speed_along(const ConstraintRow& row, const std::vector<Vector6>& u) {
  double speed = 0.0;
  for (const RowPart* part : {&row.a, &row.b}) {
    if (part->body >= 0) {
      speed += part->direction.dot(u[static_cast<std::size_t>(part->body)]);
    }
  }
  return speed;
}

}  // namespace

bool ImpulsesTogether::respond(const std::vector<Contact>& contacts,
                               std::span<const std::size_t> members,
                               const std::vector<double>& restitutions, const ResponseRules& rules,
                               double fastest_m_s, ContactBodies& bodies,
                               std::vector<BodyState>& states, std::vector<double>& impulse_Ns) {
  contacts_ = &contacts;
  impulse_Ns_ = &impulse_Ns;
  members_ = members;
  describe(bodies);
  const bool limited = static_cast<std::size_t>(rules.most_passes) < 2 * members.size();
  const std::size_t could_be_active = std::min(members.size(), 6 * bodies_.size());
  const bool solved = !(limited && could_be_active > kMostTogetherWhenLimited) &&
                      run_rounds(restitutions, rules, kTolerance * fastest_m_s, states);
  for (const ScaledBody& body : bodies_) {
    bodies.follow(body.place, states);
  }
  return solved;
}

void ImpulsesTogether::describe(const ContactBodies& bodies) {
  for (const ScaledBody& body : bodies_) {
    if (static_cast<std::size_t>(body.place) < local_places_.size()) {
      local_places_[static_cast<std::size_t>(body.place)] = kNone;
    }
  }
  local_places_.resize(bodies.body_count(), kNone);
  bodies_.clear();
  rows_.clear();
  lengths_.clear();
  for (const std::size_t member : members_) {
    const ContactArms& contact = bodies.contact(member);
    ConstraintRow row;
    row.a = part_of(contact.a, contact.arm_a, contact.normal, 1.0, bodies);
    row.b = part_of(contact.b, contact.arm_b, contact.normal, -1.0, bodies);
    lengths_.push_back(std::sqrt(row.a.direction.squaredNorm() + row.b.direction.squaredNorm()));
    rows_.push_back(row);
  }
}

RowPart ImpulsesTogether::part_of(std::int32_t place, const Vector3& arm, const Vector3& normal,
                                  double sign, const ContactBodies& bodies) {
  if (!bodies.moves(place)) {
    return {};
  }
  RowPart part;
  part.body = local_place(place, bodies);
  const ScaledBody& scaled = bodies_[static_cast<std::size_t>(part.body)];
  part.direction.head<3>() = sign * scaled.root_of_inverse_mass * normal;
  part.direction.tail<3>() = sign * (scaled.factor_transposed * Vector3(arm.cross(normal)));
  return part;
}

std::int32_t ImpulsesTogether::local_place(std::int32_t place, const ContactBodies& bodies) {
  std::int32_t& local = local_places_[static_cast<std::size_t>(place)];
  if (local == kNone) {
    local = static_cast<std::int32_t>(bodies_.size());
    const ContactBody& body = bodies.body(place);
    bodies_.push_back({place, body.index, std::sqrt(body.inverse_mass),
                       cholesky(body.inverse_inertia).transpose()});
  }
  return local;
}

bool ImpulsesTogether::run_rounds(const std::vector<double>& restitutions,
                                  const ResponseRules& rules, double tolerance_m_s,
                                  std::vector<BodyState>& states) {
  const std::size_t enough = 2 * rows_.size();  // there and back again
  const std::size_t rounds = std::min(enough, static_cast<std::size_t>(rules.most_passes));
  for (std::size_t round = 0; round < rounds; ++round) {
    find_approaching(restitutions, rules, tolerance_m_s, states);
    if (problem_.empty()) {
      return true;
    }
    if (!solve(tolerance_m_s, states)) {
      return false;
    }
  }
  if (rounds < enough) {
    return true;
  }
  problem_.clear();
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    rows_[row].bound = 0.0;
    problem_.push_back(row);
  }
  scale_velocities(states);
  return solve(tolerance_m_s, states);
}

void ImpulsesTogether::find_approaching(const std::vector<double>& restitutions,
                                        const ResponseRules& rules, double tolerance_m_s,
                                        const std::vector<BodyState>& states) {
  scale_velocities(states);
  problem_.clear();
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const double speed = speed_along(rows_[row], u_);
    if (speed < -tolerance_m_s) {
      const double given_back = speed > -rules.resting_m_s ? 0.0 : restitutions[members_[row]];
      rows_[row].bound = -given_back * speed;
      problem_.push_back(row);
    }
  }
}

void ImpulsesTogether::scale_velocities(const std::vector<BodyState>& states) {
  u_.clear();
  for (const ScaledBody& body : bodies_) {
    const BodyState& state = states[body.index];
    Vector6 each;
    each.head<3>() = body.root_of_inverse_mass * state.linear_momentum;
    each.tail<3>() = body.factor_transposed * state.angular_momentum;
    u_.push_back(each);
  }
}

/// Moves `states` to the solution of the problem from `u_`, which are their velocities.
bool ImpulsesTogether::solve(double tolerance_m_s, std::vector<BodyState>& states) {
  double longest = 0.0;
  for (const std::size_t row : problem_) {
    longest = std::max(longest, lengths_[row]);
  }
  const double tolerance = longest > 0.0 ? tolerance_m_s / longest : 0.0;
  if (solver_.solve(rows_, problem_, u_, tolerance) != Projection::kSolved) {
    return false;
  }
  for (std::size_t i = 0; i < problem_.size(); ++i) {
    push(problem_[i], solver_.multipliers()[i], states);
  }
  return true;
}

/// Momentum changes by the same impulse on both sides, so their sum is kept to rounding.
void ImpulsesTogether::push(std::size_t row, double impulse_Ns, std::vector<BodyState>& states) {
  if (impulse_Ns == 0.0) {
    return;
  }
  const std::size_t contact = members_[row];
  (*impulse_Ns_)[contact] += impulse_Ns;
  const Vector3& point = (*contacts_)[contact].touch.point;
  const Vector3 impulse = impulse_Ns * (*contacts_)[contact].touch.normal;
  for (const auto& [part, sign] : {std::pair(&rows_[row].a, 1.0), std::pair(&rows_[row].b, -1.0)}) {
    if (part->body >= 0) {
      BodyState& state = states[bodies_[static_cast<std::size_t>(part->body)].index];
      state.linear_momentum += sign * impulse;
      state.angular_momentum += (point - state.pose.position).cross(Vector3(sign * impulse));
    }
  }
}

}  // namespace impetus
