// SPDX-License-Identifier: MIT
#include "experiments/trackers/tracker.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "experiments/settings/input_error.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline trackers {
namespace {

constexpr int kWait_ms = 20;
constexpr std::int64_t kSilence_ns = 250'000'000;
constexpr auto kBetweenTries = std::chrono::milliseconds(200);
/// Some minutes that nobody asked for, as while a page of questions is up; the oldest go first.
constexpr std::size_t kLongestQueue = 100'000;

std::int64_t now_ns() { return SteadyClock().now_ns(); }

GazeSample sample_on(const ScreenGeometry& screen, const Reading& reading) {
  if (reading.loss != GazeLoss::kNone) {
    return {reading.taken_ns, std::nullopt, reading.loss};
  }
  return {reading.taken_ns, ScreenPoint{(reading.x_share - 0.5) * screen.width_m,
                                        (reading.y_share - 0.5) * screen.height_m}};
}

}  // namespace

void refuse_tracker(const std::string& url, const std::string& expected) {
  throw InputError("--gaze " + url + ": expected " + expected);
}

Tracker::Tracker(const TrackerKind& kind, TrackerAddress address)
    : kind_(kind), address_(std::move(address)), link_(kind.connect(address_)) {
  clock_ = link_->clock();
  thread_ = std::thread([this] { read(); });
}

Tracker::~Tracker() {
  stops_ = true;
  thread_.join();
}

void Tracker::read() {
  while (!stops_) {
    std::vector<Reading> readings;
    const bool is_there = receive(readings);
    if (!readings.empty()) {
      keep(readings);
    } else if (!is_there || now_ns() - arrived_ns_ > kSilence_ns) {
      keep_silence();
    }
    if (!is_there && !stops_) {
      std::this_thread::sleep_for(kBetweenTries);
    }
  }
}

bool Tracker::receive(std::vector<Reading>& readings) {
  try {
    if (!link_) {
      link_ = kind_.connect(address_);
    }
    link_->receive(kWait_ms, readings);
    const ClockEstimate clock = link_->clock();
    const std::lock_guard lock(mutex_);
    clock_ = clock;
    return true;
  } catch (const std::runtime_error&) {  // gone, or not back yet
    link_.reset();
    return false;
  }
}

void Tracker::keep(const std::vector<Reading>& readings) {
  arrived_ns_ = now_ns();
  silent_ = false;
  const std::lock_guard lock(mutex_);
  for (Reading reading : readings) {
    // None was taken after it arrived: a clock that was set back would hold up all that follow.
    reading.taken_ns = std::max(std::min(reading.taken_ns, arrived_ns_), last_taken_ns_ + 1);
    last_taken_ns_ = reading.taken_ns;
    queue_.push_back(reading);
  }
  if (queue_.size() > kLongestQueue) {
    queue_.erase(queue_.begin(), queue_.begin() + kLongestQueue / 10);
  }
}

void Tracker::keep_silence() {
  if (silent_) {
    return;
  }
  silent_ = true;
  const std::lock_guard lock(mutex_);
  // Just after the last: what was only delayed on its way may still follow in order.
  last_taken_ns_ += kSilentAfter_ns;
  queue_.push_back({last_taken_ns_, 0.0, 0.0, GazeLoss::kLost});
  ++silences_;
}

std::vector<Reading> Tracker::take_readings() {
  const std::lock_guard lock(mutex_);
  return std::exchange(queue_, {});
}

std::string Tracker::clock_words() const {
  const std::lock_guard lock(mutex_);
  return printed(
      "%s's clock plus %.6f s is this machine's, %s %.3f ms", kind_.name,
      static_cast<double>(clock_.offset_ns) * 1e-9,
      clock_.one_way ? "as the fastest delivery says; 95 % come later by at most" : "known to",
      static_cast<double>(clock_.error_ns) * 1e-6);
}

std::int64_t Tracker::silences() const {
  const std::lock_guard lock(mutex_);
  return silences_;
}

std::vector<GazeSample> TrackedEye::take_samples() {
  std::vector<GazeSample> samples;
  for (const Reading& reading : tracker_->take_readings()) {
    samples.push_back(sample_on(screen_, reading));
  }
  return samples;
}

}  // namespace impetus::inline trackers
