// SPDX-License-Identifier: MIT
#include "engine/collision/torque_span.hpp"

#include <algorithm>
#include <cassert>

namespace impetus::inline collision {
namespace {

/// A wrench this near to the cone, as a share of a push of one, adds nothing to it.
constexpr double kAddsNothing = 1e-6;

}  // namespace

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
    const double distance = cone_.distance(wrenches_[i]);
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
    cone_.add(wrenches_[next]);
  }
  std::sort(kept_.begin(), kept_.end());
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    contacts[i] = contacts[kept_[i]];  // kept_[i] >= i
  }
  contacts.resize(kept_.size());
}

std::vector<TouchPoint> spanning_most_torque(std::vector<TouchPoint> contacts, int most,
                                             double size_m) {
  TorqueSpan().keep_widest(contacts, most, size_m);
  return contacts;
}

}  // namespace impetus::inline collision
