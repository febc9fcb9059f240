// SPDX-License-Identifier: MIT
#include "experiments/design/plan.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/numerics/random_stream.hpp"
#include "experiments/design/adaptive_levels.hpp"
#include "experiments/design/blocks.hpp"
#include "experiments/design/catch_trials.hpp"
#include "experiments/design/trial_order.hpp"

namespace impetus::inline design {
namespace {

Plan practice_trials(const Design& design) {
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
  return plan;
}

std::vector<PlannedTrial> adaptive_trials(const Design& design) {
  std::vector<PlannedTrial> trials;
  const std::vector<TrackPlan> tracks = adaptive_tracks(design);
  for (std::size_t track = 0; track < tracks.size(); ++track) {
    for (std::int64_t trial = 1; trial <= design.adaptive->trials_per_track; ++trial) {
      trials.push_back({0, TrialPhase::kMain, trial, tracks[track].condition, 0});
      trials.back().track = static_cast<std::int64_t>(track);
    }
  }
  return trials;
}

std::vector<PlannedTrial> main_trials(const Design& design) {
  if (design.adaptive) {
    return adaptive_trials(design);
  }
  std::vector<PlannedTrial> trials;
  for (std::int64_t repetition = 1; repetition <= design.repetitions; ++repetition) {
    for (const Condition& cell : cells(design)) {
      trials.push_back({0, TrialPhase::kMain, repetition, cell, 0});
    }
  }
  return trials;
}

/// Trials of a track are alike until they are shown: the repetition is the number in the track.
void number_tracks(TrialBlocks& blocks) {
  std::map<std::int64_t, std::int64_t> shown;
  for (std::vector<PlannedTrial>& block : blocks) {
    for (PlannedTrial& trial : block) {
      if (trial.track) {
        trial.repetition = ++shown[*trial.track];
      }
    }
  }
}

/// Where an order of the main trials leaves no places for the catch trials, another is drawn.
void order_main_trials(TrialBlocks& blocks, const Design& design, RandomStream& order,
                       RandomStream& catches) {
  constexpr int kMostOrders = 500;
  for (int draw = 0; draw < kMostOrders; ++draw) {
    draw_order(blocks, design.longest_runs, order);
    if (spread_catch_trials(blocks, design, catches)) {
      number_tracks(blocks);
      return;
    }
  }
  throw std::runtime_error(
      "no order of the trials and the catch trials that keeps to the longest "
      "runs was found in " +
      std::to_string(kMostOrders) + " draws");
}

}  // namespace

Plan make_plan(const Design& design, const PlanKey& key) {
  const std::string owner = key.protocol + "/" + key.participant;
  RandomStream order(key.seed, (design.adaptive ? "tracks/" : "order/") + owner);
  RandomStream catches(key.seed, "catch trials/" + owner);
  RandomStream seeds(key.seed, "trial seeds/" + owner);

  TrialBlocks blocks = divided(main_trials(design), block_order(design, key));
  order_main_trials(blocks, design, order, catches);

  Plan plan = practice_trials(design);
  for (const std::vector<PlannedTrial>& block : blocks) {
    plan.insert(plan.end(), block.begin(), block.end());
  }
  for (std::size_t index = 0; index < plan.size(); ++index) {
    plan[index].slot = static_cast<std::int64_t>(index) + 1;
    // 63 bits: an SQLite integer is signed.
    plan[index].seed = seeds.next_bits() >> 1;
  }
  return plan;
}

}  // namespace impetus::inline design
