// SPDX-License-Identifier: MIT
#include "engine/collision/torque_span.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "engine/numerics/few.hpp"

namespace impetus::inline collision {
namespace {

/// Share of a generator's length: what of it is no longer beyond others depends on them.
constexpr double kDependent = 1e-9;
/// Share of the wrench's length: a generator along which less is left brings it no nearer.
constexpr double kNoNearer = 1e-10;

/// Independent generators in a space of six dimensions, and one that may depend on them.
constexpr std::size_t kMostMembers = 7;

/// A generator that has a part in the nearest point.
struct Member {
  std::size_t generator;
  double coefficient;
};

/// The nearest point of the cone on its way: of the generators that have a part in it, the wrench
/// is always left with nothing along them.
class NearestPush {
 public:
  NearestPush(const std::vector<Wrench>& generators, const Wrench& wrench)
      : generators_(generators), wrench_(wrench), left_(wrench) {}

  [[nodiscard]] double distance() const { return left_.norm(); }

  /// Goes nearer by the generator along which most is left; false when none brings it nearer.
  bool go_nearer() {
    const std::size_t next = steepest();
    if (next == generators_.size()) {
      return false;
    }
    members_.add({next, 0.0});
    Aims aims;
    if (!fit(aims)) {
      return false;
    }
    while (any_turns_negative(aims)) {
      drop_what_turns_negative(aims);
      fit(aims);
    }
    left_ = wrench_;
    for (std::size_t i = 0; i < members_.size(); ++i) {
      members_[i].coefficient = aims[i];
      left_ -= aims[i] * generators_[members_[i].generator];
    }
    return true;
  }

 private:
  using Aims = std::array<double, kMostMembers>;  ///< by member

  [[nodiscard]] bool any_turns_negative(const Aims& aims) const {
    return std::any_of(aims.begin(), aims.begin() + members_.size(),
                       [](double aim) { return aim <= 0.0; });
  }

  [[nodiscard]] std::size_t steepest() const {
    std::size_t best = generators_.size();
    double most = kNoNearer * wrench_.norm();
    for (std::size_t i = 0; i < generators_.size(); ++i) {
      const bool is_member =
          std::any_of(members_.begin(), members_.end(),
                      [i](const Member& member) { return member.generator == i; });
      const double along = generators_[i].dot(left_) / generators_[i].norm();
      if (!is_member && along > most) {
        best = i;
        most = along;
      }
    }
    return best;
  }

  /// The coefficients, of any sign, that bring the members nearest to the wrench, by Gram and
  /// Schmidt. False when a member depends on those before it.
  bool fit(Aims& aims) const {
    const std::size_t count = members_.size();
    std::array<Wrench, kMostMembers> axes;
    std::array<std::array<double, kMostMembers>, kMostMembers> along;
    for (std::size_t j = 0; j < count; ++j) {
      Wrench rest = generators_[members_[j].generator];
      const double length = rest.norm();
      for (std::size_t i = 0; i < j; ++i) {
        along[i][j] = axes[i].dot(rest);
        rest -= along[i][j] * axes[i];
      }
      along[j][j] = rest.norm();
      if (!(along[j][j] > kDependent * length)) {
        return false;
      }
      axes[j] = rest / along[j][j];
    }
    aims.fill(0.0);
    for (std::size_t j = count; j-- > 0;) {
      double sum = axes[j].dot(wrench_);
      for (std::size_t k = j + 1; k < count; ++k) {
        sum -= along[j][k] * aims[k];
      }
      aims[j] = sum / along[j][j];
    }
    return true;
  }

  /// Moves towards `aims` until a coefficient is zero, and drops it.
  void drop_what_turns_negative(const Aims& aims) {
    double step = 1.0;
    std::size_t first = members_.size();
    for (std::size_t i = 0; i < members_.size(); ++i) {
      const double now = members_[i].coefficient;
      if (aims[i] <= 0.0 && (first == members_.size() || now / (now - aims[i]) < step)) {
        step = now > 0.0 ? now / (now - aims[i]) : 0.0;
        first = i;
      }
    }
    for (std::size_t i = 0; i < members_.size(); ++i) {
      members_[i].coefficient += step * (aims[i] - members_[i].coefficient);
    }
    members_.remove(first);
  }

  const std::vector<Wrench>& generators_;
  const Wrench& wrench_;
  Wrench left_;
  Few<Member, kMostMembers> members_;
};

/// A wrench this near to the cone, as a share of a push of one, adds nothing to it.
constexpr double kAddsNothing = 1e-6;

}  // namespace

double distance_from_cone(const std::vector<Wrench>& generators, const Wrench& wrench) {
  NearestPush nearest(generators, wrench);
  // In exact numbers each set of members comes but once; the bound is against rounding.
  const std::size_t most_rounds = 3 * generators.size();
  for (std::size_t round = 0; round < most_rounds && nearest.go_nearer(); ++round) {
  }
  return nearest.distance();
}

void TorqueSpan::find_wrenches(const std::vector<TouchPoint>& contacts, double size_m) {
  Vector3 mean = Vector3::Zero();
  for (const TouchPoint& contact : contacts) {
    mean += contact.point / static_cast<double>(contacts.size());
  }
  wrenches_.clear();
  for (const TouchPoint& contact : contacts) {
    Wrench wrench;
    wrench.head<3>() = contact.normal;
    wrench.tail<3>() = Vector3(contact.point - mean).cross(contact.normal) / size_m;
    wrenches_.push_back(wrench);
  }
}

/// The index of the wrench furthest from the cone; the number of them when all lie in it.
std::size_t TorqueSpan::furthest() const {
  std::size_t furthest = wrenches_.size();
  double most = kAddsNothing;
  for (std::size_t i = 0; i < wrenches_.size(); ++i) {
    const double distance = distance_from_cone(cone_, wrenches_[i]);
    if (distance > most) {
      furthest = i;
      most = distance;
    }
  }
  return furthest;
}

void TorqueSpan::keep_widest(std::vector<TouchPoint>& contacts, int most, double size_m) {
  assert(most >= 1 && size_m > 0.0);
  const auto limit = static_cast<std::size_t>(most);
  if (contacts.size() <= limit) {
    return;
  }
  find_wrenches(contacts, size_m);
  const auto deepest = std::max_element(
      contacts.begin(), contacts.end(),
      [](const TouchPoint& x, const TouchPoint& y) { return x.depth_m < y.depth_m; });
  kept_.clear();
  cone_.clear();
  for (auto next = static_cast<std::size_t>(deepest - contacts.begin());
       next < contacts.size() && kept_.size() < limit; next = furthest()) {
    kept_.push_back(next);
    cone_.push_back(wrenches_[next]);
  }
  std::sort(kept_.begin(), kept_.end());
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    contacts[i] = contacts[kept_[i]];  // kept_[i] >= i
  }
  contacts.resize(kept_.size());
}

}  // namespace impetus::inline collision
