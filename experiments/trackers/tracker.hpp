// Eye trackers that send over a network: what one must do, and what all have in common.
//
//   tracker ── its protocol ──> TrackerLink ──> Tracker's thread ──> queue ──> TrackedEye ──>
//   session
//                               one file each   silence, reconnecting          metres
//
// To add a tracker, write one source with a TrackerLink that makes readings of what comes, and a
// line in tracker_kinds.cpp. A reading is stamped by SteadyClock, converted from the tracker's
// clock by one of clock_offset.hpp. What has no place says why, and is never left out: losses are
// counted.
//
// Stamps never go back: a reading older than the one before it, as where two eyes are matched late
// or the offset is estimated anew, is stamped one nanosecond after that; and none is later than its
// arrival.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "experiments/record/ports.hpp"
#include "experiments/trackers/clock_offset.hpp"

namespace impetus::inline trackers {

/// Where a participant looked, in shares of the screen's width and height from its lower left.
struct Reading {
  std::int64_t taken_ns{0};  ///< of SteadyClock
  double x_share{0.0};
  double y_share{0.0};
  GazeLoss loss{GazeLoss::kNone};
};

/// A tracker's URL, such as pupil://localhost:50020?surface=screen, in its parts.
struct TrackerAddress {
  std::string url;
  std::string host;
  int port{0};
  std::map<std::string, std::string> options;  ///< after "?"
};

/// Throws the InputError that says what was expected of this URL.
[[noreturn]] void refuse_tracker(const std::string& url, const std::string& expected);

/// The connection is lost; whoever reads says so to nobody, and connects again.
class TrackerGone : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A connection to a tracker, used by one thread at a time.
class TrackerLink {
 public:
  virtual ~TrackerLink() = default;

  /// Waits for readings, `wait_ms` at most, and appends what came. Throws TrackerGone.
  virtual void receive(int wait_ms, std::vector<Reading>& readings) = 0;

  /// How the tracker's clock stands to SteadyClock.
  [[nodiscard]] virtual ClockEstimate clock() const = 0;
};

/// One kind of tracker; see tracker_kinds.cpp.
struct TrackerKind {
  const char* scheme;  ///< of its URL
  const char* name;    ///< beside every sample
  int port;            ///< unless the URL names one
  std::vector<std::string> options;
  /// Connects, and knows the clock when it returns. Throws InputError, in one sentence.
  std::unique_ptr<TrackerLink> (*connect)(const TrackerAddress& address);
};

/// A tracker that is read from its making until it is destroyed, and connected again when it is
/// gone.
class Tracker {
 public:
  /// Throws InputError where there is no such tracker, or nobody answers there.
  Tracker(const TrackerKind& kind, TrackerAddress address);
  ~Tracker();
  Tracker(const Tracker&) = delete;
  Tracker& operator=(const Tracker&) = delete;

  [[nodiscard]] std::string name() const { return kind_.name; }

  /// What came since the last call, in order of time; never waits. When a tracker falls silent, one
  /// lost reading follows its last.
  std::vector<Reading> take_readings();

  /// One sentence on how its clock stands to this machine's, as far as is known now.
  [[nodiscard]] std::string clock_words() const;

  /// How often it fell silent.
  [[nodiscard]] std::int64_t silences() const;

 private:
  void read();
  /// Connects if need be, and appends what comes in a moment; whether the tracker is there.
  bool receive(std::vector<Reading>& readings);
  void keep(const std::vector<Reading>& readings);
  void keep_silence();

  const TrackerKind& kind_;
  TrackerAddress address_;
  std::unique_ptr<TrackerLink> link_;  ///< the thread's, once that runs
  std::int64_t arrived_ns_{0};         ///< the last readings; the thread's
  bool silent_{true};                  ///< since then; the thread's
  mutable std::mutex mutex_;           ///< of what follows
  std::vector<Reading> queue_;
  std::int64_t last_taken_ns_{0};
  ClockEstimate clock_;
  std::int64_t silences_{0};
  std::atomic<bool> stops_{false};
  std::thread thread_;
};

/// The tracker's readings as gaze on a screen; several sessions may share a tracker, one by one.
class TrackedEye final : public Gaze {
 public:
  TrackedEye(std::shared_ptr<Tracker> tracker, const ScreenGeometry& screen)
      : tracker_(std::move(tracker)), screen_(screen) {}

  [[nodiscard]] std::string source() const override { return tracker_->name(); }
  std::vector<GazeSample> take_samples() override;

 private:
  std::shared_ptr<Tracker> tracker_;
  ScreenGeometry screen_;
};

}  // namespace impetus::inline trackers
