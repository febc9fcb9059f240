// No reduction: the contact of every pair of overlapping nodes.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/collision/contact_reduction.hpp"

namespace impetus {

class EveryContact final : public ContactSums {
 public:
  static constexpr bool kWeighs = false;

  explicit EveryContact(const Vector3& /*fallback*/) {}

  void add(const NodeContact& contact) override { contacts_.push_back(contact.touch); }
  [[nodiscard]] std::vector<TouchPoint> reduced() const override { return contacts_; }

 private:
  std::vector<TouchPoint> contacts_;
};

}  // namespace impetus
