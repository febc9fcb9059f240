// SPDX-License-Identifier: MIT
#include "experiments/run/body_detail.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline run {

LatestDetail::LatestDetail(std::size_t bodies, double step_hz)
    : steps_in_view_(std::llround(kDetailInView_s * step_hz)), bodies_(bodies) {}

void LatestDetail::take(std::int64_t step, const StepReport& report) {
  for (const CollisionReport& collision : report.collisions) {
    const BodyDetail detail{collision.list, collision.level};
    take(step, collision.bodies.a, detail);
    if (!is_wall(collision.bodies.b)) {
      take(step, collision.bodies.b, detail);
    }
  }
}

void LatestDetail::take(std::int64_t step, std::int32_t body, const BodyDetail& detail) {
  Collided& last = bodies_[static_cast<std::size_t>(body)];
  const bool again = last.step == step;
  last.detail.list = again ? std::min(last.detail.list, detail.list) : detail.list;
  last.detail.level = again ? std::max(last.detail.level, detail.level) : detail.level;
  last.step = step;
}

BodyDetail LatestDetail::of(std::size_t body, std::int64_t step) const {
  const Collided& last = bodies_[body];
  const bool in_view = last.step >= 0 && step - last.step < steps_in_view_;
  return in_view ? last.detail : BodyDetail{};
}

std::vector<BodyDetail> LatestDetail::at(std::int64_t step) const {
  std::vector<BodyDetail> details;
  details.reserve(bodies_.size());
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    details.push_back(of(body, step));
  }
  return details;
}

}  // namespace impetus::inline run
