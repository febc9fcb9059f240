// Clicks during the stimulus, whenever something is seen: kept raw, merged by the analysis alone.
// (Dingliana 2002, sec. 6.3.1)
// SPDX-License-Identifier: MIT
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {
namespace click_response {

bool is_asked(const Script& script) { return script.clicks.has_value(); }

Text feedback(const Script& /*script*/, const AttemptRecord& record) {
  const std::size_t clicks = record.clicks.size();
  const std::string times = clicks == 1 ? "once" : std::to_string(clicks) + " times";
  return {"", {clicks == 0 ? "You did not click." : "You clicked " + times + "."}};
}

}  // namespace click_response

ResponseKind click_kind() {
  using namespace click_response;
  return {"click",
          "clicks",
          "during the stimulus",
          "click",
          {{"merge_within_ms", "for the analysis: events of one kind closer than this are one"}},
          {{"number", "from 1"},
           {"device", "mouse, key or simulated"},
           {"arrived_ns", "own stamp when the event was taken from the queue"},
           {"arrival_uncertainty_ns", "it may have arrived this much earlier"},
           {"interval", "of a two-interval trial, during its first or second stimulus"}},
          "take_clicks",
          is_asked,
          nullptr,
          nullptr,
          nullptr,
          feedback};
}

}  // namespace impetus::inline questions
