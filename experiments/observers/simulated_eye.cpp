// SPDX-License-Identifier: MIT
#include "experiments/observers/simulated_eye.hpp"

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

/// What stands still for the eye: slower is fixated, not followed.
constexpr double kStill_deg_s = 0.5;
/// Nearer than this, no saccade is made.
constexpr double kThere_deg = 0.2;

std::int64_t nanoseconds(double duration_ms) { return std::llround(duration_ms * 1e6); }

/// The share of a saccade's way done after a share of its time: the path of least jerk.
double minimum_jerk(double share) {
  return share * share * share * (10.0 + share * (6.0 * share - 15.0));
}

Eigen::Vector2d draw_normals(RandomStream& stream, double sd) {
  const double x = sd * draw_normal(stream);
  return {x, sd * draw_normal(stream)};
}

RandomStream stream_of(std::uint64_t seed, const char* purpose, const std::string& pseudonym) {
  return {seed, "eye/" + std::string(purpose) + "/" + pseudonym};
}

}  // namespace

EyeParameters usual_eye() {
  EyeParameters eye;
  eye.latency_ms = 8.0;
  eye.pair_share = 0.4;
  eye.pursuit_share = 0.7;
  eye.pursuit_gain = 0.95;
  eye.fixational_sd_deg = 0.1;
  eye.fixational_time_ms = 50.0;
  eye.offset_sd_deg = 0.5;
  eye.blink_per_s = 0.25;
  eye.dropout_per_s = 0.1;
  eye.dropout_ms = 60.0;
  return eye;
}

// ---------------------------------------------------------------- what is lost, what was seen

LossProcess::LossProcess(RandomStream stream, double per_s, double mean_ms, std::int64_t start_ns)
    : stream_(stream), per_s_(per_s), mean_ms_(mean_ms), to_ns_(static_cast<double>(start_ns)) {
  draw_next();
}

void LossProcess::draw_next() {
  from_ns_ = to_ns_ + 1e9 * draw_waiting(stream_, per_s_);
  to_ns_ = from_ns_ + 1e6 * draw_between(stream_, 0.5 * mean_ms_, 1.5 * mean_ms_);
}

bool LossProcess::lost_at(std::int64_t instant_ns) {
  const auto instant = static_cast<double>(instant_ns);
  while (to_ns_ <= instant) {
    draw_next();
  }
  return from_ns_ <= instant;
}

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

// ---------------------------------------------------------------- the eye

SimulatedEye::SimulatedEye(const EyeParameters& parameters, std::uint64_t seed,
                           const std::string& pseudonym, const Clock& clock)
    : parameters_(parameters),
      clock_(&clock),
      seen_(nanoseconds(parameters.visual_delay_ms)),
      looks_(stream_of(seed, "looks", pseudonym)),
      noise_(stream_of(seed, "noise", pseudonym)),
      blinks_(stream_of(seed, "blinks", pseudonym), parameters.blink_per_s, parameters.blink_ms,
              clock.now_ns()),
      dropouts_(stream_of(seed, "drop-outs", pseudonym), parameters.dropout_per_s,
                parameters.dropout_ms, clock.now_ns()),
      start_ns_(clock.now_ns()),
      since_ns_(start_ns_),
      until_ns_(start_ns_),
      now_ns_(start_ns_) {
  RandomStream traits = stream_of(seed, "traits", pseudonym);
  offset_deg_ = draw_normals(traits, parameters_.offset_sd_deg);
  fixational_deg_ = draw_normals(noise_, parameters_.fixational_sd_deg);
}

std::int64_t SimulatedEye::due_ns(std::int64_t sample) const {
  return start_ns_ + std::llround(static_cast<double>(sample) * 1e9 / parameters_.sampling_hz);
}

std::vector<GazeSample> SimulatedEye::take_samples() {
  const std::int64_t until_ns = clock_->now_ns() - nanoseconds(parameters_.latency_ms);
  std::vector<GazeSample> samples;
  for (; due_ns(next_sample_) <= until_ns; ++next_sample_) {
    samples.push_back(sample_at(due_ns(next_sample_)));
  }
  seen_.forget_before(now_ns_);
  return samples;
}

