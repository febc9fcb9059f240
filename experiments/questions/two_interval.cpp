// SPDX-License-Identifier: MIT
#include "experiments/questions/two_interval.hpp"

#include <algorithm>

#include "engine/numerics/random_stream.hpp"
#include "experiments/questions/answer_keys.hpp"
#include "experiments/questions/level_value.hpp"

namespace impetus::inline questions {

const ResponseKind& two_interval_kind();

namespace {

void simulate_choice(const Page& /*page*/, Judge& judge, Answer& answer) {
  const std::vector<double>& seen = judge.seen_in_intervals();
  const double first = judge.first_probability(seen.front(), seen.back());
  answer.choice = judge.uniform() < first ? 0 : 1;
}

}  // namespace

Kind<std::shared_ptr<const Question>> TwoIntervalQuestion::rows() {
  using T = TwoIntervalQuestion;
  return block<T>(
      "Every trial shows two stimuli, the condition's own and the standard, in random order; one "
      "of them is chosen.",
      {required("question", &T::question_, text()),
       row("first", &T::first_, text(),
           "The words on the choice; the first, in the protocol's language, when left out."),
       row("second", &T::second_, text()), row("keys", &T::keys_, answer_keys_kind()),
       required("standard", &T::standard_, condition_kind(),
                "Levels that the standard has in place of the condition's."),
       row("between_ms", &T::between_ms_, number({0, 60000}),
           "Blank between the two; 500 when left out."),
       row("timeout_ms", &T::timeout_ms_, timeout_kind())});
}

void TwoIntervalQuestion::check_in_design(const JsonDocument& protocol,
                                          const Design& design) const {
  if (standard_.empty()) {
    refuse(protocol, "/two_interval/standard",
           "expected at least one level, or both intervals show the same, got {}");
  }
  for (const FactorLevel& level : standard_) {
    if (find_factor(design, level.factor) == nullptr) {
      refuse(protocol, "/two_interval/standard",
             "expected only factors of the design, got " + json_text(level.factor));
    }
  }
}

Condition TwoIntervalQuestion::standard(const Condition& condition) const {
  Condition standard = condition;
  for (FactorLevel& level : standard) {
    for (const FactorLevel& replacement : standard_) {
      if (replacement.factor == level.factor) {
        level.value = replacement.value;
      }
    }
  }
  return standard;
}

const ResponseKind& TwoIntervalQuestion::kind() const { return two_interval_kind(); }

std::optional<Page> TwoIntervalQuestion::page(const AskedTrial& asked) const {
  Page page = page_of(kind(), Page::Layout::kChoices, question_, asked, timeout_ms_);
  const Language& language = asked.progress.language;
  page.choices = {{words(true, language), "1"}, {words(false, language), "2"}};
  page.positive_choice = static_cast<std::size_t>(asked.test_interval - 1);
  return page;
}

void TwoIntervalQuestion::keep(const AskedTrial& asked, const Answer& answer,
                               AttemptRecord& record) const {
  ResponseRecord response = response_record(kind().name, question_, answer);
  response.detail = {{"test_interval", static_cast<double>(asked.test_interval)}};
  response.correct = false;
  if (!answer.timed_out) {
    response.answer = answer.choice == 0 ? "first" : "second";
    response.positive = answer.choice + 1 == static_cast<std::size_t>(asked.test_interval);
    response.correct = response.positive;
  }
  record.responses.push_back(response);
}

std::string TwoIntervalQuestion::words(bool first, const Language& language) const {
  return first ? first_.value_or(language.text("first"))
               : second_.value_or(language.text("second"));
}

Text TwoIntervalQuestion::feedback(const AttemptRecord& record, const Language& language) const {
  const ResponseRecord& response = *response_to(kind().name, record);
  if (response.timed_out) {
    return time_was_up(timeout_ms_, language);
  }
  const bool chose_first = response.answer == "first";
  const bool first_is_right = chose_first == *response.correct;
  return {language.text("you_chose", {{"answer", language.quoted(words(chose_first, language))}}),
          {right_or_wrong(*response.correct, words(first_is_right, language), language)}};
}

std::string TwoIntervalQuestion::explanation(const Words& words) const {
  return "“" + words(question_) + "” " + words(first_.value_or("the first")) + " or " +
         words(second_.value_or("the second"));
}

const ResponseKind& two_interval_kind() {
  static const ResponseKind kind{
      .name = "two_interval",
      .protocol_key = "two_interval",
      .when = "after the second stimulus",
      .table = "response",
      .block = TwoIntervalQuestion::rows(),
      .recorded = {{"test_interval", "which interval showed the condition's own stimulus"}},
      .event = "Which of two stimuli was asked for",
      .tested_as = "answer",
      .is_two_sided = true,
      .guessed_share = 0.5,
      .guessing = "between two intervals",
      .simulate = simulate_choice};
  return kind;
}

std::int64_t interval_count(const Script& script, const PlannedTrial& trial) {
  return trial.is_asked() && find_two_interval(script) != nullptr ? 2 : 1;
}

std::int64_t test_interval(const Script& script, const PlannedTrial& trial) {
  if (interval_count(script, trial) == 1) {
    return 1;
  }
  RandomStream order(trial.seed, "order of intervals");
  return 1 + static_cast<std::int64_t>(order.below(2));
}

std::vector<PlannedTrial> stimuli_of(const Script& script, const PlannedTrial& trial) {
  if (interval_count(script, trial) == 1) {
    return {trial};
  }
  std::vector<PlannedTrial> stimuli;
  for (Condition& condition : shown_conditions(script, trial.condition)) {
    stimuli.push_back(trial);
    stimuli.back().condition = std::move(condition);
  }
  if (test_interval(script, trial) == 2) {
    std::reverse(stimuli.begin(), stimuli.end());
  }
  return stimuli;
}

std::vector<Condition> shown_conditions(const Script& script, const Condition& condition) {
  const TwoIntervalQuestion* question = find_two_interval(script);
  return question == nullptr ? std::vector<Condition>{condition}
                             : std::vector<Condition>{condition, question->standard(condition)};
}

}  // namespace impetus::inline questions
