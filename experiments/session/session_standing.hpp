// Where a session stands: which trials wait, which are done, how far that is.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "experiments/design/plan.hpp"
#include "experiments/record/page.hpp"
#include "experiments/session/practice.hpp"

namespace impetus::inline session {

/// What earlier sessions of this enrolment already have; empty for a first session.
struct SessionHistory {
  std::set<std::int64_t> completed_slots;
  std::map<std::int64_t, std::int64_t> attempts;    ///< made so far, by slot
  std::set<std::string> answered;                   ///< ids of questions outside trials
  std::map<std::int64_t, PracticeResult> practice;  ///< of completed ones by slot; no conditions
  bool resumed{false};
  std::map<std::int64_t, bool> counted_answers;  ///< to adaptive trials, by slot; none: timed out
};

/// The trials of one phase, or of one round of practice, in the order of the plan; among the main
/// ones what they adapt to, which no number counts.
struct PhaseTrials {
  std::vector<const PlannedTrial*> waiting;
  std::int64_t total{0};
  std::int64_t done{0};
};

/// Keeps count of the plan's trials while a session runs.
class SessionStanding {
 public:
  /// `plan` and `history` must outlive this.
  SessionStanding(const Plan& plan, const SessionHistory& history, Language language = {},
                  bool light_pages = false)
      : plan_(plan),
        history_(history),
        language_(std::move(language)),
        light_pages_(light_pages),
        practice_(history.practice) {}

  /// The trial is done, with this result.
  void complete(const PlannedTrial& trial, const PracticeResult& result);

  /// Practice has come to this round; later ones may never be needed.
  void begin_round(std::int64_t round) { round_ = round; }

  /// What of practice is not done by now will not be.
  void end_practice() { round_ = 0; }

  /// `round` of practice; 0 for all rounds, and for the main trials.
  [[nodiscard]] PhaseTrials trials_of(TrialPhase phase, std::int64_t round) const;

  /// What was done in a round of practice, 0 for all, in whatever session; in the plan's order.
  [[nodiscard]] std::vector<PracticeResult> practice_results(std::int64_t round) const;

  [[nodiscard]] bool main_has_begun() const;
  [[nodiscard]] bool is_block_done(std::int64_t block) const;  ///< of main trials
  /// The next trial that is not done: of the present round of practice, until practice has ended or
  /// main trials have begun; none: all are.
  [[nodiscard]] std::optional<std::int64_t> next_slot() const;
  [[nodiscard]] std::int64_t last_round() const;  ///< of practice that is planned; 0: none
  [[nodiscard]] std::int64_t attempts_before(std::int64_t slot) const;
  [[nodiscard]] std::int64_t completed_count() const;  ///< earlier sessions included

  /// Of the trials that are expected: rounds of practice after the present one are not.
  [[nodiscard]] SessionProgress progress() const;
  /// The same, labelled "Practice 2 of 6" ("of at most 60", in training) or "Trial 12 of 81".
  [[nodiscard]] SessionProgress trial_progress(TrialPhase phase, std::int64_t number,
                                               std::int64_t total, bool at_most = false) const;

 private:
  [[nodiscard]] bool is_completed(std::int64_t slot) const;

  const Plan& plan_;
  const SessionHistory& history_;
  Language language_;  ///< of all progress
  bool light_pages_;
  std::set<std::int64_t> newly_completed_;
  std::map<std::int64_t, PracticeResult> practice_;  ///< by slot
  std::int64_t round_{1};                            ///< 0: practice has ended
};

}  // namespace impetus::inline session
