// SPDX-License-Identifier: MIT
#include "experiments/design/plan.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "engine/numerics/random_stream.hpp"
#include "experiments/design/adaptive_levels.hpp"
#include "experiments/design/between_participants.hpp"
#include "experiments/design/blocks.hpp"
#include "experiments/design/trial_order.hpp"

namespace impetus::inline design {
namespace {

// Catch trials, spread among the main trials of each block.
//
//   block     | - - - - - - | - - - - - - | - - - - - - |     as many stretches as catch trials
//   with them | - c - - - - - | - - - - c - - | - - - c - - - |   one place drawn in each
//
// The main trials keep their order. A catch trial counts in a longest run like any trial that is
// shown.

/// A block's catch trials, kind by kind.
std::vector<PlannedTrial> catch_trials_of_block(const Design& design, std::int64_t block) {
  std::vector<PlannedTrial> trials;
  for (const CatchTrials& kind : design.catch_trials) {
    for (std::int64_t number = 1; number <= kind.count; ++number) {
      PlannedTrial trial;
      trial.condition = kind.condition;
      trial.block = block;
      trial.catch_trial = true;
      trials.push_back(std::move(trial));
    }
  }
  return trials;
}

std::vector<PlannedTrial> with_catch_trials(const std::vector<PlannedTrial>& main,
                                            std::vector<PlannedTrial> caught,
                                            RandomStream& stream) {
  stream.shuffle(caught);
  const std::size_t places = main.size() + 1;  // before each main trial, and at the end
  std::vector<PlannedTrial> merged;
  std::size_t next = 0;
  for (std::size_t stretch = 0; stretch < caught.size(); ++stretch) {
    const std::size_t begin = stretch * places / caught.size();
    const std::size_t end = (stretch + 1) * places / caught.size();
    const std::size_t place = begin + (end > begin ? stream.place_below(end - begin) : 0);
    while (next < place) {
      merged.push_back(main[next++]);
    }
    merged.push_back(caught[stretch]);
  }
  merged.insert(merged.end(), main.begin() + static_cast<std::ptrdiff_t>(next), main.end());
  return merged;
}

/// The repetitions of each kind.
void number_as_shown(TrialBlocks& blocks, const Design& design) {
  for (const CatchTrials& kind : design.catch_trials) {
    std::int64_t number = 0;
    for (std::vector<PlannedTrial>& block : blocks) {
      for (PlannedTrial& trial : block) {
        if (trial.catch_trial && trial.condition == kind.condition) {
          trial.repetition = ++number;
        }
      }
    }
  }
}

/// The same, one by one, each at a place of its stretch where all that is there by then keeps to
/// the rules. False: one has no such place.
bool place_catch_trials(TrialBlocks& blocks, const Design& design, RandomStream& stream) {
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    std::vector<PlannedTrial> caught =
        catch_trials_of_block(design, static_cast<std::int64_t>(block) + 1);
    stream.shuffle(caught);
    std::vector<PlannedTrial>& trials = blocks[block];
    const std::size_t places = trials.size() + 1;
    // From the last on, for the places of those before stay what they are.
    for (std::size_t stretch = caught.size(); stretch-- > 0;) {
      const std::size_t begin = stretch * places / caught.size();
      const std::size_t end = std::max(begin + 1, (stretch + 1) * places / caught.size());
      std::vector<std::size_t> tried(end - begin);
      std::iota(tried.begin(), tried.end(), begin);
      stream.shuffle(tried);
      const bool found = std::any_of(tried.begin(), tried.end(), [&](std::size_t place) {
        const auto at = trials.begin() + static_cast<std::ptrdiff_t>(place);
        const auto put = trials.insert(at, caught[stretch]);
        if (keeps_to(blocks, design.longest_runs)) {
          return true;
        }
        trials.erase(put);
        return false;
      });
      if (!found) {
        return false;
      }
    }
  }
  return true;
}

/// Puts the design's catch trials into every block. Their repetition counts those of one kind, in
/// the order shown. False, and nothing done, when no places were found that keep to the longest
/// runs; another order of the main trials may have some.
bool spread_catch_trials(TrialBlocks& blocks, const Design& design, RandomStream& stream) {
  constexpr int kMostDraws = 200;
  constexpr int kMostCareful = 5;
  if (design.catch_trials.empty()) {
    return true;
  }
  for (int draw = 0; draw < kMostDraws; ++draw) {
    TrialBlocks spread;
    for (std::size_t block = 0; block < blocks.size(); ++block) {
      const auto number = static_cast<std::int64_t>(block) + 1;
      spread.push_back(
          with_catch_trials(blocks[block], catch_trials_of_block(design, number), stream));
    }
    if (keeps_to(spread, design.longest_runs)) {
      number_as_shown(spread, design);
      blocks = std::move(spread);
      return true;
    }
  }
  for (int draw = 0; draw < kMostCareful; ++draw) {
    TrialBlocks spread = blocks;
    if (place_catch_trials(spread, design, stream)) {
      number_as_shown(spread, design);
      blocks = std::move(spread);
      return true;
    }
  }
  return false;
}

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
  constexpr int kMostOrders = 20;
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

/// The block with what its trials adapt to; numbered in each of the adaptations, as shown.
std::vector<PlannedTrial> with_adaptation(const std::vector<PlannedTrial>& block,
                                          const std::vector<Adaptation>& adaptations,
                                          std::vector<std::int64_t>& shown) {
  std::vector<PlannedTrial> merged;
  std::vector<bool> begun(adaptations.size());
  for (const PlannedTrial& trial : block) {
    for (std::size_t i = 0; i < adaptations.size(); ++i) {
      const Adaptation& stream = adaptations[i];
      if (!has_levels(trial.condition, stream.when)) {
        continue;
      }
      const std::int64_t count = begun[i] ? stream.before_each : stream.first;
      begun[i] = true;
      for (std::int64_t number = 0; number < count; ++number) {
        const auto turn = static_cast<std::size_t>(shown[i]) % stream.conditions.size();
        PlannedTrial adaptor;
        adaptor.phase = TrialPhase::kAdaptation;
        adaptor.repetition = ++shown[i];
        adaptor.condition = stream.conditions[turn];
        adaptor.block = trial.block;
        merged.push_back(std::move(adaptor));
      }
    }
    merged.push_back(trial);
  }
  return merged;
}

}  // namespace

