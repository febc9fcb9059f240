// The worked example of engine/README.md: a reduction of one's own.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/collision/contact_reduction.hpp"

namespace impetus {

/// The deepest contact alone; of equals the first to come.
class DeepestContact final : public ContactSums {
 public:
  static constexpr std::int64_t kMost = 1;
  static constexpr unsigned kTerms = 0;  // looks at nothing but where nodes touch

  void begin(const Vector3& /*fallback*/) override { deepest_.clear(); }

  void add(const NodeContact& contact) override {
    if (deepest_.empty() || contact.touch.depth_m > deepest_.front().depth_m) {
      deepest_.assign(1, contact.touch);
    }
  }
  void reduce_to(std::vector<TouchPoint>& contacts) const override {
    contacts.insert(contacts.end(), deepest_.begin(), deepest_.end());
  }

 private:
  std::vector<TouchPoint> deepest_;  // none or one
};

}  // namespace impetus
