// SPDX-License-Identifier: MIT
#include "experiments/questions/rating.hpp"

namespace impetus::inline questions {

const ResponseKind& rating_kind();

namespace {

/// Draws how far from the good end the point lies, by the probability of each.
void simulate_rating(const Page& page, Judge& judge, Answer& answer) {
  const std::vector<double> chances = judge.probabilities(judge.clearest());
  const double draw = judge.uniform();
  std::size_t disbelief = 0;
  for (double reached = chances[0]; disbelief + 1 < chances.size() && draw >= reached;) {
    reached += chances[++disbelief];
  }
  answer.choice = page.best_choice == 0 ? disbelief : page.best_choice - disbelief;
}

}  // namespace

std::string RatingScale::meaning(std::int64_t rating, const Language& language) const {
  const std::string low = language.quoted(low_anchor);
  const std::string high = language.quoted(high_anchor);
  return rating == minimum   ? low
         : rating == maximum ? high
                             : language.text("scale_between", {{"low", low}, {"high", high}});
}

Kind<std::shared_ptr<const Question>> RatingQuestion::rows() {
  using R = RatingQuestion;
  using S = RatingScale;
  return block<R>("The scale on which every trial is rated.",
                  {required("question", &R::question_, text()),
                   required("minimum", &R::scale_, &S::minimum, whole<std::int64_t>({0, 8})),
                   required("maximum", &R::scale_, &S::maximum, whole<std::int64_t>({1, 9})),
                   required("best", &R::scale_, &S::best, whole<std::int64_t>({}),
                            "Which end is good: the minimum or the maximum."),
                   required("low_anchor", &R::scale_, &S::low_anchor, text()),
                   required("high_anchor", &R::scale_, &S::high_anchor, text()),
                   row("timeout_ms", &R::timeout_ms_, timeout_kind())});
}

void RatingQuestion::check_block(const JsonDocument& protocol) const {
  const std::string least = std::to_string(scale_.minimum);
  const std::string most = std::to_string(scale_.maximum);
  if (scale_.minimum >= scale_.maximum) {
    refuse(protocol, "/rating/maximum",
           "expected more than the minimum " + least + ", got " + most);
  }
  if (scale_.best != scale_.minimum && scale_.best != scale_.maximum) {
    refuse(protocol, "/rating/best",
           "expected one end of the scale, " + least + " or " + most + ", got " +
               std::to_string(scale_.best));
  }
}

const ResponseKind& RatingQuestion::kind() const { return rating_kind(); }

std::optional<Page> RatingQuestion::page(const AskedTrial& asked) const {
  Page page = page_of(kind(), Page::Layout::kScale, question_, asked, timeout_ms_);
  page.low_anchor = scale_.low_anchor;
  page.high_anchor = scale_.high_anchor;
  page.best_choice = static_cast<std::size_t>(scale_.best - scale_.minimum);
  for (std::int64_t point = scale_.minimum; point <= scale_.maximum; ++point) {
    page.choices.push_back({std::to_string(point), std::to_string(point)});
  }
  return page;
}

void RatingQuestion::keep(const AskedTrial& /*asked*/, const Answer& answer,
                          AttemptRecord& record) const {
  if (answer.timed_out) {
    record.responses.push_back(response_record(kind().name, question_, answer));
    return;
  }
  record.ratings.push_back({scale_.minimum + static_cast<std::int64_t>(answer.choice),
                            scale_.minimum, scale_.maximum, scale_.best, scale_.low_anchor,
                            scale_.high_anchor, answer.device, answer.shown_ns, answer.arrived_ns,
                            answer.arrival_uncertainty_ns});
}

Text RatingQuestion::feedback(const AttemptRecord& record, const Language& language) const {
  if (record.ratings.empty()) {
    return time_was_up(timeout_ms_, language);
  }
  const std::int64_t given = record.ratings.front().rating;
  const std::string rating = std::to_string(given);
  return {language.text("you_answered", {{"answer", rating}}),
          {language.text("scale_meaning",
                         {{"point", rating}, {"meaning", scale_.meaning(given, language)}})}};
}

std::string RatingQuestion::explanation(const Words& words) const {
  return "“" + words(question_) + "” " + std::to_string(scale_.minimum) + " (" +
         words(scale_.low_anchor) + ") to " + std::to_string(scale_.maximum) + " (" +
         words(scale_.high_anchor) + ")";
}

const ResponseKind& rating_kind() {
  static const ResponseKind kind{
      .name = "rating",
      .protocol_key = "rating",
      .when = "after the stimulus",
      .table = "rating",
      .block = RatingQuestion::rows(),
      .recorded = {{"rating", "the point chosen"},
                   {"minimum", "of its scale"},
                   {"maximum", "of its scale"},
                   {"best", "of its scale"},
                   {"low_anchor", "of its scale"},
                   {"high_anchor", "of its scale"},
                   {"device", "mouse, key or simulated"},
                   {"question_shown_ns", "flip that first showed the question"},
                   {"arrived_ns", "own stamp when the event was taken from the queue"},
                   {"arrival_uncertainty_ns", "it may have arrived this much earlier"}},
      .event = "A rating was asked for and given",
      .tested_as = "rating",
      .simulate = simulate_rating};
  return kind;
}

}  // namespace impetus::inline questions
