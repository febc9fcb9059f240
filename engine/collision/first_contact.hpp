// The contact that was entered first, by the time since its nodes met.
//
// The thesis compares κ instead, which is relative to the smaller node and so depends on its size.
// A contact that parts gives the response nothing to do, so it counts only when none approaches;
// of equal times the deeper counts, of equals the first to come.
// (Dingliana 2002, sec. 4.2.1, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "engine/collision/contact_reduction.hpp"

namespace impetus::inline collision {

class FirstContact final : public ContactSums {
 public:
  static constexpr std::int64_t kMost = 1;

  void begin(const Vector3& /*fallback*/) override { first_.clear(); }

  void add(const NodeContact& contact) override {
    if (first_.empty() || was_before(contact, first_.front())) {
      first_.assign(1, contact);
    }
  }

  void reduce_to(std::vector<TouchPoint>& contacts) const override {
    for (const NodeContact& first : first_) {
      contacts.push_back(first.touch);
    }
  }

 private:
  static bool was_before(const NodeContact& x, const NodeContact& y) {
    return std::tuple(x.approach_m_s > 0.0, x.since_entry_s, x.touch.depth_m) >
           std::tuple(y.approach_m_s > 0.0, y.since_entry_s, y.touch.depth_m);
  }

  std::vector<NodeContact> first_;  ///< none or one
};

}  // namespace impetus::inline collision
