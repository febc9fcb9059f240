// How much work a step may do: every phase that can be interrupted asks, in units that do not
// depend on the machine.
//
//   motion ─> sweep ─> pairs ─> entry ─> roots ─> tests, refinement ─> model ─> response ─> visible
//     each:  |<---- total that is asked for ---->|      granted up to here, or refused
//
// The engine reads no clock. A meter grants work when asked; what each phase was granted, logged,
// is all that a replay needs. For what is asked depends on the state and on the answers so far
// alone, and an answer matters only by whether it reaches what was asked. Let G be the largest
// answer to a phase. A request that was granted asked for at most its answer, so at most G. A
// request that was refused asked for more than its answer, which by the contract below was the
// largest there ever was: more than G. So "at most G" decides every request of the phase as the
// live meter did, in turn, whatever made it refuse; and that is what FixedWork answers.
// (Dingliana 2002, sec. 3.3.1; eq. 3.9, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace impetus::inline scheduling {

inline constexpr std::int64_t kUnlimitedTests = INT64_MAX;

/// What asks for work in a step, in its order.
enum class WorkPhase : std::uint8_t {
  kMotion,      ///< of figures: bodies moved anew, beyond the least that brings them on
  kSweep,       ///< blocks of bodies compared with one, and pairs found
  kPairs,       ///< pairs of bodies that are kept as candidates
  kEntry,       ///< node pairs tested, and pairs looked at, along the ways of fast bodies
  kRoots,       ///< pairs whose roots are tested; those with walls always are
  kTests,       ///< of refinement, beyond the roots and least levels; in units of WorkCosts
  kRefinement,  ///< the same from the step's floor on, with what is reserved for what follows
  kModel,       ///< overlapping node pairs, and kPairUnits for each pair, made contacts
  kResponse,    ///< contacts looked at, in passes over all
  kVisible,     ///< contacts looked at, the most visible first, once kResponse was refused
};

inline constexpr std::size_t kWorkPhases = 10;

/// As they are told of, in the order of the phases.
inline constexpr std::array<std::string_view, kWorkPhases> kWorkPhaseNames{
    "motion", "sweep",      "pairs", "entry",    "roots",
    "tests",  "refinement", "model", "response", "visible"};

/// Where a phase stands that asks for nothing: the beginning of one, with what it does in any case.
enum class StepPart : std::uint8_t { kMove, kPair, kEnter, kRefine, kModel, kRespond, kRemember };

inline constexpr std::size_t kStepParts = 7;

/// The most that each phase of a step was granted, of those that were refused something; the others
/// have kUnlimitedTests. Logged, it replays the step.
struct WorkGrants {
  std::array<std::int64_t, kWorkPhases> units = unlimited();

  [[nodiscard]] std::int64_t of(WorkPhase phase) const {
    return units[static_cast<std::size_t>(phase)];
  }
  std::int64_t& of(WorkPhase phase) { return units[static_cast<std::size_t>(phase)]; }

  /// Whether a phase other than refinement was refused something.
  [[nodiscard]] bool cut_beyond_refinement() const {
    WorkGrants other = *this;
    other.of(WorkPhase::kRefinement) = kUnlimitedTests;
    return other.units != unlimited();
  }

  friend bool operator==(const WorkGrants&, const WorkGrants&) = default;

 private:
  static constexpr std::array<std::int64_t, kWorkPhases> unlimited() {
    std::array<std::int64_t, kWorkPhases> all{};
    all.fill(kUnlimitedTests);
    return all;
  }
};

/// Grants a step its work, in as many requests as the step likes.
class WorkMeter {
 public:
  virtual ~WorkMeter() = default;

  /// Asks that the phase's work may come to `total` units. `reserved` units are for the parts that
  /// follow refinement: in kRefinement's total, besides that of kTests, and 0 for the others.
  /// Returns the total granted so far: the work may be done only if the answer is at least `total`.
  /// kRefinement's totals may fall, when a reserve is released; the others' do not. Once a request
  /// is refused the phase's answer never rises again within the step, and it is no smaller than any
  /// before: that makes the totals sufficient for a replay.
  virtual std::int64_t request(WorkPhase phase, std::int64_t total, std::int64_t reserved) = 0;

  /// A part of the step begins, which does `units` things whatever is granted: bodies, pairs or
  /// contacts. For meters that learn how long things take.
  virtual void begin(StepPart /*part*/, std::int64_t /*units*/) {}

  /// So many bodies touch walls, by their roots, and will be modelled there whatever is granted.
  /// Told before roots are asked for.
  virtual void expect_at_walls(std::int64_t /*bodies*/) {}

  /// The step is done.
  virtual void finish() {}
};

/// Grants each phase of each step so many units. A budget in units is one of refinement alone, with
/// what is reserved for what follows it; the other phases get all they ask for. Also replays a
/// recording: what was granted then, granted now.
class FixedWork final : public WorkMeter {
 public:
  explicit FixedWork(std::int64_t units_of_refinement) {
    grants_.of(WorkPhase::kRefinement) = units_of_refinement;
  }
  explicit FixedWork(const WorkGrants& grants) : grants_(grants) {}

  std::int64_t request(WorkPhase phase, std::int64_t total, std::int64_t /*reserved*/) override {
    return phase == WorkPhase::kRefinement ? std::min(total, grants_.of(phase)) : grants_.of(phase);
  }

 private:
  WorkGrants grants_;
};

/// The work of one phase in one step: asks for it, counts it, and notes a refusal.
class PhaseWork {
 public:
  PhaseWork(WorkMeter& meter, WorkPhase phase, WorkGrants& grants)
      : meter_(&meter), grants_(&grants), phase_(phase) {}

  /// Whether `units` more may be done; if so they count as done.
  [[nodiscard]] bool spend(std::int64_t units, std::int64_t reserved = 0) {
    if (units > granted_ - done_ && !ask(units, reserved)) {
      return false;
    }
    done_ += units;
    return true;
  }

  [[nodiscard]] bool refused() const { return refused_; }
  [[nodiscard]] std::int64_t granted() const { return granted_; }
  [[nodiscard]] std::int64_t done() const { return done_; }

 private:
  bool ask(std::int64_t units, std::int64_t reserved) {
    if (!refused_) {
      granted_ = std::max(granted_, meter_->request(phase_, done_ + units, reserved));
      refused_ = units > granted_ - done_;
      if (refused_) {
        grants_->of(phase_) = granted_;
      }
    }
    return !refused_;
  }

  WorkMeter* meter_;
  WorkGrants* grants_;
  WorkPhase phase_;
  std::int64_t granted_{0};
  std::int64_t done_{0};
  bool refused_{false};
};

}  // namespace impetus::inline scheduling
