// Clicks during the stimulus, whenever something is seen: kept raw, merged by the analysis alone.
// (Dingliana 2002, sec. 6.3.1)
// SPDX-License-Identifier: MIT
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {

const ResponseKind& click_kind();

namespace {

/// Nothing of its block matters before the analysis, which reads it from the protocol.
class ClickTask final : public Question {
 public:
  static Kind<std::shared_ptr<const Question>> rows() {
    return block<ClickTask>(
        "Clicks (mouse, or the space bar) during the stimulus, all kept raw.",
        {unread<ClickTask>(
             "merge_within_ms", number({0, 10000}),
             "For the analysis: collisions of one kind closer than this are one event.")
             .in_every_file(),
         row("first_ends", &ClickTask::first_ends_, flag(),
             "The stimulus is over with the first, and when it comes is what counts; false when "
             "left out.")});
  }

  [[nodiscard]] bool first_ends() const { return first_ends_; }
  [[nodiscard]] const ResponseKind& kind() const override { return click_kind(); }

  [[nodiscard]] Text feedback(const AttemptRecord& record,
                              const Language& language) const override {
    const auto clicks = static_cast<std::int64_t>(record.clicks.size());
    return {
        "",
        {clicks == 0 ? language.text("clicked_never") : language.counted_text("clicked", clicks)}};
  }

  [[nodiscard]] std::string explanation(const Words& /*words*/) const override {
    return first_ends_ ? "a click is recorded, which ends it" : "clicks are recorded";
  }

 private:
  bool first_ends_{false};
};

}  // namespace

bool takes_clicks(const Script& script) { return find_question<ClickTask>(script) != nullptr; }

bool ends_with_click(const Script& script) {
  const auto* task = find_question<ClickTask>(script);
  return task != nullptr && task->first_ends();
}

const ResponseKind& click_kind() {
  static const ResponseKind kind{
      .name = "click",
      .protocol_key = "clicks",
      .when = "during the stimulus",
      .table = "click",
      .block = ClickTask::rows(),
      .recorded = {{"number", "from 1"},
                   {"device", "mouse, key or simulated"},
                   {"arrived_ns", "own stamp when the event was taken from the queue"},
                   {"arrival_uncertainty_ns", "it may have arrived this much earlier"},
                   {"interval", "of a two-interval trial, during its first or second stimulus"}},
      .event = "A click during the stimulus",
      .tested_as = "clicks",
      .during_stimulus = true};
  return kind;
}

}  // namespace impetus::inline questions
