// Yes or no after the stimulus; right or wrong where the protocol says when yes is right.
//
//   yes counts as positive: seen
//   yes is right   where the level of a factor is above a number, no elsewhere
//
// SPDX-License-Identifier: MIT
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {

const ResponseKind& yes_no_kind();

namespace {

using nlohmann::json;

constexpr std::size_t kYes = 0;

/// What is asked, the words on the two choices (keys are y and n), and when yes is right.
class YesNoQuestion final : public Question {
 public:
  explicit YesNoQuestion(const json& block)
      : question_(block["question"].get<std::string>()),
        yes_(block.value("yes", std::string("yes"))),
        no_(block.value("no", std::string("no"))),
        timeout_ms_(block.value("timeout_ms", 0.0)) {
    if (block.contains("right_when")) {
      right_factor_ = block["right_when"]["factor"].get<std::string>();
      right_above_ = block["right_when"]["above"].get<double>();
    }
  }

  [[nodiscard]] const ResponseKind& kind() const override { return yes_no_kind(); }
  [[nodiscard]] bool has_right_answer() const override { return !right_factor_.empty(); }

  [[nodiscard]] std::optional<Page> page(const AskedTrial& asked) const override {
    Page page;
    page.layout = Page::Layout::kChoices;
    page.response = kind().name;
    page.title = question_;
    page.choices = {{yes_, "y"}, {no_, "n"}};
    page.positive_choice = kYes;
    page.progress = asked.progress;
    page.timeout_ms = timeout_ms_;
    return page;
  }

  void keep(const AskedTrial& asked, const Answer& answer, AttemptRecord& record) const override {
    ResponseRecord response = response_record(kind().name, question_, answer);
    if (!answer.timed_out) {
      response.positive = answer.choice == kYes;
      response.answer = *response.positive ? "yes" : "no";
    }
    if (const std::optional<bool> right = yes_is_right(asked.trial.condition)) {
      response.correct = response.positive == right;
    }
    record.responses.push_back(response);
  }

  [[nodiscard]] Text feedback(const AttemptRecord& record) const override {
    const ResponseRecord& response = *response_to(kind().name, record);
    if (response.timed_out) {
      return time_was_up(timeout_ms_);
    }
    Text text{"You answered “" + (*response.positive ? yes_ : no_) + "”", {}};
    if (response.correct) {
      const bool yes = *response.positive == *response.correct;
      text.paragraphs.push_back(*response.correct ? "That was right."
                                                  : "That was not right: the answer was “" +
                                                        (yes ? yes_ : no_) + "”.");
    }
    return text;
  }

  [[nodiscard]] std::string explanation(const Words& words) const override {
    return "“" + words(question_) + "” " + words(yes_) + " or " + words(no_);
  }

 private:
  /// Whether yes is right in this condition; none without a rule, or a number to go by.
  [[nodiscard]] std::optional<bool> yes_is_right(const Condition& condition) const {
    for (const FactorLevel& level : condition) {
      const auto* number = std::get_if<double>(&level.value);
      if (number != nullptr && level.factor == right_factor_) {
        return *number > right_above_;
      }
    }
    return std::nullopt;
  }

  std::string question_;
  std::string yes_;
  std::string no_;
  double timeout_ms_;         ///< 0: none
  std::string right_factor_;  ///< yes is right where its level is above; "": nothing is right
  double right_above_{0.0};
};

void check_right_when(const JsonDocument& protocol) {
  const json& block = protocol.value["yes_no"];
  if (!block.contains("right_when")) {
    return;
  }
  const auto name = block["right_when"]["factor"].get<std::string>();
  const json* factor = find_factor(protocol, name);
  if (factor == nullptr) {
    refuse(protocol, "/yes_no/right_when/factor",
           "expected the name of a factor, got " + json(name).dump());
  }
  for (const json& level : (*factor)["levels"]) {
    if (!level.is_number()) {
      refuse(protocol, "/yes_no/right_when/factor",
             "expected a factor whose levels are numbers, got " + json(name).dump() +
                 ", which has " + level.dump());
    }
  }
}

void simulate_yes_no(const Page& page, Judge& judge, Answer& answer) {
  const bool yes = judge.uniform() < judge.yes_probability(judge.clearest());
  answer.choice = yes ? page.positive_choice : 1 - page.positive_choice;
}

}  // namespace

const ResponseKind& yes_no_kind() {
  static const ResponseKind kind{
      .name = "yes_no",
      .protocol_key = "yes_no",
      .when = "after the stimulus",
      .table = "response",
      .parameters = {{"question", "the words above the choices"},
                     {"yes", "the words on the choice", true},
                     {"no", "the words on the choice", true},
                     {"timeout_ms", "unanswered for so long, it is recorded as timed out", true},
                     {"right_when", "yes is right where the factor's level is above a number",
                      true}},
      .recorded = {},
      .event = "Yes or no was asked for",
      .tested_as = "answer",
      .asks_for_a_fact = true,
      .read = [](const json& block) -> std::shared_ptr<const Question> {
        return std::make_shared<YesNoQuestion>(block);
      },
      .check_in_design = check_right_when,
      .simulate = simulate_yes_no};
  return kind;
}

}  // namespace impetus::inline questions
