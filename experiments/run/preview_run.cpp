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

double energy_J(const World& world) {
  double sum = 0.0;
  for (std::size_t body = 0; body < world.models().size(); ++body) {
    sum += kinetic_energy(world.models()[body], world.states()[body]);
  }
  return sum;
}

}  // namespace

PreviewRun::PreviewRun(StagedScene scene, const Clock& clock)
    : clock_(&clock),
      start_(scene),
      scene_(std::move(scene)),
      regions_(scene_, kPlacesSeed),
      settings_(settings_of(scene_)),
      start_energy_J_(energy_J(scene_.world)),
      before_(scene_.world.states()),
      latest_(before_.size(), scene_.step_hz) {
  regions_.set_rule(settings_.region);
  start_.world.watch_pairs(true);
  scene_.world.watch_pairs(true);
}

void PreviewRun::advance(double real_s) {
  if (!playing_) {
    return;
  }
  const double asked_s = std::min(real_s, kMostCaughtUp_s) * speed_;
  const double target = position_ + asked_s * scene_.step_hz;
  const std::int64_t started_ns = clock_->now_ns();
  while (static_cast<double>(step_) < target && clock_->now_ns() - started_ns < kMostPerFrameNs) {
    step_once();
  }
  const double reached = std::min(target, static_cast<double>(step_));
  if (real_s > 0.0) {
    const double share = (reached - position_) / (real_s * speed_ * scene_.step_hz);
    pace_ += std::min(1.0, real_s / kPaceAveraged_s) * (share - pace_);
  }
  position_ = reached;
}

void PreviewRun::step() {
  playing_ = false;
  if (position_ >= static_cast<double>(step_)) {
    step_once();
  }
  position_ = static_cast<double>(step_);
}

void PreviewRun::restart() {
  const Schedule schedule = scene_.world.settings().schedule;
  scene_ = start_;
  scene_.world.set_schedule(schedule);
  apply_settings();
  regions_ = RegionSource(scene_, kPlacesSeed);
  regions_.set_rule(settings_.region);
  input_ = {};
  before_ = scene_.world.states();
  latest_ = LatestDetail(before_.size(), scene_.step_hz);
  position_ = 0.0;
  step_ = 0;
  pace_ = 1.0;
  collision_count_ = 0;
  contacts_.clear();
  node_contacts_.clear();
  pop_count_ = stopped_count_ = 0;
  work_.clear();
}

void PreviewRun::apply_settings() {
  World& world = scene_.world;
  if (!world.settings().figures.empty()) {
    settings_.response = ResponseMethod::kInTurn;  // figures have no other
  }
  world.set_contacts(contacts_of(settings_));
  world.set_tunnelling(settings_.tunnelling);
  world.set_response(settings_.response);
  world.set_rotation(settings_.rotation);
  world.set_costs(costs_of(settings_));
  world.watch_node_contacts(watches_node_contacts_);
}

void PreviewRun::watch_node_contacts(bool watch) {
  watches_node_contacts_ = watch;
  scene_.world.watch_node_contacts(watch);
  if (!watch) {
    node_contacts_.clear();
  }
}

void PreviewRun::change(const PreviewSettings& settings) {
  settings_ = settings;
  regions_.set_rule(settings_.region);
  apply_settings();
  problem_ = problem_of(settings_);
  if (problem_.empty()) {
    scene_.world.set_schedule(schedule_of(settings_));
  }
}

std::optional<GazeRegion> PreviewRun::region() const {
  if (!follows_region(scene_.world.settings().schedule)) {
    return std::nullopt;
  }
  if (settings_.region.kind == RegionKind::kTracked) {
    return GazeRegion{looked_at(), settings_.region.radius_deg};
  }
  return input_.region;
}

ScreenPoint PreviewRun::looked_at() const { return gaze_.value_or(ScreenPoint{}); }

std::optional<GazeRegion> PreviewRun::region_of_step() {
  const std::optional<GazeRegion> region = regions_.at(step_ + 1, looked_at());
  return follows_region(scene_.world.settings().schedule) ? region : std::nullopt;
}

