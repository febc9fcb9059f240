// SPDX-License-Identifier: MIT
#include "engine/world/collision_reports.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace impetus::inline world {
namespace {

bool comes_first(const CollisionReport& x, const CollisionReport& y) {
  return std::pair(x.bodies.a, x.bodies.b) < std::pair(y.bodies.a, y.bodies.b);
}

bool is_shallower(const Contact& x, const Contact& y) { return x.touch.depth_m < y.touch.depth_m; }

/// The reported contacts of a collision, by their index.
std::pair<std::size_t, std::size_t> range_of(const CollisionReport& collision) {
  const auto first = static_cast<std::size_t>(collision.first_contact);
  return {first, first + static_cast<std::size_t>(collision.contact_count)};
}

}  // namespace

void restart(StepReport& report) {
  StepReport fresh;
  const auto keep = [](auto& memory, auto& empty) {
    memory.clear();
    empty.swap(memory);
  };
  keep(report.collisions, fresh.collisions);
  keep(report.list_work, fresh.list_work);
  keep(report.state.bodies, fresh.state.bodies);
  keep(report.contacts, fresh.contacts);
  keep(report.pops, fresh.pops);
  keep(report.stopped, fresh.stopped);
  keep(report.node_contacts, fresh.node_contacts);
  keep(report.not_finite, fresh.not_finite);
  report = std::move(fresh);
}

void ModelledCollisions::clear() {
  collisions_.clear();
  contacts_.clear();
  taken_ = 0;
}

void ModelledCollisions::add_contacts_as(const CollisionReport& like) {
  for (; taken_ < contacts_.size(); ++taken_) {
    const BodyPair& bodies = contacts_[taken_].bodies;
    if (taken_ == 0 || !(bodies == contacts_[taken_ - 1].bodies)) {
      collisions_.push_back(like);
      collisions_.back().bodies = bodies;
      collisions_.back().first_contact = static_cast<std::int32_t>(taken_);
      collisions_.back().contact_count = 0;
    }
    ++collisions_.back().contact_count;
  }
}

void ModelledCollisions::report_in_order(StepReport& report) {
  std::sort(collisions_.begin(), collisions_.end(), comes_first);
  for (CollisionReport& each : collisions_) {
    const auto first = contacts_.begin() + each.first_contact;
    const auto end = first + each.contact_count;
    each.contact = *std::max_element(first, end, is_shallower);
    each.first_contact = static_cast<std::int32_t>(report.contacts.size());
    report.collisions.push_back(each);
    for (auto contact = first; contact != end; ++contact) {
      report.contacts.push_back({contact->touch});
    }
  }
}

void report_work(const WorkDone& work, StepReport& report) {
  report.work_granted = work.granted;
  report.work_spent = work.spent;
  report.work_floor = work.floor;
  report.work_reserved = work.reserved;
  report.work_peak = work.peak;
  report.list_work = work.by_list;
  if (report.work_granted < report.work_floor) {
    report.degradations |= kFloorOverBudget;
  }
}

void contacts_to_respond_to(const StepReport& report, std::vector<Contact>& contacts) {
  contacts.clear();
  for (const CollisionReport& collision : report.collisions) {
    const auto [first, end] = range_of(collision);
    for (std::size_t i = first; i < end; ++i) {
      contacts.push_back({collision.bodies, report.contacts[i].touch});
    }
  }
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

}  // namespace impetus::inline world
