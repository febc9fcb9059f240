// Yes or no after the stimulus; right or wrong where the protocol says when yes is right.
//
//   yes counts as positive: seen
//   yes is right   where the level of a factor is above a number, no elsewhere
//
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {
namespace yes_no_response {

constexpr const char* kName = "yes_no";
constexpr std::size_t kYes = 0;

bool is_asked(const Script& script) { return script.yes_no.has_value(); }

bool has_right_answer(const Script& script) { return !script.yes_no->right_factor.empty(); }

/// Whether yes is right in this condition; none without a rule, or a number to go by.
std::optional<bool> yes_is_right(const YesNoQuestion& question, const Condition& condition) {
  for (const FactorLevel& level : condition) {
    const auto* number = std::get_if<double>(&level.value);
    if (number != nullptr && level.factor == question.right_factor) {
      return *number > question.right_above;
    }
  }
  return std::nullopt;
}

Page page(const AskedTrial& asked) {
  const YesNoQuestion& question = *asked.script.yes_no;
  Page page;
  page.layout = Page::Layout::kChoices;
  page.response = kName;
  page.title = question.question;
  page.choices = {{question.yes, "y"}, {question.no, "n"}};
  page.positive_choice = kYes;
  page.progress = asked.progress;
  page.timeout_ms = question.timeout_ms;
  return page;
}

void keep(const AskedTrial& asked, const Answer& answer, AttemptRecord& record) {
  const YesNoQuestion& question = *asked.script.yes_no;
  ResponseRecord response = response_record(kName, question.question, answer);
  const std::optional<bool> right = yes_is_right(question, asked.trial.condition);
  if (!answer.timed_out) {
    response.positive = answer.choice == kYes;
    response.answer = *response.positive ? "yes" : "no";
  }
  if (right) {
    response.correct = response.positive == right;
  }
  record.responses.push_back(response);
}

Text feedback(const Script& script, const AttemptRecord& record) {
  const YesNoQuestion& question = *script.yes_no;
  const ResponseRecord& response = *response_to(kName, record);
  Text text =
      response.timed_out
          ? time_was_up(question.timeout_ms)
          : Text{"You answered “" + (*response.positive ? question.yes : question.no) + "”", {}};
  if (response.correct && !response.timed_out) {
    const bool yes = *response.positive == *response.correct;
    text.paragraphs.push_back(*response.correct ? "That was right."
                                                : "That was not right: the answer was “" +
                                                      (yes ? question.yes : question.no) + "”.");
  }
  return text;
}

}  // namespace yes_no_response

ResponseKind yes_no_kind() {
  using namespace yes_no_response;
  return {kName,
          "yes_no",
          "after the stimulus",
          "response",
          {{"question", "the words above the choices"},
           {"yes", "the words on the choice", true},
           {"no", "the words on the choice", true},
           {"timeout_ms", "unanswered for so long, it is recorded as timed out", true},
           {"right_when", "yes is right where the factor's level is above a number", true}},
          {},
          "ask",
          is_asked,
          has_right_answer,
          page,
          keep,
          feedback};
}

}  // namespace impetus::inline questions
