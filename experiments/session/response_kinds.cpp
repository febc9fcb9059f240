// SPDX-License-Identifier: MIT
#include "experiments/session/response_kinds.hpp"

namespace impetus {

const std::vector<ResponseKind>& response_kinds() {
  static const std::vector<ResponseKind> kinds{
      {"click",
       "clicks",
       "during the stimulus",
       {{"merge_within_ms", "for the analysis: events of one kind closer than this are one"}},
       {{"number", "from 1"},
        {"device", "mouse, key or simulated"},
        {"arrived_ns", "own stamp when the event was taken from the queue"},
        {"arrival_uncertainty_ns", "it may have arrived this much earlier"}},
       "take_clicks"},
      {"rating",
       "rating",
       "after the stimulus",
       {{"question", "the words above the scale"},
        {"minimum", "first point"},
        {"maximum", "last point"},
        {"best", "which end is good"},
        {"low_anchor", "words at the first point"},
        {"high_anchor", "words at the last point"}},
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
       "ask"}};
  return kinds;
}

std::vector<std::string> responses_of(const Script& script) {
  return script.clicks ? std::vector<std::string>{"click", "rating"}
                       : std::vector<std::string>{"rating"};
}

}  // namespace impetus
