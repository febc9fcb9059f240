// SPDX-License-Identifier: MIT
#include "experiments/session/plan.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/numerics/random_stream.hpp"

namespace impetus {
namespace {

const LevelValue& level_of(const Condition& condition, const std::string& factor) {
  return std::find_if(condition.begin(), condition.end(),
                      [&](const FactorLevel& level) { return level.factor == factor; })
      ->value;
}

bool respects(const std::vector<PlannedTrial>& trials, const LongestRun& rule) {
  std::int64_t run = 0;
  const LevelValue* previous = nullptr;
  for (const PlannedTrial& trial : trials) {
    const LevelValue& level = level_of(trial.condition, rule.factor);
    run = previous != nullptr && *previous == level ? run + 1 : 1;
    if (run > rule.longest) {
      return false;
    }
    previous = &level;
  }
  return true;
}

bool respects_all(const std::vector<PlannedTrial>& trials, const std::vector<LongestRun>& rules) {
  return std::all_of(rules.begin(), rules.end(),
                     [&](const LongestRun& rule) { return respects(trials, rule); });
}

std::vector<PlannedTrial> main_trials(const Design& design) {
  std::vector<PlannedTrial> trials;
  for (std::int64_t repetition = 1; repetition <= design.repetitions; ++repetition) {
    for (const Condition& cell : cells(design)) {
      trials.push_back({0, TrialPhase::kMain, repetition, cell, 0});
    }
  }
  return trials;
}

/// Shuffling until the rules hold draws every permitted order with the same probability, which
/// repairing a bad order would not.
void draw_order(std::vector<PlannedTrial>& trials, const std::vector<LongestRun>& rules,
                RandomStream& stream) {
  constexpr int kMostDraws = 100'000;
  for (int draw = 0; draw < kMostDraws; ++draw) {
    stream.shuffle(trials);
    if (respects_all(trials, rules)) {
      return;
    }
  }
  throw std::runtime_error("no order of the trials that keeps to the longest runs was found in " +
                           std::to_string(kMostDraws) + " draws");
}

}  // namespace

Plan make_plan(const Design& design, const PlanKey& key) {
  const std::string owner = key.protocol + "/" + key.participant;
  RandomStream order(key.seed, "order/" + owner);
  RandomStream seeds(key.seed, "trial seeds/" + owner);

  Plan plan;
  for (std::int64_t round = 1; round <= design.practice_rounds; ++round) {
    for (const Condition& condition : design.practice) {
      plan.push_back({0, TrialPhase::kPractice, round, condition, 0});
    }
  }
  if (design.most_practice_trials > 0) {
    const auto most = static_cast<std::size_t>(design.most_practice_trials);
    plan.resize(std::min(plan.size(), most));
  }
  std::vector<PlannedTrial> trials = main_trials(design);
  draw_order(trials, design.longest_runs, order);
  plan.insert(plan.end(), trials.begin(), trials.end());
  for (std::size_t index = 0; index < plan.size(); ++index) {
    plan[index].slot = static_cast<std::int64_t>(index) + 1;
    // 63 bits: an SQLite integer is signed.
    plan[index].seed = seeds.next_bits() >> 1;
  }
  return plan;
}

}  // namespace impetus