void PreviewRun::step_once() {
  before_ = scene_.world.states();
  const double time_s = static_cast<double>(step_ + 1) / scene_.step_hz;
  input_ = {1.0 / scene_.step_hz, scene_.viewer_at_time(time_s), gaze_, region_of_step()};
  const std::int64_t started_ns = clock_->now_ns();
  const StepReport report = step_world(input_);
  const double taken_ms = static_cast<double>(clock_->now_ns() - started_ns) / 1e6;
  step_ms_ += (step_ == 0 ? 1.0 : 1.0 / kStepsAveraged) * (taken_ms - step_ms_);
  ++step_;
  keep(report);
  forget_old();
}

StepReport PreviewRun::step_world(const StepInput& input) {
  if (settings_.budget == BudgetUnit::kMilliseconds) {
    DeadlineWork meter(*clock_, std::llround(settings_.ms_per_step * 1e6));
    meter.start_step();
    return scene_.world.step(input, meter);
  }
  const bool limited = settings_.budget == BudgetUnit::kTests;
  FixedWork meter(limited ? settings_.tests_per_step : kUnlimitedTests);
  return scene_.world.step(input, meter);
}

void PreviewRun::keep(const StepReport& report) {
  for (const CollisionReport& collision : report.collisions) {
    collision_count_ += collision.began ? 1 : 0;
    keep_contacts(report, collision);
  }
  latest_.take(step_, report);
  const bool by_tests = settings_.budget == BudgetUnit::kTests;
  work_.push_back({report.work_spent, report.work_floor,
                   by_tests ? settings_.tests_per_step : report.work_granted});
  pop_count_ += static_cast<std::int64_t>(report.pops.size());
  stopped_count_ += static_cast<std::int64_t>(report.stopped.size());
}

void PreviewRun::keep_contacts(const StepReport& report, const CollisionReport& collision) {
  const auto of_pair = [&collision](const auto& contact) {
    return contact.bodies == collision.bodies;
  };
  std::erase_if(contacts_, of_pair);
  std::erase_if(node_contacts_, of_pair);
  const auto first = static_cast<std::size_t>(collision.first_contact);
  const auto count = static_cast<std::size_t>(collision.contact_count);
  for (std::size_t i = first; i < std::min(first + count, report.contacts.size()); ++i) {
    contacts_.push_back({collision.bodies, report.contacts[i].touch, collision.list, step_});
  }
  if (report.contacts.empty()) {
    contacts_.push_back({collision.bodies, collision.contact.touch, collision.list, step_});
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
    node_contacts_.push_back({collision.bodies, touches[i], collision.list, step_});
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
  return start_energy_J_ > 0.0 ? energy_J(scene_.world) / start_energy_J_ : 0.0;
}

Viewer PreviewRun::viewer() const { return scene_.viewer_at_time(position_ / scene_.step_hz); }

std::vector<PosedBody> PreviewRun::bodies() const {
  const double fraction = std::clamp(position_ - static_cast<double>(step_) + 1.0, 0.0, 1.0);
  std::vector<PosedBody> bodies;
  for (std::size_t body = 0; body < before_.size(); ++body) {
    bodies.push_back(
        {between(before_[body], scene_.world.states()[body], fraction), scene_.looks[body]});
  }
  return bodies;
}

double PreviewRun::freshness(const ShownContact& contact) const {
  const double age_s = static_cast<double>(step_ - contact.step) / scene_.step_hz;
  return std::max(0.0, 1.0 - age_s / kContactInView_s);
}

std::optional<int> PreviewRun::level_in_use(std::int32_t body) const {
  const BodyDetail detail = details()[static_cast<std::size_t>(body)];
  return detail.level >= 0 ? std::optional<int>(detail.level) : std::nullopt;
}

std::vector<BodyDetail> PreviewRun::details() const {
  std::vector<BodyDetail> details = latest_.at(step_);
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
  return static_cast<std::size_t>(std::lround(kWorkInView_s * scene_.step_hz));
}

}  // namespace impetus::inline run
