// A look at a recorded scene from elsewhere than the participant's eye.
//
//   drag    the eye goes round the world's origin, as far from it as the participant's
//   wheel   the glass shows less of the scene, larger, or more of it, smaller
//
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/scheduling/viewer.hpp"

namespace impetus::inline viewing {

/// How far round and how close the look is.
class OrbitCamera {
 public:
  /// To the right and upwards; the eye never goes over a pole.
  void turn(double right_deg, double up_deg);

  /// Closer by a notch of the wheel (1), or further (−1), up to eight times or to a quarter.
  void zoom(double notches);

  /// Back to the participant's own view.
  void reset() { *this = OrbitCamera(); }
  [[nodiscard]] bool is_participants() const;

  [[nodiscard]] double right_deg() const { return right_deg_; }
  [[nodiscard]] double up_deg() const { return up_deg_; }
  [[nodiscard]] double magnification() const { return magnification_; }

  /// What is seen, where the participant saw `own`; `own` itself, in every bit, after reset().
  [[nodiscard]] Viewer seen_from(const Viewer& own) const;

 private:
  double right_deg_{0.0};
  double up_deg_{0.0};
  double magnification_{1.0};
};

}  // namespace impetus::inline viewing
