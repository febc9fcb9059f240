// Which of two stimuli: the condition's own and the standard, in an order that the trial's seed
// decides. What a trial shows follows from it.
//
//   no such question   the condition's own
//   two intervals      own, standard   or   standard, own      drawn with the trial's seed
//
// The standard is the same trial with some levels replaced: it starts alike and draws alike, so
// that nothing but those levels sets the two apart.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/design/plan.hpp"
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {

/// To have chosen the condition's own is positive, and right.
class TwoIntervalQuestion final : public Question {
 public:
  static Kind<std::shared_ptr<const Question>> rows();
  void check_in_design(const JsonDocument& protocol, const Design& design) const override;

  /// Levels that the standard has instead of the condition's.
  [[nodiscard]] const Condition& standard_levels() const { return standard_; }
  /// The condition with the standard's levels in place of its own.
  [[nodiscard]] Condition standard(const Condition& condition) const;
  /// The blank between the two stimuli.
  [[nodiscard]] double between_ms() const { return between_ms_; }

  [[nodiscard]] const ResponseKind& kind() const override;
  [[nodiscard]] bool has_right_answer() const override { return true; }
  [[nodiscard]] std::size_t keyed_answers() const override { return 2; }
  [[nodiscard]] std::vector<std::string> keys() const override { return keys_; }
  [[nodiscard]] std::optional<Page> page(const AskedTrial& asked) const override;
  void keep(const AskedTrial& asked, const Answer& answer, AttemptRecord& record) const override;
  [[nodiscard]] Text feedback(const AttemptRecord& record, const Language& language) const override;
  [[nodiscard]] double timeout_ms() const override { return timeout_ms_; }
  [[nodiscard]] std::string explanation(const Words& words) const override;

 private:
  /// On the first choice or the second.
  [[nodiscard]] std::string words(bool first, const Language& language) const;

  std::string question_;
  std::optional<std::string> first_;  ///< the words on the two choices; none: the language's
  std::optional<std::string> second_;
  std::vector<std::string> keys_;  ///< of the first and the second; none: 1 and 2
  Condition standard_;
  double between_ms_{500.0};
  double timeout_ms_{0.0};  ///< 0: none
};

/// The script's question between two stimuli; null where a trial has one.
inline const TwoIntervalQuestion* find_two_interval(const Script& script) {
  return find_question<TwoIntervalQuestion>(script);
}

/// How many stimuli the trial shows: two where the script asks between two; of adaptation, one.
std::int64_t interval_count(const Script& script, const PlannedTrial& trial);

/// Which interval shows the condition's own stimulus, 1 or 2; 1 where there is one interval. It
/// follows from the trial's seed alone, by a random stream of its own.
std::int64_t test_interval(const Script& script, const PlannedTrial& trial);

/// What the trial shows, in order: itself, and the standard where the script asks for two.
std::vector<PlannedTrial> stimuli_of(const Script& script, const PlannedTrial& trial);

/// The conditions that trials of a condition show: itself, then its standard where there is one.
std::vector<Condition> shown_conditions(const Script& script, const Condition& condition);

}  // namespace impetus::inline questions
