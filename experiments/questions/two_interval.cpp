// Which of two stimuli: the condition's own and the standard, in an order that the trial's seed
// decides. To have chosen the condition's own is positive, and right.
// SPDX-License-Identifier: MIT
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {
namespace two_interval_response {

constexpr const char* kName = "two_interval";

bool is_asked(const Script& script) { return script.two_interval.has_value(); }

bool has_right_answer(const Script& /*script*/) { return true; }

Page page(const AskedTrial& asked) {
  const TwoIntervalQuestion& question = *asked.script.two_interval;
  Page page;
  page.layout = Page::Layout::kChoices;
  page.response = kName;
  page.title = question.question;
  page.choices = {{question.first, "1"}, {question.second, "2"}};
  page.positive_choice = static_cast<std::size_t>(asked.test_interval - 1);
  page.progress = asked.progress;
  page.timeout_ms = question.timeout_ms;
  return page;
}

void keep(const AskedTrial& asked, const Answer& answer, AttemptRecord& record) {
  ResponseRecord response = response_record(kName, asked.script.two_interval->question, answer);
  response.detail = {{"test_interval", static_cast<double>(asked.test_interval)}};
  response.correct = false;
  if (!answer.timed_out) {
    response.answer = answer.choice == 0 ? "first" : "second";
    response.positive = answer.choice + 1 == static_cast<std::size_t>(asked.test_interval);
    response.correct = response.positive;
  }
  record.responses.push_back(response);
}

Text feedback(const Script& script, const AttemptRecord& record) {
  const TwoIntervalQuestion& question = *script.two_interval;
  const ResponseRecord& response = *response_to(kName, record);
  if (response.timed_out) {
    return time_was_up(question.timeout_ms);
  }
  const bool chose_first = response.answer == "first";
  const bool first_is_right = chose_first == *response.correct;
  return {"You chose “" + (chose_first ? question.first : question.second) + "”",
          {*response.correct ? "That was right."
                             : "That was not right: the answer was “" +
                                   (first_is_right ? question.first : question.second) + "”."}};
}

}  // namespace two_interval_response

ResponseKind two_interval_kind() {
  using namespace two_interval_response;
  return {kName,
          "two_interval",
          "after the second stimulus",
          "response",
          {{"question", "the words above the choices"},
           {"first", "the words on the choice", true},
           {"second", "the words on the choice", true},
           {"standard", "levels that the standard has in place of the condition's"},
           {"between_ms", "blank between the two stimuli", true},
           {"timeout_ms", "unanswered for so long, it is recorded as timed out", true}},
          {{"test_interval", "which interval showed the condition's own stimulus"}},
          "ask",
          is_asked,
          has_right_answer,
          page,
          keep,
          feedback};
}

}  // namespace impetus::inline questions
