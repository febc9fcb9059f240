// A budget in time: each phase of a step is granted work in slices while there is time for it.
//
//   start |motion|pairs|  entry  |    refinement    |model|  response  |remember| deadline
//          looks at the clock, the nearer the less time is left     kept free ──┘
//
// A phase may use a share of the time that is left when it begins, besides what those that follow
// take in any case. How long things take is learned while steps are made: a pair that is looked at,
// a node that is modelled, a body that is remembered. A phase that cannot be interrupted is granted
// as much as fits by what was learned, and what is done in any case is remembered at its longest;
// the others look at the clock between slices, so what is learned wrongly costs quality and not
// time, but for what two of them begin with at once.
//
// The clock decides only how much is granted. That, logged, replays the step with FixedWork.
// (Dingliana 2002, sec. 3.3.1; eq. 3.9)
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/scheduling/work_meter.hpp"

namespace impetus::inline scheduling {

/// Tells what time it is to whoever meters a step's work; the engine has none of its own.
class WorkClock {
 public:
  virtual ~WorkClock() = default;
  /// Nanoseconds since an arbitrary instant; never goes back.
  [[nodiscard]] virtual std::int64_t now_ns() const = 0;
};

/// What one thing takes, as learned from many: rises at once, and falls slowly.
class LearnedTime {
 public:
  /// Of the units that a phase is granted: what they took lately.
  static constexpr double kFastFall = 0.1;
  /// Of what is done whatever is granted: the longest of some fifty steps.
  static constexpr double kSlowFall = 0.02;
  /// Nothing takes less: a clock that saw less is too coarse to tell.
  static constexpr double kLeast_ns = 0.01;

  /// `fall`: how much of the way down to a shorter time each one goes.
  explicit LearnedTime(double first_guess_ns, double fall = kSlowFall)
      : ns_(first_guess_ns), fall_(fall) {}

  /// `units` things took `elapsed_ns`. A time far above what is known may be an interruption of the
  /// program, so a single one at most doubles it.
  void learn(double elapsed_ns, double units);

  /// Nothing was done, because it would have taken too long by what is known: so that it is tried
  /// again.
  void doubt() { ns_ = std::max(ns_ - fall_ * ns_, kLeast_ns); }

  [[nodiscard]] double ns() const { return ns_; }

 private:
  double ns_;
  double fall_;
};

/// Grants work until a step's time is up, by a clock.
class DeadlineWork final : public WorkMeter {
 public:
  /// `clock` must outlive it. Grants nothing before the first start_step().
  DeadlineWork(const WorkClock& clock, std::int64_t ns_per_step);

  /// Starts the next step's time; call it just before World::step().
  void start_step();

  std::int64_t request(WorkPhase phase, std::int64_t total, std::int64_t reserved) override;
  void begin(StepPart part, std::int64_t units) override;
  void expect_at_walls(std::int64_t bodies) override;
  void finish() override;

 private:
  /// How far a phase has come in this step.
  struct Granting {
    std::int64_t granted{0};
    std::int64_t asked{0};      ///< at the last look at the clock
    std::int64_t slice{0};      ///< units that were granted then, beyond
    std::int64_t looked_ns{0};  ///< when that was
    std::int64_t at_once{0};    ///< units that it began with
    std::int64_t until_ns{0};   ///< when its time is up
    bool begun{false};
    bool refused{false};
  };

  void learn_before(StepPart part, std::int64_t now_ns);
  void learn_modelling(double elapsed_ns, double in_any_case, double others);
  void begin_phase(WorkPhase phase, std::int64_t now_ns, Granting& granting);
  [[nodiscard]] std::int64_t until_ns(WorkPhase phase, std::int64_t now_ns) const;
  void grant_what_fits(WorkPhase phase, std::int64_t total, std::int64_t now_ns,
                       Granting& granting);
  [[nodiscard]] std::int64_t kept_for_later_ns(WorkPhase phase, std::int64_t total,
                                               std::int64_t reserved) const;
  void grant_slice(WorkPhase phase, std::int64_t total, std::int64_t left_ns, Granting& granting);
  void learn_since_look(WorkPhase phase, std::int64_t total, std::int64_t now_ns,
                        Granting& granting);

  LearnedTime& time_at_once(WorkPhase phase) {
    return times_at_once_[static_cast<std::size_t>(phase)];
  }
  LearnedTime& unit_time(WorkPhase phase) { return unit_times_[static_cast<std::size_t>(phase)]; }
  LearnedTime& part_time(StepPart part) { return part_times_[static_cast<std::size_t>(part)]; }
  [[nodiscard]] double part_ns(StepPart part) const {
    return part_times_[static_cast<std::size_t>(part)].ns();
  }
  /// What it takes to model the contacts with walls, whatever is granted, and to hand them to the
  /// response.
  [[nodiscard]] double walls_ns() const {
    return (part_ns(StepPart::kModel) + part_ns(StepPart::kRespond)) * bodies_at_walls_;
  }

  const WorkClock* clock_;
  std::int64_t ns_per_step_;

  // Of this step.
  std::array<Granting, kWorkPhases> phases_{};
  bool started_{false};
  std::int64_t end_ns_{0};        ///< of what can be interrupted
  std::int64_t pairs_{0};         ///< that are to be refined
  std::int64_t reserved_{0};      ///< units of refinement, for the parts that follow it
  std::int64_t later_end_ns_{0};  ///< what is kept free of refinement begins then, at the earliest
  std::int64_t later_began_ns_{0};  ///< modelling
  StepPart part_{StepPart::kMove};
  std::int64_t part_began_ns_{0};
  std::int64_t part_units_{0};
  double bodies_{0.0};
  double bodies_at_walls_{0.0};  ///< of the step before, until they are known

  // Learned.
  std::array<LearnedTime, kWorkPhases> unit_times_;
  std::array<LearnedTime, kWorkPhases> times_at_once_;  ///< of units that a phase begins with
  std::array<LearnedTime, kStepParts> part_times_;
  std::int64_t most_pairs_{0};     ///< granted in a step so far
  std::int64_t most_modelled_{0};  ///< the same of units of modelling
  LearnedTime reserved_unit_time_{4.0};
  LearnedTime left_motion_time_{800.0};  ///< of a body, once the motion of figures was refused
  LearnedTime left_entry_time_{300.0};   ///< of a pair, once the search for entries was refused
  LearnedTime left_tests_time_{50.0};    ///< of a pair, once refinement was refused
  LearnedTime sorting_time_{20.0};       ///< of what the sweep found, for each of its units
  LearnedTime choosing_time_{50.0};      ///< of a pair found, where not all are looked at
  LearnedTime ordering_time_{500.0};     ///< of a pair, between its root and the first test
};

}  // namespace impetus::inline scheduling
