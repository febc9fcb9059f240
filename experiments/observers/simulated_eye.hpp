// A simulated eye: looks from body to body, follows what moves, and is tracked imperfectly.
//
//   fixation ──┐                       ┌── 200–300 ms in one place
//              ├── saccade ── look ────┤
//   pursuit ───┘      ^          │     └── or following a moving body, with a gain below 1
//                     └──────────┘         and small catch-up saccades
//
//   saccade    min-jerk path over base + slope · amplitude (main sequence: Carpenter 1988)
//   target     a body drawn at random, or the pair that will touch first; the point of a
//              calibration; else the screen's centre
//   tracker    + constant offset + fixational noise, − blinks, drop-outs and what is off screen
//
// The eye moves by what was shown a visual delay ago. Samples stand on a fixed grid of times and
// depend on nothing but the seed and the pictures, however often they are taken. Shown pictures
// must be told before `visual_delay_ms` has gone by.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "engine/numerics/random_stream.hpp"
#include "experiments/observers/loss_process.hpp"
#include "experiments/observers/seen_bodies.hpp"
#include "experiments/record/gaze.hpp"
#include "experiments/record/ports.hpp"

namespace impetus::inline observers {

struct EyeParameters {
  double sampling_hz{250.0};  ///< 60 to 1000
  double latency_ms{0.0};     ///< from the sample to when it can be taken
  double visual_delay_ms{100.0};

  double fixation_min_ms{200.0};
  double fixation_max_ms{300.0};
  double saccade_base_ms{21.0};
  double saccade_ms_per_deg{2.2};
  double pair_share{0.0};     ///< of looks: at the middle of the pair that will touch first
  double pursuit_share{0.0};  ///< of looks at what moves: those that follow it
  double pursuit_min_ms{400.0};
  double pursuit_max_ms{1000.0};
  double pursuit_gain{1.0};       ///< eye velocity over the target's
  double pursuit_time_ms{100.0};  ///< in which all but 1/e of a distance to the target is made good
  double catch_up_deg{2.0};       ///< a distance beyond which a saccade makes it good

  double fixational_sd_deg{0.0};     ///< per axis
  double fixational_time_ms{100.0};  ///< correlation time
  double offset_sd_deg{0.0};         ///< per axis, over participants
  double blink_per_s{0.0};           ///< rate while the eye is open
  double blink_ms{150.0};            ///< mean
  double dropout_per_s{0.0};
  double dropout_ms{50.0};  ///< mean
};

class SimulatedEye final : public Gaze {
 public:
  /// The eye opens now, looking at the screen's centre. `clock` is the one that flips are stamped
  /// with and must outlive this.
  SimulatedEye(const EyeParameters& parameters, std::uint64_t seed, const std::string& pseudonym,
               const Clock& clock);

  [[nodiscard]] std::string source() const override { return "simulated eye"; }
  std::vector<GazeSample> take_samples() override;
  void shown(const Picture& picture, const Flip& flip) override {
    seen_.add(picture, flip.flipped_ns);
  }

 private:
  enum class Movement { kFixation, kPursuit, kSaccade };

  GazeSample sample_at(std::int64_t instant_ns);
  void advance_to(std::int64_t instant_ns);
  void move_to(std::int64_t instant_ns);
  void pursue_to(std::int64_t instant_ns);
  void choose_target();
  void start_saccade(double look_ms);
  void start_look();
  [[nodiscard]] std::int64_t due_ns(std::int64_t sample) const;

  EyeParameters parameters_;
  const Clock* clock_;
  SeenBodies seen_;
  RandomStream looks_;  ///< where to, how and for how long
  RandomStream noise_;
  LossProcess blinks_;
  LossProcess dropouts_;

  std::int64_t start_ns_;
  std::int64_t next_sample_{1};
  Eigen::Vector2d offset_deg_;
  Eigen::Vector2d fixational_deg_;

  Movement movement_{Movement::kFixation};
  EyeTarget target_;
  bool follows_{false};    ///< the look that the saccade leads to
  double look_ms_{0.0};    ///< how long that look is to last
  std::int64_t since_ns_;  ///< when the movement began
  std::int64_t until_ns_;  ///< when it ends
  std::int64_t now_ns_;    ///< of gaze_deg_
  Eigen::Vector2d gaze_deg_{Eigen::Vector2d::Zero()};
  Eigen::Vector2d from_deg_{Eigen::Vector2d::Zero()};  ///< of the saccade
  Eigen::Vector2d to_deg_{Eigen::Vector2d::Zero()};
};

}  // namespace impetus::inline observers
