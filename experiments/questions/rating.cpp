// A rating on a scale with words at both ends, by key or mouse. It has a table of its own; only
// that the time was up is kept beside the other responses. (Dingliana 2002, sec. 6.2)
// SPDX-License-Identifier: MIT
#include "experiments/questions/response_kinds.hpp"
#include "experiments/questions/session_pages.hpp"

namespace impetus::inline questions {
namespace rating_response {

constexpr const char* kName = "rating";

bool is_asked(const Script& script) { return script.scale.has_value(); }

Page page(const AskedTrial& asked) {
  const RatingScale& scale = *asked.script.scale;
  Page page;
  page.layout = Page::Layout::kScale;
  page.response = kName;
  page.title = scale.question;
  page.low_anchor = scale.low_anchor;
  page.high_anchor = scale.high_anchor;
  page.progress = asked.progress;
  page.best_choice = static_cast<std::size_t>(scale.best - scale.minimum);
  page.timeout_ms = scale.timeout_ms;
  for (std::int64_t point = scale.minimum; point <= scale.maximum; ++point) {
    page.choices.push_back({std::to_string(point), std::to_string(point)});
  }
  return page;
}

void keep(const AskedTrial& asked, const Answer& answer, AttemptRecord& record) {
  const RatingScale& scale = *asked.script.scale;
  if (answer.timed_out) {
    record.responses.push_back(response_record(kName, scale.question, answer));
    return;
  }
  record.ratings.push_back({scale.minimum + static_cast<std::int64_t>(answer.choice), scale.minimum,
                            scale.maximum, scale.best, scale.low_anchor, scale.high_anchor,
                            answer.device, answer.shown_ns, answer.arrived_ns,
                            answer.arrival_uncertainty_ns});
}

Text feedback(const Script& script, const AttemptRecord& record) {
  if (record.ratings.empty()) {
    return time_was_up(script.scale->timeout_ms);
  }
  const std::string rating = std::to_string(record.ratings.front().rating);
  return {"You answered " + rating,
          {"On the scale, " + rating + " means " +
           meaning_of(*script.scale, record.ratings.front().rating) + "."}};
}

}  // namespace rating_response

ResponseKind rating_kind() {
  using namespace rating_response;
  return {kName,
          "rating",
          "after the stimulus",
          "rating",
          {{"question", "the words above the scale"},
           {"minimum", "first point"},
           {"maximum", "last point"},
           {"best", "which end is good"},
           {"low_anchor", "words at the first point"},
           {"high_anchor", "words at the last point"},
           {"timeout_ms", "unanswered for so long, it is recorded as timed out", true}},
          {{"rating", "the point chosen"},
           {"minimum", "of its scale"},
           {"maximum", "of its scale"},
           {"best", "of its scale"},
           {"low_anchor", "of its scale"},
           {"high_anchor", "of its scale"},
           {"device", "mouse, key or simulated"},
           {"question_shown_ns", "flip that first showed the question"},
           {"arrived_ns", "own stamp when the event was taken from the queue"},
           {"arrival_uncertainty_ns", "it may have arrived this much earlier"}},
          "ask",
          is_asked,
          nullptr,
          page,
          keep,
          feedback};
}

}  // namespace impetus::inline questions
