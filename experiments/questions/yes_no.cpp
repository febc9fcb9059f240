// Yes or no after the stimulus; right or wrong where the protocol says when yes is right.
//
//   yes counts as positive: seen
//   yes is right   where the level of a factor is above a number, no elsewhere;
//                  or where two bodies touch until the scene's end, shown or hidden, no elsewhere
//
// SPDX-License-Identifier: MIT
#include "experiments/questions/answer_keys.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {

const ResponseKind& yes_no_kind();

namespace {

constexpr std::size_t kYes = 0;

/// What is asked, the words on the two choices where they are not the language's, and when yes is
/// right.
class YesNoQuestion final : public Question {
 public:
  static Kind<std::shared_ptr<const Question>> rows() {
    using Y = YesNoQuestion;
    return block<Y>(
        "Asked after every stimulus, and answered yes or no.",
        {required("question", &Y::question_, text()),
         row("yes", &Y::yes_, text(),
             "The words on the choice; yes, in the protocol's language, when left out."),
         row("no", &Y::no_, text()), row("keys", &Y::keys_, answer_keys_kind()),
         row("timeout_ms", &Y::timeout_ms_, timeout_kind()),
         group<Y>("right_when",
                  {row("factor", &Y::right_factor_, any_text()),
                   row("above", &Y::right_above_, number({})),
                   row("touch", &Y::right_touch_, several<2>(text()),
                       "In place of factor and above: two bodies of the scene.")},
                  "Yes is right where the factor's level is above this, no elsewhere; or where the "
                  "two bodies touch by the scene's end, though it be hidden.")});
  }

  void check_block(const JsonDocument& protocol) const override {
    const std::string place = "/yes_no/right_when";
    if (!protocol.value["yes_no"].contains("right_when")) {
      return;
    }
    if (right_touch_.has_value() == (right_factor_ || right_above_)) {
      refuse(protocol, place, "expected either \"factor\" and \"above\" or \"touch\"");
    }
    if (right_factor_.has_value() != right_above_.has_value()) {
      refuse(protocol, place,
             std::string("expected the key \"") + (right_factor_ ? "above" : "factor") +
                 "\", which is missing");
    }
    if (right_touch_ && (*right_touch_)[0] == (*right_touch_)[1]) {
      refuse(protocol, place + "/touch",
             "expected two bodies, got " + json_text((*right_touch_)[0]) + " twice");
    }
  }

  void check_in_design(const JsonDocument& protocol, const Design& design) const override {
    if (!right_factor_) {
      return;
    }
    const std::string place = "/yes_no/right_when/factor";
    const Factor& factor = named_factor(protocol, place, design, *right_factor_);
    for (const LevelValue& level : factor.levels) {
      if (!std::holds_alternative<double>(level)) {
        refuse(protocol, place,
               "expected a factor whose levels are numbers, got " + json_text(factor.name) +
                   ", which has " + json_text(level));
      }
    }
  }

  [[nodiscard]] double timeout_ms() const override { return timeout_ms_; }
  [[nodiscard]] const ResponseKind& kind() const override { return yes_no_kind(); }
  [[nodiscard]] std::size_t keyed_answers() const override { return 2; }
  [[nodiscard]] std::vector<std::string> keys() const override { return keys_; }
  [[nodiscard]] bool has_right_answer() const override { return right_factor_ || right_touch_; }
  [[nodiscard]] std::vector<NamedBody> named_bodies() const override {
    if (!right_touch_) {
      return {};
    }
    const std::string place = "/yes_no/right_when/touch/";
    return {{place + "0", (*right_touch_)[0]}, {place + "1", (*right_touch_)[1]}};
  }

  [[nodiscard]] std::optional<Page> page(const AskedTrial& asked) const override {
    Page page = page_of(kind(), Page::Layout::kChoices, question_, asked, timeout_ms_);
    const Language& language = asked.progress.language;
    page.choices = {{words(true, language), language.text("yes_key")},
                    {words(false, language), language.text("no_key")}};
    page.positive_choice = kYes;
    return page;
  }

  void keep(const AskedTrial& asked, const Answer& answer, AttemptRecord& record) const override {
    ResponseRecord response = response_record(kind().name, question_, answer);
    if (!answer.timed_out) {
      response.positive = answer.choice == kYes;
      response.answer = *response.positive ? "yes" : "no";
    }
    if (const std::optional<bool> right = yes_is_right(asked)) {
      response.correct = response.positive == right;
    }
    record.responses.push_back(response);
  }

  [[nodiscard]] Text feedback(const AttemptRecord& record,
                              const Language& language) const override {
    const ResponseRecord& response = *response_to(kind().name, record);
    if (response.timed_out) {
      return time_was_up(timeout_ms_, language);
    }
    const std::string given = language.quoted(words(*response.positive, language));
    Text text{language.text("you_answered", {{"answer", given}}), {}};
    if (response.correct) {
      const bool yes = *response.positive == *response.correct;
      text.paragraphs.push_back(right_or_wrong(*response.correct, words(yes, language), language));
    }
    return text;
  }

  [[nodiscard]] std::string explanation(const Words& words) const override {
    return "“" + words(question_) + "” " + words(yes_.value_or("yes")) + " or " +
           words(no_.value_or("no")) +
           (right_touch_ ? "; yes is right where " + words((*right_touch_)[0]) + " and " +
                               words((*right_touch_)[1]) + " touch by the scene's end"
            : right_factor_ ? "; yes is right where " + words(*right_factor_) + " is above " +
                                  to_text(LevelValue{*right_above_})
                            : "");
  }

 private:
  [[nodiscard]] std::string words(bool yes, const Language& language) const {
    return yes ? yes_.value_or(language.text("yes")) : no_.value_or(language.text("no"));
  }

  /// Whether yes is right in this trial; none without a rule, or without what it goes by.
  [[nodiscard]] std::optional<bool> yes_is_right(const AskedTrial& asked) const {
    if (right_touch_ && asked.touch) {
      return asked.touch(*right_touch_);
    }
    for (const FactorLevel& level : asked.trial.condition) {
      const auto* number = std::get_if<double>(&level.value);
      if (number != nullptr && level.factor == right_factor_) {
        return *number > right_above_;
      }
    }
    return std::nullopt;
  }

  std::string question_;
  std::optional<std::string> yes_;  ///< none: the language's
  std::optional<std::string> no_;
  std::vector<std::string> keys_;  ///< none: the language's
  double timeout_ms_{0.0};         ///< 0: none
  /// Yes is right where the level of one is above the other, or where these touch; none: nothing is
  /// right.
  std::optional<std::string> right_factor_;
  std::optional<double> right_above_;
  std::optional<std::array<std::string, 2>> right_touch_;
};

void simulate_yes_no(const Page& page, Judge& judge, Answer& answer) {
  const bool yes = judge.uniform() < judge.yes_probability(judge.clearest());
  answer.choice = yes ? page.positive_choice : 1 - page.positive_choice;
}

}  // namespace

const ResponseKind& yes_no_kind() {
  static const ResponseKind kind{.name = "yes_no",
                                 .protocol_key = "yes_no",
                                 .when = "after the stimulus",
                                 .table = "response",
                                 .block = YesNoQuestion::rows(),
                                 .recorded = {},
                                 .event = "Yes or no was asked for",
                                 .tested_as = "answer",
                                 .asks_for_a_fact = true,
                                 .is_two_sided = true,
                                 .simulate = simulate_yes_no};
  return kind;
}

}  // namespace impetus::inline questions
