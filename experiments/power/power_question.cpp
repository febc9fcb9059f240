// SPDX-License-Identifier: MIT
#include "experiments/power/power_question.hpp"

namespace impetus::inline power {

const std::vector<QuestionText>& question_texts() {
  using Q = PowerQuestion;
  static const std::vector<QuestionText> texts{
      {"protocol", "protocol", &Q::protocol},
      {"protocol_hash", "version of the protocol", &Q::protocol_hash},
      {"observer", "observer", &Q::observer},
      {"null_observer", "observer without the effect", &Q::null_observer},
      {"screen", "screen", &Q::screen},
      {"response", "response", &Q::response},
      {"model", "model", &Q::model},
      {"factors", "choice of factors", &Q::factors},
      {"compared", "pair of levels", &Q::compared}};
  return texts;
}

std::string difference(const PowerQuestion& one, const PowerQuestion& other) {
  for (const QuestionText& text : question_texts()) {
    if (one.*text.place != other.*text.place) {
      return text.words;
    }
  }
  return one.seed == other.seed ? "" : "seed";
}

std::vector<PowerCell> cells_of(const PowerRequest& request) {
  std::vector<PowerCell> cells;
  const std::int64_t all = request.studies + request.null_studies;
  const std::int64_t begin = (request.chunk.number - 1) * all / request.chunk.of;
  const std::int64_t end = request.chunk.number * all / request.chunk.of;
  std::int64_t place = 0;
  for (std::int64_t number = 1; place < end; ++number) {
    for (const bool effect : {true, false}) {
      if (number > (effect ? request.studies : request.null_studies)) {
        continue;
      }
      if (place >= begin && place < end) {
        cells.push_back({effect, number, request.sizes});
      }
      ++place;
    }
  }
  return cells;
}

}  // namespace impetus::inline power
