// SPDX-License-Identifier: MIT
#include "engine/dynamics/impulses_together.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace impetus::inline dynamics {
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

/// Whether more contacts than kMostTogetherWhenLimited could be active at once.
bool is_large(std::span<const std::size_t> members, const ContactBodies& bodies) {
  constexpr std::size_t kMostBodies = kMostTogetherWhenLimited / 6;
  if (members.size() <= kMostTogetherWhenLimited) {
    return false;
  }
  std::array<std::int32_t, kMostBodies> found{};
  std::size_t count = 0;
  for (const std::size_t member : members) {
    for (const std::int32_t place : {bodies.contact(member).a, bodies.contact(member).b}) {
      const auto end = found.begin() + static_cast<std::ptrdiff_t>(count);
      if (!bodies.moves(place) || std::find(found.begin(), end, place) != end) {
        continue;
      }
      if (count == kMostBodies) {
        return true;
      }
      found[count++] = place;
    }
  }
  return false;
}

}  // namespace

bool ImpulsesTogether::respond(const std::vector<Contact>& contacts,
                               std::span<const std::size_t> members,
                               const std::vector<double>& restitutions, const ResponseRules& rules,
                               double fastest_m_s, ContactBodies& bodies,
                               std::vector<BodyState>& states, std::vector<double>& impulse_Ns) {
  const bool limited = static_cast<std::size_t>(rules.most_passes) < 2 * members.size();
  if (limited && is_large(members, bodies)) {
    return false;
  }
  contacts_ = &contacts;
  impulse_Ns_ = &impulse_Ns;
  members_ = members;
  describe(bodies);
  const bool solved = run_rounds(restitutions, rules, kTolerance * fastest_m_s, states);
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
  pairs_.clear();
  rows_.clear();
  for (std::size_t begin = 0; begin < members_.size();) {
    const ContactArms& first = bodies.contact(members_[begin]);
    std::size_t end = begin + 1;
    while (end < members_.size() && end < begin + kRowLanes &&
           bodies.contact(members_[end]).a == first.a &&
           bodies.contact(members_[end]).b == first.b) {
      ++end;
    }
    add_rows(members_.subspan(begin, end - begin), bodies);
    begin = end;
  }
  unit_rows_.make_unit(rows_, lengths_);
  bounds_.resize(rows_.size());
}

/// Of contacts of the same two bodies, one to four.
void ImpulsesTogether::add_rows(std::span<const std::size_t> run, const ContactBodies& bodies) {
  const ContactArms& first = bodies.contact(run.front());
  const std::int32_t a = bodies.moves(first.a) ? local_place(first.a, bodies) : kNone;
  const std::int32_t b = bodies.moves(first.b) ? local_place(first.b, bodies) : kNone;
  pairs_.insert(pairs_.end(), run.size(), BodyPair{a, b});
  LanesOf3 normals{};
  LanesOf3 arms_a{};
  LanesOf3 arms_b{};
  for (std::size_t lane = 0; lane < run.size(); ++lane) {
    const ContactArms& contact = bodies.contact(run[lane]);
    for (int i = 0; i < 3; ++i) {
      normals[i][lane] = contact.normal[i];
      arms_a[i][lane] = contact.arm_a[i];
      arms_b[i][lane] = contact.arm_b[i];
    }
  }
  RowBlock& block = rows_.add_block(a, b, run.size());
  fill(block.of_a, a, 1.0, arms_a, normals);
  fill(block.of_b, b, -1.0, arms_b, normals);
}

/// ± (n / √m, Cᵀ (r × n)), nothing where there is no body.
void ImpulsesTogether::fill(LanesOf6& lanes, std::int32_t local, double sign, const LanesOf3& arms,
                            const LanesOf3& normals) const {
  if (local == kNone) {
    return;
  }
  const ScaledBody& body = bodies_[static_cast<std::size_t>(local)];
  const double push = sign * body.root_of_inverse_mass;
  const Matrix3& turn = body.factor_transposed;
  for (std::size_t lane = 0; lane < kRowLanes; ++lane) {
    const double n0 = normals[0][lane];
    const double n1 = normals[1][lane];
    const double n2 = normals[2][lane];
    const double x = arms[1][lane] * n2 - arms[2][lane] * n1;
    const double y = arms[2][lane] * n0 - arms[0][lane] * n2;
    const double z = arms[0][lane] * n1 - arms[1][lane] * n0;
    lanes[0][lane] = push * n0;
    lanes[1][lane] = push * n1;
    lanes[2][lane] = push * n2;
    lanes[3][lane] = sign * (turn(0, 0) * x + (turn(0, 1) * y + turn(0, 2) * z));
    lanes[4][lane] = sign * (turn(1, 0) * x + (turn(1, 1) * y + turn(1, 2) * z));
    lanes[5][lane] = sign * (turn(2, 0) * x + (turn(2, 1) * y + turn(2, 2) * z));
  }
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
    bounds_[row] = 0.0;
    problem_.push_back(row);
  }
  scale_velocities(states);
  return solve(tolerance_m_s, states);
}

void ImpulsesTogether::find_approaching(const std::vector<double>& restitutions,
                                        const ResponseRules& rules, double tolerance_m_s,
                                        const std::vector<BodyState>& states) {
  scale_velocities(states);
  rows_.find_products(u_, speeds_);
  problem_.clear();
  for (std::size_t row = 0; row < speeds_.size(); ++row) {
    const double speed = speeds_[row];
    if (speed < -tolerance_m_s) {
      const double given_back = speed > -rules.resting_m_s ? 0.0 : restitutions[members_[row]];
      bounds_[row] = -given_back * speed;
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
  if (solver_.solve({unit_rows_, lengths_, bounds_}, problem_, u_, tolerance) !=
      Projection::kSolved) {
    return false;
  }
  for (const std::size_t row : problem_) {
    push(row, solver_.multipliers()[row], states);
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
  for (const auto& [local, sign] :
       {std::pair(pairs_[row].a, 1.0), std::pair(pairs_[row].b, -1.0)}) {
    if (local != kNone) {
      BodyState& state = states[bodies_[static_cast<std::size_t>(local)].index];
      state.linear_momentum += sign * impulse;
      state.angular_momentum += (point - state.pose.position).cross(Vector3(sign * impulse));
    }
  }
}

}  // namespace impetus::inline dynamics
