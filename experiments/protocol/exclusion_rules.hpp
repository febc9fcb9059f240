// Rules by which answers leave a participant out of the analysis, as a protocol says them.
//
//   protocol: exclude_when ──> study file: the view excluded_by_rule ──> excluded ──> reports,
//   exports
//
// Nothing is deleted, and `impetus exclude --take-back` has a participant in again.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/questions/script.hpp"
#include "experiments/settings/json_document.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline protocol {

/// Each is a rule where it is said.
struct ExclusionRules {
  std::optional<std::int64_t> equal_answers_in_a_row;
  std::optional<std::int64_t> alternations_in_a_row;
  std::optional<std::int64_t> practice_right_below;
};

/// Their block in a protocol.
Kind<ExclusionRules> exclusion_rules_kind();

/// What they go by is asked: yes or no or two intervals, and right answers in practice, of which
/// there are enough. Throws InputError.
void check_exclusion_rules(const JsonDocument& protocol, const ExclusionRules& rules,
                           const Script& script, const Design& design);

/// Sentences for a page of explanation; none without a rule.
std::vector<std::string> exclusion_lines(const ExclusionRules& rules);

}  // namespace impetus::inline protocol