GazeSample SimulatedEye::sample_at(std::int64_t instant_ns) {
  advance_to(instant_ns);
  // An Ornstein-Uhlenbeck process, exact for any sampling rate.
  const double kept = std::exp(-1e3 / (parameters_.sampling_hz * parameters_.fixational_time_ms));
  fixational_deg_ = kept * fixational_deg_ + draw_normals(noise_, parameters_.fixational_sd_deg *
                                                                      std::sqrt(1.0 - kept * kept));
  const bool blink = blinks_.lost_at(instant_ns);
  const bool dropout = dropouts_.lost_at(instant_ns);
  if (blink || dropout) {
    return {instant_ns, std::nullopt, blink ? GazeLoss::kBlink : GazeLoss::kLost};
  }
  const ScreenGeometry screen = seen_.screen_at(instant_ns);
  const Eigen::Vector2d at_m =
      (gaze_deg_ + offset_deg_ + fixational_deg_) * metres_per_degree(screen.viewing_distance_m);
  const bool has_edges = screen.width_m > 0.0;
  if (has_edges &&
      (std::abs(at_m.x()) > 0.5 * screen.width_m || std::abs(at_m.y()) > 0.5 * screen.height_m)) {
    return {instant_ns, std::nullopt, GazeLoss::kOffScreen};
  }
  return {instant_ns, ScreenPoint{at_m.x(), at_m.y()}, GazeLoss::kNone};
}

void SimulatedEye::advance_to(std::int64_t instant_ns) {
  while (until_ns_ <= instant_ns) {
    move_to(until_ns_);
    if (movement_ == Movement::kSaccade) {
      start_look();
    } else {
      choose_target();
    }
  }
  move_to(instant_ns);
}

void SimulatedEye::move_to(std::int64_t instant_ns) {
  if (movement_ == Movement::kPursuit) {
    pursue_to(instant_ns);
    return;
  }
  if (movement_ == Movement::kSaccade) {
    const double share =
        static_cast<double>(instant_ns - since_ns_) / static_cast<double>(until_ns_ - since_ns_);
    gaze_deg_ = from_deg_ + minimum_jerk(share) * (to_deg_ - from_deg_);
  }
  now_ns_ = instant_ns;
}

/// The distance left falls by de/dt = (1 − gain) v − e / time, solved over the interval.
void SimulatedEye::pursue_to(std::int64_t instant_ns) {
  const double elapsed_s = static_cast<double>(instant_ns - now_ns_) / 1e9;
  const double time_s = parameters_.pursuit_time_ms / 1e3;
  const double left = std::exp(-elapsed_s / time_s);
  const MovingPoint point = seen_.predicted(target_, instant_ns);
  const Eigen::Vector2d before = point.at_deg - point.deg_per_s * elapsed_s - gaze_deg_;
  const Eigen::Vector2d lag = (1.0 - parameters_.pursuit_gain) * time_s * point.deg_per_s;
  const Eigen::Vector2d distance = lag + left * (before - lag);
  gaze_deg_ = point.at_deg - distance;
  now_ns_ = instant_ns;
  if (distance.norm() > parameters_.catch_up_deg && instant_ns < until_ns_) {
    start_saccade(static_cast<double>(until_ns_ - instant_ns) / 1e6);
  }
}

void SimulatedEye::choose_target() {
  const std::int32_t bodies = seen_.count(now_ns_);
  target_ = {};
  if (bodies > 1 && looks_.uniform() < parameters_.pair_share) {
    target_ = seen_.nearest_to_colliding(now_ns_);
  } else if (bodies > 0) {
    target_.a = static_cast<std::int32_t>(looks_.below(static_cast<std::uint64_t>(bodies)));
  }
  const double speed_deg_s = seen_.predicted(target_, now_ns_).deg_per_s.norm();
  follows_ = speed_deg_s > kStill_deg_s && looks_.uniform() < parameters_.pursuit_share;
  start_saccade(
      follows_ ? draw_between(looks_, parameters_.pursuit_min_ms, parameters_.pursuit_max_ms)
               : draw_between(looks_, parameters_.fixation_min_ms, parameters_.fixation_max_ms));
}

/// Lands where the target is predicted to be by then, and looks there for `look_ms`.
void SimulatedEye::start_saccade(double look_ms) {
  look_ms_ = look_ms;
  const auto duration_ms = [&](const Eigen::Vector2d& to) {
    return parameters_.saccade_base_ms + parameters_.saccade_ms_per_deg * (to - gaze_deg_).norm();
  };
  const MovingPoint point = seen_.predicted(target_, now_ns_);
  if ((point.at_deg - gaze_deg_).norm() < kThere_deg) {
    start_look();
    return;
  }
  to_deg_ = point.at_deg + point.deg_per_s * (duration_ms(point.at_deg) / 1e3);
  movement_ = Movement::kSaccade;
  from_deg_ = gaze_deg_;
  since_ns_ = now_ns_;
  until_ns_ = now_ns_ + nanoseconds(duration_ms(to_deg_));
}

void SimulatedEye::start_look() {
  movement_ = follows_ ? Movement::kPursuit : Movement::kFixation;
  since_ns_ = now_ns_;
  until_ns_ = now_ns_ + nanoseconds(look_ms_);
}

}  // namespace impetus::inline observers
