// SPDX-License-Identifier: MIT
#include "experiments/observers/seen_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline observers {
namespace {

/// Over which velocity is seen: three frames at 60 Hz, and no rate at which it lies on a frame.
constexpr std::int64_t kWindow_ns = 55'000'000;
/// After which a picture that nothing followed is gone: a page or an interval is on show.
constexpr std::int64_t kGone_ns = 100'000'000;
/// Seen from here when no picture has said otherwise.
constexpr ScreenGeometry kNoScreen{0.0, 0.0, 0, 0, 0.57};

Eigen::Vector2d on_screen_deg(const Viewer& viewer, const Vector3& point) {
  const ScreenPoint at = projected(viewer, point).value_or(ScreenPoint{});
  return Eigen::Vector2d(at.x_m, at.y_m) / metres_per_degree(viewer.screen.viewing_distance_m);
}

/// Time until two balls touch when they keep their velocities (s); infinite when they will not.
double time_to_touch_s(const Vector3& apart, const Vector3& velocity, double reach_m) {
  const double speed2 = velocity.squaredNorm();
  const double closing = -apart.dot(velocity);
  const double beyond = apart.squaredNorm() - reach_m * reach_m;
  const double discriminant = closing * closing - speed2 * beyond;
  if (closing <= 0.0 || discriminant < 0.0) {
    return std::numeric_limits<double>::infinity();
  }
  return std::max(0.0, (closing - std::sqrt(discriminant)) / speed2);
}

}  // namespace

void SeenBodies::add(const Picture& picture, std::int64_t flipped_ns) {
  Seen seen{flipped_ns, picture.viewer, {}, {}, {}};
  for (const PosedBody& body : picture.bodies) {
    seen.places.push_back(body.pose.position);
    seen.radii_m.push_back(body.look.radius_m);
  }
  if (picture.target) {
    seen.places = {on_screen(picture.viewer, *picture.target)};
    seen.radii_m = {0.0};
    seen.target = picture.target;
  }
  pictures_.push_back(std::move(seen));
}

void SeenBodies::forget_before(std::int64_t instant_ns) {
  const std::int64_t needed_ns = instant_ns - delay_ns_ - kWindow_ns;
  while (pictures_.size() > 1 && pictures_[1].flipped_ns <= needed_ns) {
    pictures_.pop_front();
  }
}

SeenBodies::Two SeenBodies::known_at(std::int64_t instant_ns) const {
  const std::int64_t until_ns = instant_ns - delay_ns_;
  auto seen = std::find_if(pictures_.rbegin(), pictures_.rend(),
                           [&](const Seen& one) { return one.flipped_ns <= until_ns; });
  if (seen == pictures_.rend() || seen->places.empty() || until_ns - seen->flipped_ns > kGone_ns) {
    return {};
  }
  Two two{&*seen, &*seen, 0.0};
  for (; seen != pictures_.rend(); ++seen) {
    if (seen->places.size() != two.newest->places.size() || seen->target != two.newest->target ||
        two.newest->flipped_ns - seen->flipped_ns > kWindow_ns) {
      break;
    }
    two.earlier = &*seen;
  }
  two.apart_s = static_cast<double>(two.newest->flipped_ns - two.earlier->flipped_ns) / 1e9;
  return two;
}

std::int32_t SeenBodies::count(std::int64_t instant_ns) const {
  const Two known = known_at(instant_ns);
  return known.newest != nullptr ? static_cast<std::int32_t>(known.newest->places.size()) : 0;
}

MovingPoint SeenBodies::predicted(const EyeTarget& target, std::int64_t instant_ns) const {
  const Two known = known_at(instant_ns);
  if (known.newest == nullptr || target.a < 0 ||
      std::max(target.a, target.b) >= static_cast<std::int32_t>(known.newest->places.size())) {
    return {};
  }
  const auto place = [&](const Seen& seen) {
    const Eigen::Vector2d a = on_screen_deg(seen.viewer, seen.places[target.a]);
    return target.b < 0
               ? a
               : Eigen::Vector2d((a + on_screen_deg(seen.viewer, seen.places[target.b])) / 2.0);
  };
  MovingPoint point{place(*known.newest), Eigen::Vector2d::Zero()};
  if (known.apart_s > 0.0) {
    point.deg_per_s = (point.at_deg - place(*known.earlier)) / known.apart_s;
  }
  point.at_deg +=
      point.deg_per_s * (static_cast<double>(instant_ns - known.newest->flipped_ns) / 1e9);
  return point;
}

EyeTarget SeenBodies::nearest_to_colliding(std::int64_t instant_ns) const {
  const Two known = known_at(instant_ns);
  EyeTarget best;
  std::pair<double, double> least{std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::infinity()};
  const Seen& now = *known.newest;
  const Seen& then = *known.earlier;
  const auto bodies = static_cast<std::int32_t>(now.places.size());
  for (std::int32_t a = 0; a < bodies; ++a) {
    for (std::int32_t b = a + 1; b < bodies; ++b) {
      const Vector3 apart = now.places[b] - now.places[a];
      const Vector3 moved = apart - (then.places[b] - then.places[a]);
      const Vector3 velocity = known.apart_s > 0.0 ? Vector3(moved / known.apart_s) : moved;
      const double reach_m = now.radii_m[a] + now.radii_m[b];
      const std::pair soonness{time_to_touch_s(apart, velocity, reach_m), apart.norm() - reach_m};
      if (soonness < least) {
        least = soonness;
        best = {a, b};
      }
    }
  }
  return best;
}

ScreenGeometry SeenBodies::screen_at(std::int64_t instant_ns) const {
  const auto seen = std::find_if(pictures_.rbegin(), pictures_.rend(),
                                 [&](const Seen& one) { return one.flipped_ns <= instant_ns; });
  return seen != pictures_.rend() ? seen->viewer.screen : kNoScreen;
}

}  // namespace impetus::inline observers
