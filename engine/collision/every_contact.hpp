// No reduction: the contact of every pair of overlapping nodes.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "engine/collision/contact_reduction.hpp"

namespace impetus::inline collision {

class EveryContact final : public ContactSums {
 public:
  static constexpr bool kWeighs = false;

  void begin(const Vector3& /*fallback*/) override { contacts_.clear(); }
  void add(const NodeContact& contact) override { contacts_.push_back(contact.touch); }
  void add_touches(std::span<const TouchPoint> touches) override {
    contacts_.insert(contacts_.end(), touches.begin(), touches.end());
  }
  void reduce_to(std::vector<TouchPoint>& contacts) const override {
    contacts.insert(contacts.end(), contacts_.begin(), contacts_.end());
  }

 private:
  std::vector<TouchPoint> contacts_;
};

}  // namespace impetus::inline collision