TrialPhase phase_named(std::string_view name) {
  const auto* const found = std::find(kTrialPhases.begin(), kTrialPhases.end(), name);
  return found == kTrialPhases.end() ? TrialPhase::kMain
                                     : static_cast<TrialPhase>(found - kTrialPhases.begin());
}

Plan make_plan(const Design& all_groups, const PlanKey& key) {
  const Design design =
      design_of_group(all_groups, key.group ? *key.group : draw_group(all_groups, key, {}));
  const std::string owner = key.protocol + "/" + key.participant;
  RandomStream order(key.seed, (design.adaptive ? "tracks/" : "order/") + owner);
  RandomStream catches(key.seed, "catch trials/" + owner);
  RandomStream seeds(key.seed, "trial seeds/" + owner);

  TrialBlocks blocks = divided(main_trials(design), design, key);
  order_main_trials(blocks, design, order, catches);

  Plan plan = practice_trials(design);
  std::vector<std::int64_t> adaptors(design.adaptation.size());
  for (const std::vector<PlannedTrial>& block : blocks) {
    const std::vector<PlannedTrial> shown = with_adaptation(block, design.adaptation, adaptors);
    plan.insert(plan.end(), shown.begin(), shown.end());
  }
  for (std::size_t index = 0; index < plan.size(); ++index) {
    plan[index].slot = static_cast<std::int64_t>(index) + 1;
    // 63 bits: an SQLite integer is signed.
    plan[index].seed = seeds.next_bits() >> 1;
  }
  return plan;
}

}  // namespace impetus::inline design
