// SPDX-License-Identifier: MIT
#include "experiments/questions/response_kinds.hpp"

#include <algorithm>
#include <cstdio>

namespace impetus::inline questions {

using DeclaredKind = ResponseKind();
DeclaredKind click_kind, rating_kind, yes_no_kind, two_interval_kind, free_text_kind;

const std::vector<ResponseKind>& response_kinds() {
  static const std::vector<ResponseKind> kinds{click_kind(), rating_kind(), yes_no_kind(),
                                               two_interval_kind(), free_text_kind()};
  return kinds;
}

std::vector<std::string> responses_of(const Script& script) {
  std::vector<std::string> names;
  for (const ResponseKind& kind : response_kinds()) {
    if (kind.is_asked(script)) {
      names.push_back(kind.name);
    }
  }
  return names;
}

bool has_right_answers(const Script& script) {
  const std::vector<ResponseKind>& kinds = response_kinds();
  return std::any_of(kinds.begin(), kinds.end(), [&](const ResponseKind& kind) {
    return kind.is_asked(script) && kind.has_right_answer != nullptr &&
           kind.has_right_answer(script);
  });
}

std::optional<bool> answered_right(const AttemptRecord& record) {
  std::optional<bool> right;
  for (const ResponseRecord& response : record.responses) {
    if (response.correct) {
      right = right.value_or(true) && *response.correct;
    }
  }
  return right;
}

const ResponseRecord* response_to(const std::string& kind, const AttemptRecord& record) {
  for (const ResponseRecord& response : record.responses) {
    if (response.kind == kind) {
      return &response;
    }
  }
  return nullptr;
}

ResponseRecord response_record(const std::string& kind, const std::string& question,
                               const Answer& answer) {
  ResponseRecord record;
  record.kind = kind;
  record.question = question;
  record.device = answer.timed_out ? "none" : answer.device;
  record.question_shown_ns = answer.shown_ns;
  record.arrived_ns = answer.arrived_ns;
  record.arrival_uncertainty_ns = answer.arrival_uncertainty_ns;
  record.timed_out = answer.timed_out;
  return record;
}

Text time_was_up(double timeout_ms) {
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.3g", timeout_ms / 1e3);
  return {"The time was up", {"You have " + std::string(seconds) + " s to answer."}};
}

std::optional<bool> counted_answer(const AttemptRecord& attempt) {
  for (const ResponseRecord& response : attempt.responses) {
    if (response.positive) {
      return response.positive;
    }
  }
  return std::nullopt;
}

}  // namespace impetus::inline questions
