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
#include <deque>
#include <string>
#include <vector>

#include "engine/numerics/random_stream.hpp"
#include "experiments/observers/draws.hpp"
#include "experiments/record/gaze.hpp"
#include "experiments/record/ports.hpp"

namespace impetus::inline observers {

/// How an eye moves and how well it is tracked.
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

  bool operator==(const EyeParameters& other) const = default;
};

/// An eye and a tracker as the file of the gaze-contingent participant has them, with its sources.
EyeParameters usual_eye();

/// Stretches of time in which a signal is lost: they begin at random and last about as long as each
/// other. The share of time lost is mean length / (mean length + 1 / rate).
class LossProcess {
 public:
  /// Begins anew at `per_s` while nothing is lost; lasts uniformly between half and one and a half
  /// of `mean_ms`. Rate 0: never.
  LossProcess(RandomStream stream, double per_s, double mean_ms, std::int64_t start_ns);

  /// Whether the signal is lost at the instant, which must not go back.
  bool lost_at(std::int64_t instant_ns);

 private:
  void draw_next();

  RandomStream stream_;
  double per_s_;
  double mean_ms_;
  double from_ns_{0.0};
  double to_ns_;
};

/// What is looked at: a body of the picture, the middle of two, or the centre when there is none.
struct EyeTarget {
  std::int32_t a{-1};
  std::int32_t b{-1};
};

/// Where something is on the screen, and how it moves.
struct MovingPoint {
  Eigen::Vector2d at_deg{Eigen::Vector2d::Zero()};
  Eigen::Vector2d deg_per_s{Eigen::Vector2d::Zero()};
};

/// What an eye knows of the bodies on show: where they were a visual delay ago, and where they must
/// be now if they kept their velocity.
///
///   pictures   |   |   |   |   |          now
///              ├── window ─┤              ·
///                          ├─── delay ────┤
///                  velocity   carried on
///
/// Only pictures that had been flipped a delay before the instant asked about are used, so an
/// answer does not depend on when it is asked for. A calibration's point is a body that jumps: what
/// stood elsewhere has no velocity to tell of. Places are degrees right of and above the screen's
/// centre, on the linear scale of metres_per_degree().
class SeenBodies {
 public:
  explicit SeenBodies(std::int64_t delay_ns) : delay_ns_(delay_ns) {}

  /// Takes a picture and when its flip was; flips come in order of time.
  void add(const Picture& picture, std::int64_t flipped_ns);

  /// Forgets what no instant from `instant_ns` on needs.
  void forget_before(std::int64_t instant_ns);

  /// How many bodies are known of at the instant; none soon after pictures have stopped.
  [[nodiscard]] std::int32_t count(std::int64_t instant_ns) const;

  /// The target as predicted for the instant; the resting centre when it is not known of.
  [[nodiscard]] MovingPoint predicted(const EyeTarget& target, std::int64_t instant_ns) const;

  /// The two bodies whose bounding balls will touch first if they keep their velocities, or, when
  /// none will, those nearest to each other. Needs two bodies.
  [[nodiscard]] EyeTarget nearest_to_colliding(std::int64_t instant_ns) const;

  /// The screen that was on show at the instant (no delay); before the first picture, one of no
  /// size at 57 cm.
  [[nodiscard]] ScreenGeometry screen_at(std::int64_t instant_ns) const;

 private:
  /// A picture as the eye keeps it.
  struct Seen {
    std::int64_t flipped_ns;
    Viewer viewer;
    std::vector<Vector3> places;  ///< metres, world
    std::vector<double> radii_m;
    Fixation target{};  ///< of a calibration: the only place
  };
  /// The newest picture of bodies that an instant may use, and one a window earlier; none: null.
  struct Two {
    const Seen* newest{nullptr};
    const Seen* earlier{nullptr};
    double apart_s{0.0};  ///< 0: nothing earlier, so no velocity
  };

  [[nodiscard]] Two known_at(std::int64_t instant_ns) const;

  std::int64_t delay_ns_;
  std::deque<Seen> pictures_;
};

/// A gaze that is followed as a person's is, and lost as a person's is.
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
  /// What the eye does now: it rests, follows its target, or jumps to the next.
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
