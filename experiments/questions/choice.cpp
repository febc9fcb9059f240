// One of two to nine answers after the stimulus; right or wrong where the protocol says which is
// right.
//
//   "options": ["it bounced", "it passed", "it stopped"]
//   "right_when": {"factor": "event", "options": {"bounce": "it bounced", "pass": "it passed"}}
//
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "experiments/questions/answer_keys.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {

const ResponseKind& choice_kind();

namespace {

/// A level as a key of an object has it: a word as it is, a number in digits.
std::string key_of(const LevelValue& level) {
  const auto* word = std::get_if<std::string>(&level);
  return word != nullptr ? *word : to_json(level).dump();
}

/// What is asked, what can be answered, and which of it is right at each level of a factor.
class ChoiceQuestion final : public Question {
 public:
  static Kind<std::shared_ptr<const Question>> rows() {
    using C = ChoiceQuestion;
    return block<C>("Asked after every stimulus, and answered by one of several options.",
                    {required("question", &C::question_, text()),
                     required("options", &C::options_, list(text(), {2, 9}), "In the order shown."),
                     row("keys", &C::keys_, answer_keys_kind(), "1 2 3 and so on, when left out."),
                     row("timeout_ms", &C::timeout_ms_, timeout_kind()),
                     group<C>("right_when",
                              {row("factor", &C::right_factor_, any_text()),
                               row("options", &C::right_options_, by_name(text()),
                                   "By the factor's level: which option is right.")},
                              "Which option is right follows from a factor's level.")});
  }

  void check_block(const JsonDocument& protocol) const override {
    if (right_factor_.has_value() == right_options_.empty()) {
      refuse(protocol, "/choice/right_when",
             std::string("expected the key \"") + (right_factor_ ? "options" : "factor") +
                 "\", which is missing");
    }
    for (std::size_t i = 0; i < options_.size(); ++i) {
      if (index_of(options_[i]) != i) {
        refuse(protocol, "/choice/options/" + std::to_string(i),
               "expected options that differ, got " + json_text(options_[i]) + " twice");
      }
    }
    for (const auto& [level, option] : right_options_) {
      if (index_of(option) == options_.size()) {
        refuse(protocol, "/choice/right_when/options/" + level,
               "expected one of the options, got " + json_text(option));
      }
    }
  }

  void check_in_design(const JsonDocument& protocol, const Design& design) const override {
    if (!right_factor_) {
      return;
    }
    const Factor& factor =
        named_factor(protocol, "/choice/right_when/factor", design, *right_factor_);
    for (const LevelValue& level : factor.levels) {
      if (!right_options_.contains(key_of(level))) {
        refuse(protocol, "/choice/right_when/options",
               "expected an option for every level of " + factor.name + ", got none for " +
                   json_text(level));
      }
    }
  }

  [[nodiscard]] double timeout_ms() const override { return timeout_ms_; }
  [[nodiscard]] const ResponseKind& kind() const override { return choice_kind(); }
  [[nodiscard]] std::size_t keyed_answers() const override { return options_.size(); }
  [[nodiscard]] std::vector<std::string> keys() const override { return keys_; }
  [[nodiscard]] bool has_right_answer() const override { return right_factor_.has_value(); }

  [[nodiscard]] std::optional<Page> page(const AskedTrial& asked) const override {
    Page page = page_of(kind(), Page::Layout::kChoices, question_, asked, timeout_ms_);
    for (const std::string& option : options_) {
      page.choices.push_back({option, std::to_string(page.choices.size() + 1)});
    }
    page.positive_choice = right_option(asked.trial.condition);
    return page;
  }

  void keep(const AskedTrial& asked, const Answer& answer, AttemptRecord& record) const override {
    ResponseRecord response = response_record(kind().name, question_, answer);
    response.detail = {{"options", static_cast<double>(options_.size())}};
    const std::size_t right = right_option(asked.trial.condition);
    if (right < options_.size()) {
      response.detail.push_back({"right", options_[right]});
      response.correct = !answer.timed_out && answer.choice == right;
    }
    if (!answer.timed_out) {
      response.answer = options_[answer.choice];
    }
    record.responses.push_back(response);
  }

  [[nodiscard]] Text feedback(const AttemptRecord& record,
                              const Language& language) const override {
    const ResponseRecord& response = *response_to(kind().name, record);
    if (response.timed_out) {
      return time_was_up(timeout_ms_, language);
    }
    Text text{language.text("you_answered", {{"answer", language.quoted(response.answer)}}), {}};
    if (response.correct) {
      const auto& right = std::get<std::string>(response.detail.back().value);
      text.paragraphs.push_back(right_or_wrong(*response.correct, right, language));
    }
    return text;
  }

  [[nodiscard]] std::string explanation(const Words& words) const override {
    std::string all;
    for (const std::string& option : options_) {
      all += (all.empty() ? "" : &option == &options_.back() ? " or " : ", ") + words(option);
    }
    return "“" + words(question_) + "” " + all +
           (right_factor_ ? "; which is right follows from " + words(*right_factor_) : "");
  }

 private:
  /// The number of options: it is none of them.
  [[nodiscard]] std::size_t index_of(const std::string& option) const {
    return static_cast<std::size_t>(std::find(options_.begin(), options_.end(), option) -
                                    options_.begin());
  }

  /// The number of options where none is right, or what it goes by is missing.
  [[nodiscard]] std::size_t right_option(const Condition& condition) const {
    for (const FactorLevel& level : condition) {
      const auto found = right_options_.find(key_of(level.value));
      if (level.factor == right_factor_ && found != right_options_.end()) {
        return index_of(found->second);
      }
    }
    return options_.size();
  }

  std::string question_;
  std::vector<std::string> options_;
  std::vector<std::string> keys_;                     ///< none: digits
  double timeout_ms_{0.0};                            ///< 0: none
  std::optional<std::string> right_factor_;           ///< none: nothing is right
  std::map<std::string, std::string> right_options_;  ///< by level
};

/// Who sees what happens answers right; who does not, or where nothing is right, takes any.
void simulate_chosen_option(const Page& page, Judge& judge, Answer& answer) {
  const bool is_seen = judge.uniform() < judge.yes_probability(judge.clearest());
  const auto count = static_cast<double>(page.choices.size());
  const auto guess = static_cast<std::size_t>(judge.uniform() * count);
  answer.choice =
      is_seen && page.positive_choice < page.choices.size() ? page.positive_choice : guess;
}

}  // namespace

const ResponseKind& choice_kind() {
  static const ResponseKind kind{
      .name = "choice",
      .protocol_key = "choice",
      .when = "after the stimulus",
      .table = "response",
      .block = ChoiceQuestion::rows(),
      .recorded = {{"options", "how many there were to choose from"},
                   {"right", "the option that was right, where one was"}},
      .event = "One of several answers was asked for",
      .asks_for_a_fact = true,
      .simulate = simulate_chosen_option};
  return kind;
}

}  // namespace impetus::inline questions
