// Impulses found together as the method reads, island by island.
// SPDX-License-Identifier: MIT
#include "tests/engine/plain_response.hpp"
#include "tests/engine/once.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impetus::plain {
namespace {

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

/// A body in coordinates whose square is twice its kinetic energy: (P/√m, Cᵀ L), C Cᵀ = I⁻¹.
struct ScaledBody {
  std::size_t index;
  double root_of_inverse_mass;
  Matrix3 factor_transposed;
};

class Island {
 public:
  Island(const std::vector<Contact>& contacts, const std::vector<std::size_t>& members,
         const std::vector<BodyModel>& models, std::vector<BodyState>& states)
      : states_(states) {
    for (const std::size_t member : members) {
      const Contact& contact = contacts[member];
      contacts_.push_back(contact);
      ConstraintRow row;
      row.a = part_of(contact.bodies.a, contact, 1.0, models);
      row.b = part_of(contact.bodies.b, contact, -1.0, models);
      rows_.push_back(row);
    }
    impulses_Ns_.assign(contacts_.size(), 0.0);
  }

  /// False when a problem could not be solved; what was done until then stays.
  bool respond(const std::vector<double>& restitutions, double fastest_m_s) {
    const double tolerance_m_s = kTolerance * fastest_m_s;
    const std::size_t rounds = 2 * contacts_.size();  // there and back again
    for (std::size_t round = 0; round < rounds; ++round) {
      const std::vector<double> speeds = separation_speeds();
      std::vector<std::size_t> approaching;
      for (std::size_t i = 0; i < speeds.size(); ++i) {
        if (speeds[i] < -tolerance_m_s) {
          rows_[i].bound = -restitutions[i] * speeds[i];
          approaching.push_back(i);
        }
      }
      if (approaching.empty()) {
        return true;
      }
      if (!solve(approaching, tolerance_m_s)) {
        return false;
      }
    }
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      rows_[i].bound = 0.0;
      all.push_back(i);
    }
    return solve(all, tolerance_m_s);
  }

  [[nodiscard]] const std::vector<double>& impulses_Ns() const { return impulses_Ns_; }

 private:
  RowPart part_of(std::int32_t body, const Contact& contact, double sign,
                  const std::vector<BodyModel>& models) {
    if (is_wall(body) || !(models[static_cast<std::size_t>(body)].inverse_mass > 0.0)) {
      return {};
    }
    const std::int32_t local = local_index(static_cast<std::size_t>(body), models);
    const ScaledBody& scaled = bodies_[static_cast<std::size_t>(local)];
    const Vector3 arm = contact.touch.point - states_[scaled.index].pose.position;
    RowPart part;
    part.body = local;
    part.direction.head<3>() = sign * scaled.root_of_inverse_mass * contact.touch.normal;
    part.direction.tail<3>() =
        sign * (scaled.factor_transposed * Vector3(arm.cross(contact.touch.normal)));
    return part;
  }

  std::int32_t local_index(std::size_t body, const std::vector<BodyModel>& models) {
    const auto found = std::find_if(bodies_.begin(), bodies_.end(),
                                    [&](const ScaledBody& each) { return each.index == body; });
    if (found == bodies_.end()) {
      const Matrix3 inverse_inertia = world_inverse_inertia(models[body], states_[body]);
      bodies_.push_back(
          {body, std::sqrt(models[body].inverse_mass), cholesky(inverse_inertia).transpose()});
      return static_cast<std::int32_t>(bodies_.size()) - 1;
    }
    return static_cast<std::int32_t>(found - bodies_.begin());
  }

  [[nodiscard]] std::vector<Vector6> scaled_velocities() const {
    std::vector<Vector6> u;
    for (const ScaledBody& body : bodies_) {
      const BodyState& state = states_[body.index];
      Vector6 each;
      each.head<3>() = body.root_of_inverse_mass * state.linear_momentum;
      each.tail<3>() = body.factor_transposed * state.angular_momentum;
      u.push_back(each);
    }
    return u;
  }

  [[nodiscard]] std::vector<double> separation_speeds() const {
    const std::vector<Vector6> u = scaled_velocities();
    std::vector<double> speeds;
    for (const ConstraintRow& row : rows_) {
      double speed = 0.0;
      for (const RowPart* part : {&row.a, &row.b}) {
        if (part->body >= 0) {
          speed += part->direction.dot(u[static_cast<std::size_t>(part->body)]);
        }
      }
      speeds.push_back(speed);
    }
    return speeds;
  }

  bool solve(const std::vector<std::size_t>& which, double tolerance_m_s) {
    std::vector<ConstraintRow> problem;
    double longest = 0.0;
    for (const std::size_t i : which) {
      problem.push_back(rows_[i]);
      longest = std::max(longest, std::sqrt(rows_[i].a.direction.squaredNorm() +
                                            rows_[i].b.direction.squaredNorm()));
    }
    std::vector<Vector6> u = scaled_velocities();
    const double tolerance = longest > 0.0 ? tolerance_m_s / longest : 0.0;
    const NearestVelocities found = plain::project(problem, u, tolerance);
    for (std::size_t i = 0; i < which.size(); ++i) {
      push(which[i], found.multipliers[i]);
    }
    return found.outcome == Projection::kSolved;
  }

  /// Momentum changes by the same impulse on both sides, so their sum is kept to rounding.
  void push(std::size_t contact, double impulse_Ns) {
    if (impulse_Ns == 0.0) {
      return;
    }
    impulses_Ns_[contact] += impulse_Ns;
    const Vector3& point = contacts_[contact].touch.point;
    const Vector3 impulse = impulse_Ns * contacts_[contact].touch.normal;
    for (const auto& [part, sign] :
         {std::pair(&rows_[contact].a, 1.0), std::pair(&rows_[contact].b, -1.0)}) {
      if (part->body >= 0) {
        BodyState& state = states_[bodies_[static_cast<std::size_t>(part->body)].index];
        state.linear_momentum += sign * impulse;
        state.angular_momentum += (point - state.pose.position).cross(Vector3(sign * impulse));
      }
    }
  }

  std::vector<BodyState>& states_;
  std::vector<ScaledBody> bodies_;
  std::vector<Contact> contacts_;
  std::vector<ConstraintRow> rows_;
  std::vector<double> impulses_Ns_;
};

}  // namespace

ResponseResult respond_together(const std::vector<Contact>& contacts,
                                const std::vector<double>& restitutions,
                                const std::vector<BodyModel>& models,
                                std::vector<BodyState>& states) {
  ResponseResult result = plain::incoming(contacts, models, states);
  for (const std::vector<std::size_t>& members : plain::islands_of(contacts, models)) {
    std::vector<double> of_island;
    of_island.reserve(members.size());
    for (const std::size_t member : members) {
      of_island.push_back(restitutions[member]);
    }
    Island island(contacts, members, models, states);
    const bool solved = island.respond(of_island, result.fastest_m_s);
    for (std::size_t i = 0; i < members.size(); ++i) {
      result.impulse_Ns[members[i]] += island.impulses_Ns()[i];
    }
    if (!solved) {
      plain::respond_in_turn(contacts, members, restitutions, models, states, result.impulse_Ns);
    }
  }
  plain::measure_residual(contacts, models, states, result);
  return result;
}

}  // namespace impetus::plain
