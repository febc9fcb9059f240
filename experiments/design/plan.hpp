// The plan: every slot, condition and seed, decided and stored before the first trial is shown.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/design/design.hpp"

namespace impetus::inline design {

/// A value of the scene that was solved before the plan was stored.
struct SolvedValue {
  std::string pointer;  ///< JSON Pointer
  double value{0.0};

  friend bool operator==(const SolvedValue&, const SolvedValue&) = default;
};

/// Whether a trial is practice, which is never pooled, or counts; or adapts to what it shows, among
/// those that count, and nothing is asked of it.
enum class TrialPhase { kPractice, kMain, kAdaptation };

/// Their names, as they are kept.
inline constexpr std::array<std::string_view, 3> kTrialPhases{"practice", "main", "adaptation"};
[[nodiscard]] constexpr std::string_view name_of(TrialPhase phase) {
  return kTrialPhases[static_cast<std::size_t>(phase)];
}
/// The phase of this name; main when there is none.
TrialPhase phase_named(std::string_view name);

/// One trial to be shown.
struct PlannedTrial {
  std::int64_t slot{0};  ///< place in the session, from 1, practice first
  TrialPhase phase{TrialPhase::kMain};
  std::int64_t repetition{1};  ///< of practice: its round
  Condition condition;
  std::uint64_t seed{0};
  std::int64_t block{1};  ///< in the order shown
  bool catch_trial{false};
  /// Adaptive: the track that decides the level, from 0; `condition` lacks it until it is next.
  std::optional<std::int64_t> track{};
  std::vector<SolvedValue> solved{};             ///< put into the scene beside the condition
  std::optional<std::int64_t> yoked_trial_id{};  ///< of the study, whose gaze the region follows

  [[nodiscard]] bool is_practice() const { return phase == TrialPhase::kPractice; }
  /// Whether its questions are asked.
  [[nodiscard]] bool is_asked() const { return phase != TrialPhase::kAdaptation; }

  friend bool operator==(const PlannedTrial&, const PlannedTrial&) = default;
};

using Plan = std::vector<PlannedTrial>;

/// An adaptive trial's level, chosen just before the trial is shown, and what it was chosen by.
struct ChosenLevel {
  std::int64_t slot{0};
  Condition condition;             ///< whole, with the level
  std::vector<FactorLevel> state;  ///< of the track before the trial, by name
};

/// Whose plan it is: the order depends on these alone, on every machine.
struct PlanKey {
  std::string protocol;
  std::string participant;
  std::uint64_t seed{0};
  /// The participant's levels of the factors between participants; none: those of the study's first
  /// participant.
  std::optional<Condition> group{};
};

/// Of a design with factors between participants, the trials of the key's group alone.
///
/// Practice in its given order, then every cell × repetition (or the trials of every adaptive
/// track) block by block, in an order drawn uniformly from those that satisfy the design's longest
/// runs, with the catch trials spread among them and what they adapt to before them. Throws
/// std::runtime_error when no such order was found, and InputError when the participant's code has
/// no number for a Latin square.
Plan make_plan(const Design& design, const PlanKey& key);

}  // namespace impetus::inline design
