// SPDX-License-Identifier: MIT
#include "experiments/protocol/exclusion_rules.hpp"

#include <algorithm>

#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline protocol {

Kind<ExclusionRules> exclusion_rules_kind() {
  using E = ExclusionRules;
  const auto count = [](double least) { return whole<std::int64_t>({least, 10000}); };
  return object<E>(
      "Who meets any of these is left out of the analysis, and named with the reason; nothing is "
      "deleted. Of yes or no, or of a choice of an interval.",
      {row("equal_answers_in_a_row", &E::equal_answers_in_a_row, count(2),
           "So many main trials, or more, one after the other answered alike."),
       row("alternations_in_a_row", &E::alternations_in_a_row, count(1),
           "So many times, or more, one after the other the answer to a main trial is not that to "
           "the one before."),
       row("practice_right_below", &E::practice_right_below, count(1),
           "Fewer right answers than this in all trials of practice.")});
}

void check_exclusion_rules(const JsonDocument& protocol, const ExclusionRules& rules,
                           const Script& script, const Design& design) {
  const std::string place = "/exclude_when";
  if (!protocol.value.contains("exclude_when")) {
    return;
  }
  if (std::none_of(script.asked.begin(), script.asked.end(),
                   [](const auto& question) { return question->kind().is_two_sided; })) {
    refuse(protocol, place,
           "expected a question that rules of answers go by, a key " +
               list_keys([](const ResponseKind& kind) { return kind.is_two_sided; }) +
               ", but there is none");
  }
  if (!rules.practice_right_below) {
    return;
  }
  const std::string below = place + "/practice_right_below";
  if (std::none_of(script.asked.begin(), script.asked.end(), [](const auto& question) {
        return question->kind().is_two_sided && question->has_right_answer();
      })) {
    refuse(protocol, below,
           "expected a question that has a right answer (yes_no with right_when, or two_interval), "
           "but there is none");
  }
  const std::int64_t rounds = script.practice_rule ? script.practice_rule->rounds : 1;
  const std::int64_t most = script.training_rule
                                ? script.training_rule->most_trials
                                : rounds * static_cast<std::int64_t>(design.practice.size());
  if (*rules.practice_right_below > most) {
    refuse(protocol, below,
           "expected at most the " + std::to_string(most) + " trials of practice, got " +
               std::to_string(*rules.practice_right_below));
  }
}

std::vector<std::string> exclusion_lines(const ExclusionRules& rules) {
  std::vector<std::string> lines;
  if (rules.equal_answers_in_a_row) {
    lines.push_back("answers " + std::to_string(*rules.equal_answers_in_a_row) +
                    " main trials in a row alike, or more");
  }
  if (rules.alternations_in_a_row) {
    lines.push_back("alternates " + std::to_string(*rules.alternations_in_a_row) +
                    " times in a row, or more");
  }
  if (rules.practice_right_below) {
    const std::int64_t least = *rules.practice_right_below;
    lines.push_back(least == 1 ? "gives no right answer in practice"
                               : "gives fewer than " + std::to_string(least) +
                                     " right answers in practice");
  }
  return lines;
}

}  // namespace impetus::inline protocol
