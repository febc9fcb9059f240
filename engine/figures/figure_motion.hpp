// Free motion of a figure: its parts fly as bodies do, and impulses at its hinges, at the beginning
// of the step and at its end, keep them together.
//
//   impulses along the hinges as they stand, such that the parts, each moved freely, arrive with
//     their anchors together: found by Newton's iteration, with what the parts are half way
//   impulses at the end that leave nothing moving across a hinge
//
// (RATTLE: Andersen 1983.) All are opposite impulses at one point: momentum is kept to rounding.
// The energy is brought back to what it was, or below (bring_to_energy()). Where work is refused,
// or the hinges cannot be closed with the energy that there is, the figure goes as one body
// (move_as_one_body()): with its hinges, its momentum and its energy, but not on in its motion.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "engine/dynamics/motion.hpp"
#include "engine/figures/hinge_solver.hpp"
#include "engine/scheduling/work_meter.hpp"

namespace impetus::inline figures {

/// Of the figure's size, by how much anchors may part, and axes (radians): what the iteration ends
/// at.
inline constexpr double kHingeTolerance = 1e-11;

/// A step is made in 1, 2, 4 ... parts, so many at most; each takes a turn of up to kTurnPart
/// radians.
inline constexpr int kMostMotionParts = 64;
inline constexpr double kTurnPart = 0.25;

/// A step of figures.
struct FigureStep {
  double dt_s{0.0};
  Rotation rotation{Rotation::kMidpoint};
  std::span<const Fall> falls;    ///< empty, or one for each body of the world
  bool may_go_as_one_body{true};  ///< not by the rules of recording formats below 6: there hinges
                                  ///< are left open instead
};

/// Moves one figure, in memory that it keeps.
class FigureMotion {
 public:
  /// `models` are those of all bodies of the world.
  FigureMotion(const Figure& figure, const std::vector<BodyModel>& models);

  /// Moves the parts, whose states are among `states`, through a step. Returns whether they arrived
  /// with their hinges closed, by their own motion all the way.
  bool advance(const Figure& figure, const std::vector<BodyModel>& models, const FigureStep& step,
               PhaseWork& work, std::vector<BodyState>& states);

  /// Takes the parts' poses, for the next.
  void look_at(std::span<const BodyState> parts) { solver_.look_at(parts); }

  /// As HingeSolver::add_hinge_impulses(), where the parts are.
  void add_hinge_impulses(std::vector<PartImpulse>& impulses) {
    solver_.add_hinge_impulses(impulses);
  }

  /// Leaves nothing moving across a hinge, whatever did before.
  void stop_across_hinges(std::span<BodyState> parts);

 private:
  /// A figure's own, of all that the world has.
  struct Parts {
    const Figure& figure;
    std::span<const BodyModel> models;
    std::span<const Fall> falls;  ///< none: no gravity
    std::span<BodyState> states;
  };

  [[nodiscard]] int granted_parts(const Parts& parts, const FigureStep& step,
                                  PhaseWork& work) const;
  void find_falls(const Parts& parts, int first, int end, int count);
  bool advance_part(const Parts& parts, double dt_s, const FigureStep& step, PhaseWork& work);
  /// To what it was when the part began, with what gravity gave. Returns whether it is no more.
  bool bring_energy_back(const Parts& parts, double part_s, double step_s) const;
  void go_as_one_body(const Parts& parts, double dt_s, std::span<const Fall> falls);
  /// Returns by how much the hinges miss.
  double arrive_together(const Parts& parts, double dt_s, Rotation rotation, PhaseWork& work);
  /// With the impulses so far; returns the same.
  double arrive(const Parts& parts, double dt_s, Rotation rotation);
  double note_errors(const Parts& parts, double dt_s);
  void look_at_middle(const Parts& parts);

  HingeSolver solver_;
  HingeSolver middle_;  ///< half way of a step: how impulses at its beginning change its end
  double size_m_{0.0};
  std::vector<Fall> falls_;  ///< in this part of the step
  std::vector<BodyState> start_;
  std::vector<BodyState> half_way_;
  std::vector<PartImpulse> impulses_;
  std::vector<PartImpulse> best_;
  std::vector<Vector5> asked_;
  std::vector<Vector5> of_hinges_;
};

}  // namespace impetus::inline figures
