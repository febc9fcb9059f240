// SPDX-License-Identifier: MIT
#include "engine/collision_reports.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace impetus {
namespace {

bool comes_first(const ModelledCollision& x, const ModelledCollision& y) {
  const BodyPair& of_x = x.report.bodies;
  const BodyPair& of_y = y.report.bodies;
  return std::pair(of_x.a, of_x.b) < std::pair(of_y.a, of_y.b);
}

bool is_shallower(const Contact& x, const Contact& y) { return x.touch.depth_m < y.touch.depth_m; }

/// The reported contacts of a collision, by their index.
std::pair<std::size_t, std::size_t> range_of(const CollisionReport& collision) {
  const auto first = static_cast<std::size_t>(collision.first_contact);
  return {first, first + static_cast<std::size_t>(collision.contact_count)};
}

}  // namespace

void add_by_bodies(const CollisionReport& like, const std::vector<Contact>& contacts,
                   std::vector<ModelledCollision>& modelled) {
  const BodyPair* bodies = nullptr;
  for (const Contact& contact : contacts) {
    if (bodies == nullptr || !(*bodies == contact.bodies)) {
      modelled.push_back({like, {}});
      modelled.back().report.bodies = contact.bodies;
      bodies = &contact.bodies;
    }
    modelled.back().contacts.push_back(contact);
  }
}

void report_in_order(std::vector<ModelledCollision> modelled, StepReport& report) {
  std::stable_sort(modelled.begin(), modelled.end(), comes_first);
  for (ModelledCollision& each : modelled) {
    each.report.contact =
        *std::max_element(each.contacts.begin(), each.contacts.end(), is_shallower);
    each.report.first_contact = static_cast<std::int32_t>(report.contacts.size());
    each.report.contact_count = static_cast<std::int32_t>(each.contacts.size());
    report.collisions.push_back(each.report);
    for (const Contact& contact : each.contacts) {
      report.contacts.push_back({contact.touch});
    }
  }
}

std::vector<Contact> contacts_to_respond_to(const StepReport& report) {
  std::vector<Contact> contacts;
  contacts.reserve(report.contacts.size());
  for (const CollisionReport& collision : report.collisions) {
    const auto [first, end] = range_of(collision);
    for (std::size_t i = first; i < end; ++i) {
      contacts.push_back({collision.bodies, report.contacts[i].touch});
    }
  }
  return contacts;
}

void report_response(const ResponseResult& result, StepReport& report) {
  for (CollisionReport& collision : report.collisions) {
    const auto [first, end] = range_of(collision);
    for (std::size_t i = first; i < end; ++i) {
      ReportedContact& contact = report.contacts[i];
      contact.approach_m_s = result.approach_m_s[i];
      contact.impulse_Ns = result.impulse_Ns[i];
      collision.approach_m_s = std::max(collision.approach_m_s, contact.approach_m_s);
      collision.impulse_Ns += contact.impulse_Ns;
    }
  }
}

}  // namespace impetus
