// The contact that was entered first: the one with the greatest depth for its speed of approach.
//
// Depth over approach is the time since entry. The thesis compares κ instead, which is relative to
// the smaller node and so depends on its size. Contacts that part were not entered by this motion:
// they count when nothing approaches, the deepest first. Of equals the first to come.
// (Dingliana 2002, sec. 4.2.1, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/collision/contact_reduction.hpp"

namespace impetus {

class FirstContact final : public ContactSums {
 public:
  static constexpr std::int64_t kMost = 1;

  explicit FirstContact(const Vector3& /*fallback*/) {}

  void add(const NodeContact& contact) override {
    if (first_.empty() || was_before(contact, first_.front())) {
      first_.assign(1, contact);
    }
  }

  [[nodiscard]] std::vector<TouchPoint> reduced() const override {
    if (first_.empty()) {
      return {};
    }
    return {first_.front().touch};
  }

 private:
  static bool was_before(const NodeContact& x, const NodeContact& y) {
    const bool x_approaches = x.approach_m_s > 0.0;
    const bool y_approaches = y.approach_m_s > 0.0;
    if (x_approaches != y_approaches) {
      return x_approaches;
    }
    return x_approaches ? x.touch.depth_m * y.approach_m_s > y.touch.depth_m * x.approach_m_s
                        : x.touch.depth_m > y.touch.depth_m;
  }

  std::vector<NodeContact> first_;  ///< none or one
};

}  // namespace impetus
