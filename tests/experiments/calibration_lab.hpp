// A participant whose gaze goes to the point that is shown, as a tracker with faults reports it.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "tests/experiments/fakes.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus {

/// Looks at the target, or else at the centre; `fault` makes of that what is sampled. 100 per
/// second.
class FollowingGaze final : public Gaze {
 public:
  explicit FollowingGaze(const VirtualClock& clock) : clock_(&clock) {}

  [[nodiscard]] std::string source() const override { return "scripted"; }
  [[nodiscard]] bool is_pointer() const override { return pointer; }
  std::vector<GazeSample> take_samples() override {
    sample_until(clock_->now_ns());
    return std::exchange(samples_, {});
  }
  void shown(const Picture& picture, const Flip& flip) override {
    sample_until(flip.flipped_ns);
    looked_at_ = picture.target.value_or(ScreenPoint{});
  }

  std::function<Fixation(const ScreenPoint& looked_at)> fault;
  bool pointer{false};

 private:
  void sample_until(std::int64_t now_ns) {
    constexpr std::int64_t kEvery_ns = 10'000'000;
    for (; next_ns_ < now_ns; next_ns_ += kEvery_ns) {
      const Fixation at = fault ? fault(looked_at_) : Fixation(looked_at_);
      samples_.push_back({next_ns_, at, at ? GazeLoss::kNone : GazeLoss::kLost});
    }
  }

  const VirtualClock* clock_;
  std::int64_t next_ns_{0};
  ScreenPoint looked_at_;
  std::vector<GazeSample> samples_;
};

/// The shipped gaze-contingent study, one repetition with five bodies, stimuli of a fifth of a
/// second, without practice or demonstrations.
inline Protocol short_gaze_study(
    const std::function<void(json& protocol, json& scene)>& change = {}) {
  json protocol = json::parse(shipped("protocols/gaze-contingent.json"));
  json scene = json::parse(shipped("stimuli/l-blocks-in-a-cube.json"));
  scene["duration_s"] = 0.2;
  protocol["design"]["repetitions"] = 1;
  protocol["design"]["factors"][1]["levels"] = {5};
  protocol["design"].erase("practice");
  protocol["design"].erase("practice_until");
  protocol["session"].erase("demonstrations");
  if (change) {
    change(protocol, scene);
  }
  return make_protocol(parse_json("gaze.json", protocol.dump()),
                       parse_json("cube.json", scene.dump()));
}

/// Sessions of that study before that participant.
struct CalibrationLab : TestLab {
  explicit CalibrationLab(Protocol study = short_gaze_study())
      : TestLab(60.0, std::move(study)), eye(clock) {
    gaze = &eye;
  }

  SessionResult run() { return run_session(protocol.script, plan, {}, ports()); }

  [[nodiscard]] std::int64_t noted(const std::string& kind) const {
    return std::count_if(recorder.notes.begin(), recorder.notes.end(),
                         [&](const NoteRecord& note) { return note.kind == kind; });
  }
  [[nodiscard]] std::int64_t titled(const std::string& title) const {
    return std::count(input.titles.begin(), input.titles.end(), title);
  }
  [[nodiscard]] std::vector<CalibrationRecord> runs(CalibrationKind kind) const {
    std::vector<CalibrationRecord> found;
    for (const CalibrationRecord& record : recorder.calibrations) {
      if (record.kind == kind) {
        found.push_back(record);
      }
    }
    return found;
  }

  FollowingGaze eye;
  Plan plan = make_plan(protocol.design, {protocol.name, "P01", 1});
};

}  // namespace impetus
