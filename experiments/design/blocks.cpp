// SPDX-License-Identifier: MIT
#include "experiments/design/blocks.hpp"

#include <algorithm>
#include <utility>

#include "engine/numerics/random_stream.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline design {
namespace {

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// (The number that the code ends in − 1) mod `rows`; the number may have any count of digits.
std::size_t row_of(const std::string& participant, std::size_t rows) {
  const auto end = std::find_if_not(participant.rbegin(), participant.rend(), is_digit);
  const std::string digits(end.base(), participant.end());
  if (digits.empty()) {
    throw InputError("--participant " + participant +
                     ": expected a code that ends in a number, such as P01, because that number "
                     "decides the order of the blocks, got \"" +
                     participant + "\"");
  }
  std::size_t rest = 0;
  for (const char digit : digits) {
    rest = (rest * 10 + static_cast<std::size_t>(digit - '0')) % rows;
  }
  return (rest + rows - 1) % rows;
}

std::vector<Condition> in_row(const std::vector<Condition>& blocks,
                              const std::string& participant) {
  const auto square = williams_square(blocks.size());
  std::vector<Condition> ordered;
  for (const std::size_t block : square[row_of(participant, square.size())]) {
    ordered.push_back(blocks[block]);
  }
  return ordered;
}

bool has_blocks_alike(const Design& design) {
  return design.blocks && design.blocks->factors.empty();
}

std::size_t block_of_condition(const PlannedTrial& trial, const std::vector<Condition>& blocks) {
  const auto block = std::find_if(blocks.begin(), blocks.end(), [&](const Condition& one) {
    return has_levels(trial.condition, one);
  });
  return static_cast<std::size_t>(block - blocks.begin());
}

std::size_t block_of_repetition(const PlannedTrial& trial, const Design& design) {
  const std::int64_t all = design.adaptive ? design.adaptive->trials_per_track : design.repetitions;
  return static_cast<std::size_t>((trial.repetition - 1) * design.blocks->count / all);
}

}  // namespace

std::vector<std::vector<std::size_t>> williams_square(std::size_t count) {
  // 0, 1, n − 1, 2, n − 2, ...: all differences of neighbours differ. Each row adds one to the one
  // before; for odd n the rows are also read backwards.
  std::vector<std::size_t> first;
  for (std::size_t place = 0; place < count; ++place) {
    first.push_back(place % 2 == 1 ? (place + 1) / 2 : (count - place / 2) % count);
  }
  std::vector<std::vector<std::size_t>> rows;
  for (std::size_t row = 0; row < count; ++row) {
    rows.emplace_back();
    for (const std::size_t condition : first) {
      rows.back().push_back((condition + row) % count);
    }
  }
  for (std::size_t row = 0; count > 1 && count % 2 == 1 && row < count; ++row) {
    rows.emplace_back(rows[row].rbegin(), rows[row].rend());
  }
  return rows;
}

std::vector<Condition> block_order(const Design& design, const PlanKey& key) {
  if (!design.blocks) {
    return {Condition{}};
  }
  if (has_blocks_alike(design)) {
    return std::vector<Condition>(static_cast<std::size_t>(design.blocks->count));
  }
  std::vector<Condition> blocks = cells_of(design, design.blocks->factors);
  if (design.blocks->order == Blocks::Order::kRandom) {
    RandomStream stream(key.seed, "blocks/" + key.protocol + "/" + key.participant);
    stream.shuffle(blocks);
  } else if (design.blocks->order == Blocks::Order::kLatinSquare) {
    return in_row(blocks, key.participant);
  }
  return blocks;
}

TrialBlocks divided(std::vector<PlannedTrial> trials, const Design& design, const PlanKey& key) {
  const std::vector<Condition> blocks = block_order(design, key);
  TrialBlocks parts(blocks.size());
  for (PlannedTrial& trial : trials) {
    const std::size_t index = has_blocks_alike(design) ? block_of_repetition(trial, design)
                                                       : block_of_condition(trial, blocks);
    trial.block = static_cast<std::int64_t>(index) + 1;
    parts[index].push_back(std::move(trial));
  }
  return parts;
}

}  // namespace impetus::inline design
