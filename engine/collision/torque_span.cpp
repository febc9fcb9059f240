// SPDX-License-Identifier: MIT
#include "engine/collision/torque_span.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "engine/collision/push_cone.hpp"

namespace impetus {
namespace {

/// A wrench this near to the cone, as a share of a push of one, adds nothing to it.
constexpr double kAddsNothing = 1e-6;

std::vector<Wrench> wrenches_of(const std::vector<TouchPoint>& contacts, double size_m) {
  Vector3 mean = Vector3::Zero();
  for (const TouchPoint& contact : contacts) {
    mean += contact.point / static_cast<double>(contacts.size());
  }
  std::vector<Wrench> wrenches;
  wrenches.reserve(contacts.size());
  for (const TouchPoint& contact : contacts) {
    Wrench wrench;
    wrench.head<3>() = contact.normal;
    wrench.tail<3>() = Vector3(contact.point - mean).cross(contact.normal) / size_m;
    wrenches.push_back(wrench);
  }
  return wrenches;
}

/// The index of the wrench furthest from the cone; `wrenches.size()` when all lie in it.
std::size_t furthest_from(const PushCone& cone, const std::vector<Wrench>& wrenches) {
  std::size_t furthest = wrenches.size();
  double most = kAddsNothing;
  for (std::size_t i = 0; i < wrenches.size(); ++i) {
    const double distance = cone.distance(wrenches[i]);
    if (distance > most) {
      furthest = i;
      most = distance;
    }
  }
  return furthest;
}

}  // namespace

void keep_spanning_most_torque(std::vector<TouchPoint>& contacts, int most, double size_m) {
  assert(most >= 1 && size_m > 0.0);
  const auto limit = static_cast<std::size_t>(most);
  if (contacts.size() <= limit) {
    return;
  }
  const std::vector<Wrench> wrenches = wrenches_of(contacts, size_m);
  const auto deepest = std::max_element(
      contacts.begin(), contacts.end(),
      [](const TouchPoint& x, const TouchPoint& y) { return x.depth_m < y.depth_m; });
  std::vector<std::size_t> kept;
  PushCone cone;
  for (auto next = static_cast<std::size_t>(deepest - contacts.begin());
       next < contacts.size() && kept.size() < limit; next = furthest_from(cone, wrenches)) {
    kept.push_back(next);
    cone.add(wrenches[next]);
  }
  std::sort(kept.begin(), kept.end());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    contacts[i] = contacts[kept[i]];  // kept[i] >= i
  }
  contacts.resize(kept.size());
}

std::vector<TouchPoint> spanning_most_torque(std::vector<TouchPoint> contacts, int most,
                                             double size_m) {
  keep_spanning_most_torque(contacts, most, size_m);
  return contacts;
}

}  // namespace impetus
