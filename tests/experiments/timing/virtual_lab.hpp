// A lab of virtual time for timing reports: a display, input, gaze, markers and sounds that are as
// late as a test says.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "experiments/timing/timing_run.hpp"
#include "tests/experiments/fakes.hpp"

namespace impetus::timing_report_test {

/// A causality trial, however many bodies are asked for: the tests are not of the scenes.
class AnyScene final : public Scenes {
 public:
  [[nodiscard]] StagedScene stage(const PlannedTrial& /*trial*/,
                                  const ScreenGeometry& screen) const override {
    return scenes_.stage(cells(protocol_.design).front(), screen);
  }
  [[nodiscard]] StagedScene stage_demonstration(const std::string& id,
                                                const ScreenGeometry& screen) const override {
    return scenes_.stage_demonstration(id, screen);
  }

 private:
  Protocol protocol_{causality()};
  ProtocolScenes scenes_{protocol_, 0.0};
};

/// Takes each marker a fifth of a millisecond after its flip, but for one that it loses.
class PromptMarkers final : public Markers {
 public:
  void mark(MarkedEvent event, std::int64_t event_ns, std::int64_t interval) override {
    const bool is_lost = ++count == lost_at;
    records_.push_back(
        {event, 7, event_ns, is_lost ? std::nullopt : std::optional(event_ns + 200'000), interval});
  }
  std::vector<MarkerRecord> take() override { return std::exchange(records_, {}); }

  std::int64_t count{0};
  std::int64_t lost_at{-1};

 private:
  std::vector<MarkerRecord> records_;
};

/// Begins each sound so long after the instant asked for, or, where that is past, after now; but
/// for every so-many-th, which nobody hears.
class LateSounds final : public Sounds {
 public:
  explicit LateSounds(const Clock& clock) : clock_(clock) {}

  void prepare(const SoundTask& /*task*/) override {}
  std::int64_t play(const SoundTask& /*task*/, std::int64_t at_ns, double /*loudness*/) override {
    begins_ns_.push_back(std::max(at_ns, clock_.now_ns() + 8'000'000) + late_ns);
    return static_cast<std::int64_t>(begins_ns_.size());
  }
  std::optional<std::int64_t> realised_ns(std::int64_t number) override {
    const bool is_lost = lost_every > 0 && number % lost_every == 0;
    return is_lost ? std::nullopt : std::optional(begins_ns_.at(number - 1));
  }

  std::int64_t late_ns{0};
  std::int64_t lost_every{0};

 private:
  const Clock& clock_;
  std::vector<std::int64_t> begins_ns_;
};

/// Every input arrives after 2 ms; the patch shows what the last picture said, unless told
/// otherwise.
class VirtualLab final : public TimingLab {
 public:
  VirtualLab() : display_(clock_, 60.0), input_(clock_), gaze_(clock_, 5'000'000) {
    gaze_.at = [](std::int64_t /*taken_ns*/) { return Fixation(ScreenPoint{}); };
    input_.on_frame = [this](std::int64_t frame) {
      return frame == stopped_at_frame ? Interruption::kPauseRequested : Interruption::kNone;
    };
  }

  Display& display() override { return display_; }
  Input& input() override { return input_; }
  Gaze& gaze() override { return gaze_; }
  [[nodiscard]] std::string gaze_clock() const override { return tracker_clock; }
  Markers* markers() override { return marker_line.empty() ? nullptr : &prompt; }
  [[nodiscard]] std::string marker_address() const override { return marker_line; }
  Sounds* sounds() override { return device.empty() ? nullptr : &late; }
  [[nodiscard]] std::string sound_device() const override { return device; }
  [[nodiscard]] const Clock& clock() const override { return clock_; }
  SyncTest sync_test() override { return {1, 120, 1e9 / 60.0, 0.0, true, "all is well"}; }
  InputTrace try_input(const std::function<bool()>& show) override {
    InputTrace trace;
    while (show()) {
      const std::int64_t sent_ns = clock_.now_ns();
      trace.sent.push_back({InputDevice::kKey, InputRoute::kQueue, sent_ns});
      trace.arrived.push_back({InputDevice::kKey, InputRoute::kQueue, sent_ns + 2'000'000, 0});
    }
    return trace;
  }
  void show_patch(ScreenCorner corner) override { corner_ = corner; }
  [[nodiscard]] bool can_read_patch() override { return true; }
  std::optional<std::int64_t> read_patch() override {
    const std::size_t shown = display_.pictures.size() - 1;
    ++patches_read;
    const std::size_t held = patches_read == repeated_at_patch ? shown - 1 : shown;
    return display_.pictures[held].patch_code;
  }

  std::string tracker_clock;
  std::string marker_line;
  std::string device;
  PromptMarkers prompt;
  std::int64_t stopped_at_frame{-1};
  std::int64_t repeated_at_patch{-1};  ///< this reading finds the picture before
  std::int64_t patches_read{0};

 private:
  VirtualClock clock_;

 public:
  LateSounds late{clock_};

 private:
  WatchedDisplay display_;
  ScriptedInput input_;
  ScriptedGaze gaze_;
  ScreenCorner corner_{ScreenCorner::kTopLeft};
};

inline std::optional<TimingReport> report_of(VirtualLab& lab) {
  return run_timing(lab, AnyScene(), {0.5, ScreenCorner::kTopRight}, [](const auto&) {});
}

}  // namespace impetus::timing_report_test
