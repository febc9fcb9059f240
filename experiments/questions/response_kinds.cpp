// SPDX-License-Identifier: MIT
#include "experiments/questions/response_kinds.hpp"

#include <algorithm>

#include "experiments/tables/number_text.hpp"

namespace impetus::inline questions {

using Kinds = std::vector<std::reference_wrapper<const ResponseKind>>;
using Declared = const ResponseKind&();
Declared click_kind, rating_kind, yes_no_kind, two_interval_kind, choice_kind, slider_kind,
    free_text_kind;

const Kinds& response_kinds() {
  static const Kinds kinds{click_kind(),  rating_kind(), yes_no_kind(),   two_interval_kind(),
                           choice_kind(), slider_kind(), free_text_kind()};
  return kinds;
}

const Kinds& listed_kinds() {
  static const Kinds listed = [] {
    Kinds kinds = response_kinds();
    std::stable_partition(kinds.begin(), kinds.end(),
                          [](const ResponseKind& kind) { return !kind.during_stimulus; });
    return kinds;
  }();
  return listed;
}

std::string list_keys(const std::function<bool(const ResponseKind&)>& is_meant) {
  std::vector<std::string> keys;
  for (const ResponseKind& kind : listed_kinds()) {
    if (is_meant(kind)) {
      keys.push_back("\"" + kind.protocol_key + "\"");
    }
  }
  std::string list;
  for (const std::string& key : keys) {
    list += (list.empty() ? "" : &key == &keys.back() ? " or " : ", ") + key;
  }
  return list;
}

const ResponseKind* find_kind(const std::string& name) {
  const auto found = std::find_if(response_kinds().begin(), response_kinds().end(),
                                  [&](const ResponseKind& kind) { return kind.name == name; });
  return found == response_kinds().end() ? nullptr : &found->get();
}

RowList<Script> question_rows() {
  RowList<Script> rows;
  for (const ResponseKind& kind : response_kinds()) {
    rows.append({kind.protocol_key, kind.block, "",
                 [read = kind.block.read](const nlohmann::json& block, Script& script) {
                   script.asked.push_back(read(block));
                 }});
  }
  return rows;
}

Kind<double> timeout_kind() {
  return defined("answer_timeout_ms", number(above(0, 600000)),
                 "A question gone unanswered for so long is recorded as timed out; without limit "
                 "when left out.");
}

double Judge::clearest() const {
  return *std::max_element(seen_in_intervals().begin(), seen_in_intervals().end());
}

bool has_right_answers(const Script& script) {
  return std::any_of(script.asked.begin(), script.asked.end(),
                     [](const auto& question) { return question->has_right_answer(); });
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

std::optional<bool> counted_answer(const AttemptRecord& attempt) {
  for (const ResponseRecord& response : attempt.responses) {
    if (response.positive) {
      return response.positive;
    }
  }
  return std::nullopt;
}

const ResponseRecord* response_to(const std::string& kind, const AttemptRecord& record) {
  for (const ResponseRecord& response : record.responses) {
    if (response.kind == kind) {
      return &response;
    }
  }
  return nullptr;
}

Page page_of(const ResponseKind& kind, Page::Layout layout, const std::string& question,
             const AskedTrial& asked, double timeout_ms) {
  Page page;
  page.layout = layout;
  page.response = kind.name;
  page.title = question;
  page.progress = asked.progress;
  page.timeout_ms = timeout_ms;
  return page;
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

Text time_was_up(double timeout_ms, const Language& language) {
  const std::string seconds = printed("%.3g", timeout_ms / 1e3);
  return {language.text("time_was_up"),
          {language.text("time_to_answer", {{"seconds", language.number(seconds)}})}};
}

std::string right_or_wrong(bool right, const std::string& right_answer, const Language& language) {
  return right ? language.text("was_right")
               : language.text("was_wrong", {{"answer", language.quoted(right_answer)}});
}

}  // namespace impetus::inline questions
