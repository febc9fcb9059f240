// SPDX-License-Identifier: MIT
#include "experiments/design/catch_trials.hpp"

#include <cstddef>
#include <utility>

namespace impetus::inline design {
namespace {

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
    const std::size_t place = begin + (end > begin ? stream.below(end - begin) : 0);
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

}  // namespace

bool spread_catch_trials(TrialBlocks& blocks, const Design& design, RandomStream& stream) {
  constexpr int kMostDraws = 200;
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
  return false;
}

}  // namespace impetus::inline design
