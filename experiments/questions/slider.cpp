// A slider after the stimulus: a mark set anywhere on a line with words under it, by mouse or keys.
// Nothing is marked before, so that nobody's answer begins at ours.
//
//   "scales": [{"question": ..., "minimum": 0, "maximum": 100, "words": ["not at all",
//   "certainly"]}]
//
//   with "when": {"group": "causal"}, a scale is asked in such trials alone: the first that fits
//
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "experiments/design/between_participants.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {

const ResponseKind& slider_kind();

namespace {

/// A question and its line.
struct SliderScale {
  std::string question;
  std::int64_t minimum{0};
  std::int64_t maximum{100};
  std::vector<std::string> words;  ///< under the line, evenly spread from end to end
  Condition when;                  ///< the levels under which it is asked; none: always
};

Kind<SliderScale> scale_kind() {
  using S = SliderScale;
  return object<S>("", {required("question", &S::question, text()),
                        required("minimum", &S::minimum, whole<std::int64_t>({-1000, 999})),
                        required("maximum", &S::maximum, whole<std::int64_t>({-999, 1000})),
                        required("words", &S::words, list(text(), {2, 5}),
                                 "Under the line, evenly spread from its left end to its right."),
                        row("when", &S::when, condition_kind(),
                            "The levels under which it is asked; always when left out.")});
}

/// The scales in the order in which they are tried.
class SliderQuestion final : public Question {
 public:
  static Kind<std::shared_ptr<const Question>> rows() {
    using S = SliderQuestion;
    return block<S>("Asked after every stimulus, and answered by a mark on a line.",
                    {required("scales", &S::scales_, list(scale_kind(), {1, 20}),
                              "The first that fits the trial is asked."),
                     row("timeout_ms", &S::timeout_ms_, timeout_kind())});
  }

  void check_block(const JsonDocument& protocol) const override {
    for (std::size_t i = 0; i < scales_.size(); ++i) {
      if (scales_[i].minimum >= scales_[i].maximum) {
        refuse(protocol, place(i) + "/maximum",
               "expected more than the minimum " + std::to_string(scales_[i].minimum) + ", got " +
                   std::to_string(scales_[i].maximum));
      }
    }
  }

  void check_in_design(const JsonDocument& protocol, const Design& design) const override {
    for (std::size_t i = 0; i < scales_.size(); ++i) {
      for (const FactorLevel& level : scales_[i].when) {
        const Factor& factor = named_factor(protocol, place(i) + "/when", design, level.factor);
        if (!has_level(factor, level.value)) {
          refuse(protocol, place(i) + "/when",
                 "expected a level of " + factor.name + ", got " + json_text(level.value));
        }
      }
    }
    for (const Condition& condition : asked_conditions(design)) {
      if (scale_for(condition) == nullptr) {
        refuse(protocol, "/slider/scales",
               "expected a scale for every condition, got none for " + to_json(condition).dump());
      }
    }
  }

  void check_sense(const JsonDocument& protocol, const Design& design) const override {
    std::set<const SliderScale*> asked;
    for (const Condition& condition : asked_conditions(design)) {
      asked.insert(scale_for(condition));
    }
    for (std::size_t i = 0; i < scales_.size(); ++i) {
      if (!asked.contains(&scales_[i])) {
        refuse(protocol, place(i),
               "expected a scale that some trial asks, but each asks one that is before it");
      }
    }
  }

  [[nodiscard]] double timeout_ms() const override { return timeout_ms_; }
  [[nodiscard]] const ResponseKind& kind() const override { return slider_kind(); }

  [[nodiscard]] std::vector<std::string> asked_by() const override {
    std::vector<std::string> factors;
    for (const SliderScale& scale : scales_) {
      for (const FactorLevel& level : scale.when) {
        factors.push_back(level.factor);
      }
    }
    return factors;
  }

