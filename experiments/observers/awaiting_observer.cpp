// A simulated participant who clicks when a body touches another, which he cannot see: when their
// bounds touch at a level of their trees, as he imagines them.
//
//   click = t + g / v + b + N(0, s²)     t: when the first stops, g: the gap between the bounds
//   then,
//                                        below 0 where they touched sooner, v: its speed
//
// (After Li, Wang, Boger, Smith, Gershman and Ullman 2023)
// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>
#include <utility>

#include "experiments/observers/observer_kinds.hpp"
#include "experiments/observers/shown_truths.hpp"
#include "experiments/run/collision_truth.hpp"

namespace impetus::inline observers {

const ObserverKind& awaiting_observer();

namespace {

/// What he is made of.
struct AwaitingParameters : RatingParameters {
  double level{-1.0};
  double bias_ms{0.0};
  double bias_sd_ms{0.0};
  double timing_sd_ms{0.0};
};

std::vector<ParameterEntry> awaiting_entries(AwaitingParameters& own) {
  return {{"level", -1.0, 30.0, &own.level,
           "The level of the bodies' trees whose bounds are imagined; -1, when left out: the "
           "outlines.",
           true},
          {"bias_ms", -kAny, kAny, &own.bias_ms, "How late clicks are on average."},
          {"bias_sd_ms", 0.0, kAny, &own.bias_sd_ms, "Spread of that between participants."},
          {"timing_sd_ms", 0.0, kAny, &own.timing_sd_ms, "Standard deviation from click to click."},
          {"lapse_rate", 0.0, 1.0, &own.lapse_rate, "The share of animations without a click."}};
}

/// Clicks once in each stimulus.
class AwaitingObserver final : public RatingObserver {
 public:
  AwaitingObserver(const AwaitingParameters& parameters, const Birth& birth)
      : RatingObserver(parameters, birth, "awaiting"), own_(parameters) {
    bias_ms_ = own_.bias_ms + own_.bias_sd_ms * normal();
  }

  std::vector<ClickRecord> take_clicks() override { return std::exchange(clicks_, {}); }

 private:
  [[nodiscard]] double seen(const AttemptRecord& shown, const StagedScene& scene) override {
    clicks_.clear();
    const bool lapses = uniform() < own_.lapse_rate;
    const double noise_ms = own_.timing_sd_ms * normal();
    if (!lapses && scene.launch && !shown.frames.empty()) {
      const auto level =
          own_.level < 0.0 ? std::nullopt : std::optional(static_cast<int>(own_.level));
      const double gap_deg = launch_gap_arcmin(scene, level) / kArcminPerDegree;
      const double at_s =
          scene.contact_s + gap_deg / scene.launch->speed_deg_s + (bias_ms_ + noise_ms) / 1e3;
      const std::int64_t at_ns = shown.onset_ns + std::llround(at_s * 1e9);
      if (at_ns > shown.onset_ns && at_ns <= shown.frames.back().flip.flipped_ns) {
        clicks_.push_back({"simulated", at_ns, 0});
      }
    }
    return 0.0;
  }

  AwaitingParameters own_;
  double bias_ms_{0.0};
  std::vector<ClickRecord> clicks_;
};

}  // namespace

const ObserverKind& awaiting_observer() {
  static const ObserverKind kind{
      .name = "awaiting",
      .words = "Clicks when two bodies touch out of sight, as it imagines their shapes.",
      .attention = {"the shapes, and when they touch", {"shape", "lead", "gap"}},
      .clicks = true,
      .parameters = list_of<AwaitingParameters, awaiting_entries>(),
      .read = read_with<AwaitingParameters, awaiting_entries>,
      .make = make_own<AwaitingParameters, AwaitingObserver>,
      .has_own_scale = true};
  return kind;
}

}  // namespace impetus::inline observers
