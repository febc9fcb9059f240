// SPDX-License-Identifier: MIT
#include "engine/scheduling/list_rules.hpp"

#include <cmath>

#include "engine/scheduling/named_kinds.hpp"
#include "engine/scheduling/region_lists.hpp"
#include "engine/scheduling/share_lists.hpp"
#include "engine/scheduling/threshold_lists.hpp"

namespace impetus::inline scheduling {
namespace {

const NamedKinds<ListRule>& all_list_rules() {
  static const NamedKinds<ListRule> all("list rule",
                                        {{"thresholds", std::make_shared<const ThresholdLists>()},
                                         {"pair_shares", std::make_shared<const ShareLists>()},
                                         {"region", std::make_shared<const RegionLists>()}});
  return all;
}

}  // namespace

std::string ListRule::problem(std::size_t /*lists*/, const std::vector<double>& limits,
                              const PriorityMetric& /*metric*/) const {
  return limits.empty() ? "" : "expected no limits, got " + std::to_string(limits.size());
}

bool has_priority(const MeasuredPair& x, const MeasuredPair& y) {
  const bool x_is_number = !std::isnan(x.priority);
  const bool y_is_number = !std::isnan(y.priority);
  if (x_is_number != y_is_number) {
    return x_is_number;
  }
  if (x_is_number && x.priority != y.priority) {
    return x.priority > y.priority;
  }
  return x.place < y.place;
}

std::shared_ptr<const ListRule> make_list_rule(std::string_view name) {
  return all_list_rules().called(name);
}

std::string_view list_rule_name(const ListRule& rule) { return all_list_rules().name(rule); }

std::vector<std::string_view> list_rule_names() { return all_list_rules().names(); }

}  // namespace impetus::inline scheduling
