// SPDX-License-Identifier: MIT
#include "experiments/run/preview_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/dynamics/motion.hpp"

namespace impetus::inline run {
namespace {

constexpr double kContactInView_s = 0.25;
constexpr double kWorkInView_s = 4.0;
constexpr std::size_t kMostNodeContacts = 500;  // of a pair

/// A pause of the program (a window moved, a debugger) is not caught up with.
constexpr double kMostCaughtUp_s = 0.1;
/// What the steps of one frame may take by the clock; then the run falls behind.
constexpr std::int64_t kMostPerFrameNs = 30'000'000;

/// Of random regions: a preview has no trial whose seed they would follow.
constexpr std::uint64_t kPlacesSeed = 1;

constexpr double kStepsAveraged = 30.0;
constexpr double kPaceAveraged_s = 0.5;

}  // namespace

PreviewRun::PreviewRun(StagedScene scene, const Clock& clock)
    : clock_(&clock),
      start_(scene),
      run_(std::move(scene), kPlacesSeed, clock_),
      settings_(settings_of(start_)),
      start_energy_J_(start_.world.kinetic_energy_J()),
      latest_(start_.looks.size(), start_.step_hz) {
  run_.set_region_rule(settings_.region);
  run_.world().watch_pairs(true);
}

void PreviewRun::advance(double real_s) {
  if (!playing_) {
    return;
  }
  const double asked_s = std::min(real_s, kMostCaughtUp_s) * speed_;
  const double target = position_ + asked_s * scene().step_hz;
  const std::int64_t started_ns = clock_->now_ns();
  while (static_cast<double>(run_.number()) < target &&
         clock_->now_ns() - started_ns < kMostPerFrameNs) {
    step_once();
  }
  const double reached = std::min(target, static_cast<double>(run_.number()));
  if (real_s > 0.0) {
    const double share = (reached - position_) / (real_s * speed_ * scene().step_hz);
    pace_ += std::min(1.0, real_s / kPaceAveraged_s) * (share - pace_);
  }
  position_ = reached;
}

void PreviewRun::step() {
  playing_ = false;
  if (position_ >= static_cast<double>(run_.number())) {
    step_once();
  }
  position_ = static_cast<double>(run_.number());
}

void PreviewRun::restart() {
  const Schedule schedule = run_.world().settings().schedule;
  run_ = SceneRun(start_, kPlacesSeed, clock_);
  run_.world().watch_pairs(true);
  run_.world().set_schedule(schedule);
  apply_settings();
  latest_ = LatestDetail(start_.looks.size(), start_.step_hz);
  position_ = 0.0;
  pace_ = 1.0;
  collision_count_ = 0;
  contacts_.clear();
  node_contacts_.clear();
  pop_count_ = stopped_count_ = 0;
  degraded_counts_ = {};
  work_.clear();
}

void PreviewRun::apply_settings() {
  World& world = run_.world();
  if (!world.settings().figures.empty()) {
    settings_.response = ResponseMethod::kInTurn;  // figures have no other
  }
  world.set_contacts(contacts_of(settings_));
  world.set_tunnelling(settings_.tunnelling);
  world.set_response(settings_.response);
  world.set_rotation(settings_.rotation);
  world.set_costs(costs_of(settings_));
  world.watch_node_contacts(watches_node_contacts_);
  run_.set_region_rule(settings_.region);
  run_.set_budget(budget_of(settings_));
}

void PreviewRun::watch_node_contacts(bool watch) {
  watches_node_contacts_ = watch;
  run_.world().watch_node_contacts(watch);
  if (!watch) {
    node_contacts_.clear();
  }
}

void PreviewRun::change(const PreviewSettings& settings) {
  settings_ = settings;
  apply_settings();
  problem_ = problem_of(settings_);
  if (problem_.empty()) {
    run_.world().set_schedule(schedule_of(settings_));
  }
}

std::optional<GazeRegion> PreviewRun::region() const {
  if (!follows_region(run_.world().settings().schedule)) {
    return std::nullopt;
  }
  if (settings_.region.kind == RegionKind::kTracked) {
    return GazeRegion{looked_at(), settings_.region.radius_deg};
  }
  return run_.input().region;
}

ScreenPoint PreviewRun::looked_at() const { return gaze_.value_or(ScreenPoint{}); }

std::optional<GazeRegion> PreviewRun::region_of_step() {
  const std::optional<GazeRegion> region = run_.next_region(looked_at());
  return follows_region(run_.world().settings().schedule) ? region : std::nullopt;
}

void PreviewRun::step_once() {
  const std::int64_t started_ns = clock_->now_ns();
  const StepReport& report = run_.step(gaze_, region_of_step());
  const double taken_ms = static_cast<double>(clock_->now_ns() - started_ns) / 1e6;
  step_ms_ += (run_.number() == 1 ? 1.0 : 1.0 / kStepsAveraged) * (taken_ms - step_ms_);
  keep(report);
  forget_old();
}

void PreviewRun::keep(const StepReport& report) {
  for (const CollisionReport& collision : report.collisions) {
    collision_count_ += collision.began ? 1 : 0;
    keep_contacts(report, collision);
  }
  latest_.take(run_.number(), report);
  const bool by_tests = settings_.budget == BudgetUnit::kTests;
  work_.push_back({report.work_spent, report.work_floor,
                   by_tests ? settings_.tests_per_step : report.work_granted});
  pop_count_ += static_cast<std::int64_t>(report.pops.size());
  stopped_count_ += static_cast<std::int64_t>(report.stopped.size());
  for (std::size_t bit = 0; bit < degraded_counts_.size(); ++bit) {
    degraded_counts_[bit] += (report.degradations >> bit) & 1U;
  }
}

void PreviewRun::keep_contacts(const StepReport& report, const CollisionReport& collision) {
  const auto of_pair = [&collision](const auto& contact) {
    return contact.bodies == collision.bodies;
  };
  std::erase_if(contacts_, of_pair);
  std::erase_if(node_contacts_, of_pair);
  for (const TouchPoint& touch : touch_points(report, collision)) {
    contacts_.push_back({collision.bodies, touch, collision.list, run_.number()});
  }
  std::vector<TouchPoint> touches;
  for (const Contact& contact : report.node_contacts) {
    if (of_pair(contact)) {
      touches.push_back(contact.touch);
    }
  }
  // More could not be told apart.
  const std::size_t stride = 1 + touches.size() / kMostNodeContacts;
  for (std::size_t i = 0; i < touches.size(); i += stride) {
    node_contacts_.push_back({collision.bodies, touches[i], collision.list, run_.number()});
  }
}

void PreviewRun::forget_old() {
  while (!contacts_.empty() && freshness(contacts_.front()) <= 0.0) {
    contacts_.pop_front();
  }
  while (!node_contacts_.empty() && freshness(node_contacts_.front()) <= 0.0) {
    node_contacts_.pop_front();
  }
  while (work_.size() > work_span()) {
    work_.pop_front();
  }
}

double PreviewRun::energy_share() const {
  return start_energy_J_ > 0.0 ? run_.world().kinetic_energy_J() / start_energy_J_ : 0.0;
}

Viewer PreviewRun::viewer() const { return scene().viewer_at_time(position_ / scene().step_hz); }

Picture PreviewRun::picture() const {
  const double fraction = position_ - static_cast<double>(run_.number()) + 1.0;
  return picture_of(scene(), run_.poses(std::clamp(fraction, 0.0, 1.0)),
                    position_ / scene().step_hz, {});
}

double PreviewRun::freshness(const ShownContact& contact) const {
  const double age_s = static_cast<double>(run_.number() - contact.step) / scene().step_hz;
  return std::max(0.0, 1.0 - age_s / kContactInView_s);
}

std::vector<BodyDetail> PreviewRun::details() const {
  std::vector<BodyDetail> details = latest_.at(run_.number());
  for (BodyDetail& detail : details) {
    detail.list = -1;  // of a pair, which need not collide
  }
  for (const ScheduledPair& pair : pairs()) {
    for (const std::int32_t body : {pair.pair.a, pair.pair.b}) {
      if (!is_wall(body)) {
        BodyDetail& detail = details[static_cast<std::size_t>(body)];
        detail.list = detail.list < 0 ? pair.list : std::min(detail.list, pair.list);
        detail.level = std::max(detail.level, 0);
      }
    }
  }
  return details;
}

std::size_t PreviewRun::work_span() const {
  return static_cast<std::size_t>(std::lround(kWorkInView_s * scene().step_hz));
}

}  // namespace impetus::inline run
