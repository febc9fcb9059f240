// The average: mean point, mean normal made unit, greatest depth.
//
// Right where the contacts lie on one surface; of surfaces that face different ways it makes one
// contact that is on neither. (Dingliana 2002, sec. 4.2.2, eq. 4.4 and 4.5)
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/collision/contact_reduction.hpp"

namespace impetus {

class MeanContact final : public ContactSums {
 public:
  static constexpr std::int64_t kMost = 1;
  static constexpr bool kWeighs = false;

  explicit MeanContact(const Vector3& fallback) : fallback_(fallback) {}

  void add(const NodeContact& contact) override {
    points_ += contact.touch.point;
    normals_ += contact.touch.normal;
    depth_m_ = std::max(depth_m_, contact.touch.depth_m);
    ++count_;
  }

  [[nodiscard]] std::vector<TouchPoint> reduced() const override {
    if (count_ == 0) {
      return {};
    }
    const double length = normals_.norm();
    return {{points_ / static_cast<double>(count_),
             length > 0.0 ? Vector3(normals_ / length) : fallback_, depth_m_}};
  }

 private:
  Vector3 fallback_;
  Vector3 points_{Vector3::Zero()};
  Vector3 normals_{Vector3::Zero()};
  double depth_m_{0.0};
  std::int64_t count_{0};
};

}  // namespace impetus