  [[nodiscard]] std::optional<Page> page(const AskedTrial& asked) const override {
    const SliderScale* scale = scale_for(asked.trial.condition);
    if (scale == nullptr) {
      return std::nullopt;
    }
    Page page = page_of(kind(), Page::Layout::kForm, scale->question, asked, timeout_ms_);
    page.fields = {{kind().name, "", Field::Kind::kSlider, scale->words,
                    static_cast<double>(scale->minimum), static_cast<double>(scale->maximum)}};
    page.choices = {{asked.progress.language.text("continue"), "enter"}};
    return page;
  }

  void keep(const AskedTrial& asked, const Answer& answer, AttemptRecord& record) const override {
    const SliderScale& scale = *scale_for(asked.trial.condition);
    ResponseRecord response = response_record(kind().name, scale.question, answer);
    if (!answer.timed_out && !answer.fields.front().empty()) {
      response.answer = answer.fields.front();
      response.detail.push_back({"value", std::stod(response.answer)});
    }
    response.detail.push_back({"minimum", static_cast<double>(scale.minimum)});
    response.detail.push_back({"maximum", static_cast<double>(scale.maximum)});
    record.responses.push_back(response);
  }

  [[nodiscard]] Text feedback(const AttemptRecord& record,
                              const Language& language) const override {
    const ResponseRecord& response = *response_to(kind().name, record);
    return response.timed_out
               ? time_was_up(timeout_ms_, language)
               : Text{language.text("you_answered", {{"answer", response.answer}}), {}};
  }

  [[nodiscard]] std::string explanation(const Words& words) const override {
    std::string all;
    for (const SliderScale& scale : scales_) {
      all += std::string(all.empty() ? "" : "; or ") + "“" + words(scale.question) + "” from " +
             std::to_string(scale.minimum) + " (" + words(scale.words.front()) + ") to " +
             std::to_string(scale.maximum) + " (" + words(scale.words.back()) + ")" +
             (scale.when.empty() ? "" : " where " + words(condition_words(scale.when)));
    }
    return all;
  }

 private:
  /// Those of the design, of practice, and of catch trials, under every group.
  static std::vector<Condition> asked_conditions(const Design& design) {
    std::vector<Condition> beside = design.practice;
    for (const CatchTrials& trials : design.catch_trials) {
      beside.push_back(trials.condition);
    }
    std::vector<Condition> asked = cells(design);
    for (const Condition& condition : beside) {
      const std::vector<Condition> groups = in_every_group(condition, design);
      asked.insert(asked.end(), groups.begin(), groups.end());
    }
    return asked;
  }

  static std::string place(std::size_t scale) { return "/slider/scales/" + std::to_string(scale); }

  [[nodiscard]] const SliderScale* scale_for(const Condition& condition) const {
    const auto found = std::find_if(scales_.begin(), scales_.end(), [&](const SliderScale& scale) {
      return has_levels(condition, scale.when);
    });
    return found == scales_.end() ? nullptr : &*found;
  }

  std::vector<SliderScale> scales_;
  double timeout_ms_{0.0};  ///< 0: none
};

/// On a scale with a side below zero, both sides mean something. What is meant is a share of the
/// line from end to end, as a fit reads it.
void simulate_mark(const Page& page, Judge& judge, Answer& answer) {
  const Field& field = page.fields.front();
  const double share = field.minimum < 0.0 ? 0.5 * (1.0 + judge.two_sided_mark()) : judge.mark();
  const double mark = field.minimum + share * (field.maximum - field.minimum);
  const double value = std::clamp(std::round(mark), field.minimum, field.maximum);
  answer.fields.front() = std::to_string(static_cast<std::int64_t>(value));
}

}  // namespace

const ResponseKind& slider_kind() {
  static const ResponseKind kind{.name = "slider",
                                 .protocol_key = "slider",
                                 .when = "after the stimulus",
                                 .table = "response",
                                 .block = SliderQuestion::rows(),
                                 .recorded = {{"value", "where the mark was set"},
                                              {"minimum", "of its scale"},
                                              {"maximum", "of its scale"}},
                                 .event = "A mark on a line was asked for",
                                 .simulate = simulate_mark};
  return kind;
}

}  // namespace impetus::inline questions
