// The average: mean point, mean normal made unit, greatest depth.
//
// Right where the contacts lie on one surface; of surfaces that face different ways it makes one
// contact that is on neither. (Dingliana 2002, sec. 4.2.2, eq. 4.4 and 4.5)
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/collision/contact_reduction.hpp"

namespace impetus::inline collision {

class MeanContact final : public ContactSums {
 public:
  static constexpr std::int64_t kMost = 1;
  static constexpr bool kWeighs = false;

  void begin(const Vector3& fallback) override {
    *this = MeanContact();
    fallback_ = fallback;
  }

  void add(const NodeContact& contact) override { add_touches({&contact.touch, 1}); }

  void add_touches(std::span<const TouchPoint> touches) override {
    for (const TouchPoint& touch : touches) {
      points_ += touch.point;
      normals_ += touch.normal;
      depth_m_ = std::max(depth_m_, touch.depth_m);
    }
    count_ += static_cast<std::int64_t>(touches.size());
  }

  void reduce_to(std::vector<TouchPoint>& contacts) const override {
    if (count_ == 0) {
      return;
    }
    const double length = normals_.norm();
    contacts.push_back({points_ / static_cast<double>(count_),
                        length > 0.0 ? Vector3(normals_ / length) : fallback_, depth_m_});
  }

 private:
  Vector3 fallback_{Vector3::UnitX()};
  Vector3 points_{Vector3::Zero()};
  Vector3 normals_{Vector3::Zero()};
  double depth_m_{0.0};
  std::int64_t count_{0};
};

}  // namespace impetus::inline collision
