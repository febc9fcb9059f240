// SPDX-License-Identifier: MIT
#include "experiments/design/between_participants.hpp"

#include <algorithm>

#include "engine/numerics/random_stream.hpp"

namespace impetus::inline design {
std::vector<Condition> groups(const Design& design) {
  Design between;
  std::copy_if(design.factors.begin(), design.factors.end(), std::back_inserter(between.factors),
               [](const Factor& factor) { return factor.between; });
  return cells(between);
}

Condition group_of(const Design& design, const Condition& condition) {
  Condition group;
  for (const Factor& factor : design.factors) {
    const FactorLevel* level = find_level(condition, factor.name);
    if (factor.between && level != nullptr) {
      group.push_back(*level);
    }
  }
  return group;
}

Condition draw_group(const Design& design, const PlanKey& key,
                     const std::vector<Condition>& earlier) {
  std::vector<Condition> all = groups(design);
  const auto count = [&](const Condition& group) {
    return std::count(earlier.begin(), earlier.end(), group);
  };
  const auto fewest = count(*std::min_element(
      all.begin(), all.end(), [&](const auto& a, const auto& b) { return count(a) < count(b); }));
  std::erase_if(all, [&](const Condition& group) { return count(group) > fewest; });
  RandomStream stream(key.seed, "between participants/" + key.protocol + "/" + key.participant);
  return all[stream.place_below(all.size())];
}

Condition with_group(const Condition& condition, const Condition& group, const Design& design) {
  Condition whole;
  for (const Factor& factor : design.factors) {
    const FactorLevel* level = find_level(factor.between ? group : condition, factor.name);
    if (level != nullptr) {
      whole.push_back(*level);
    }
  }
  return whole;
}

std::vector<Condition> in_every_group(const Condition& condition, const Design& design) {
  std::vector<Condition> conditions;
  for (const Condition& group : groups(design)) {
    conditions.push_back(with_group(condition, group, design));
  }
  return conditions;
}

Design design_of_group(Design design, const Condition& group) {
  if (group.empty()) {
    return design;
  }
  for (Condition& condition : design.practice) {
    condition = with_group(condition, group, design);
  }
  for (CatchTrials& kind : design.catch_trials) {
    kind.condition = with_group(kind.condition, group, design);
  }
  for (Adaptation& stream : design.adaptation) {
    for (Condition& condition : stream.conditions) {
      condition = with_group(condition, group, design);
    }
  }
  for (Factor& factor : design.factors) {
    if (factor.between) {
      factor.levels = {find_level(group, factor.name)->value};
    }
  }
  return design;
}

}  // namespace impetus::inline design
