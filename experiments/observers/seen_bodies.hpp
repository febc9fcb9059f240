// What an eye knows of the bodies on show: where they were a visual delay ago, and where they must
// be now if they kept their velocity.
//
//   pictures   |   |   |   |   |          now
//              ├── window ─┤              ·
//                          ├─── delay ────┤
//                  velocity   carried on
//
// Only pictures that had been flipped a delay before the instant asked about are used, so an answer
// does not depend on when it is asked for. A calibration's point is a body that jumps: what stood
// elsewhere has no velocity to tell of. Places are degrees right of and above the screen's
// centre, on the linear scale of metres_per_degree().
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "experiments/record/ports.hpp"

namespace impetus::inline observers {

/// What is looked at: a body of the picture, the middle of two, or the centre when there is none.
struct EyeTarget {
  std::int32_t a{-1};
  std::int32_t b{-1};
};

struct MovingPoint {
  Eigen::Vector2d at_deg{Eigen::Vector2d::Zero()};
  Eigen::Vector2d deg_per_s{Eigen::Vector2d::Zero()};
};

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

}  // namespace impetus::inline observers
