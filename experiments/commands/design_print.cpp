// SPDX-License-Identifier: MIT
#include "experiments/commands/design_print.hpp"

#include <cstdio>

#include "experiments/session/adaptive_levels.hpp"
#include "experiments/session/blocks.hpp"

namespace impetus {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : " × ") + word;
  }
  return text;
}

void print_blocks(const Design& design, std::size_t blocks) {
  const Blocks::Order kind = design.blocks->order;
  const std::string order =
      kind == Blocks::Order::kFixed ? "in the order listed"
      : kind == Blocks::Order::kRandom
          ? "in random order"
          : "by the " + std::to_string(williams_square(blocks).size()) +
                " rows of a Latin square, one for the number at the end of each participant's code";
  std::printf("  blocks       %zu, one for each %s, %s\n", blocks,
              joined(design.blocks->factors).c_str(), order.c_str());
}

std::string method_words(const Adaptive& adaptive) {
  if (const auto* staircase = std::get_if<Staircase>(&adaptive.method)) {
    char share[32];
    std::snprintf(share, sizeof share, "%.1f", 100.0 * settling_share(*staircase));
    return "staircase, " + std::to_string(staircase->up) + " up " +
           std::to_string(staircase->down) + " down, which settles at " + share +
           " % positive answers";
  }
  const auto& quest_plus = std::get<QuestPlus>(adaptive.method);
  return "QUEST+, among " + std::to_string(candidates_of(quest_plus).size()) +
         (quest_plus.function == QuestPlus::Function::kNormal ? " normal" : " Weibull") +
         " functions";
}

void print_tracks(const Design& design) {
  const std::size_t tracks = adaptive_tracks(design).size();
  std::printf("  adaptive     %s by %s\n", design.adaptive->factor.c_str(),
              method_words(*design.adaptive).c_str());
  std::printf("               %zu %s of %lld trials%s\n", tracks, tracks == 1 ? "track" : "tracks",
              static_cast<long long>(design.adaptive->trials_per_track),
              tracks == 1 ? "" : ", interleaved at random");
}

}  // namespace

void print_order(const Design& design) {
  const std::size_t blocks = block_order(design, {"", "P01", 1}).size();
  if (design.blocks) {
    print_blocks(design, blocks);
  }
  if (design.adaptive) {
    print_tracks(design);
  }
  for (const LongestRun& rule : design.longest_runs) {
    std::printf("  order        random, at most %lld equal %s in a row\n",
                static_cast<long long>(rule.longest), rule.factor.c_str());
  }
  for (const CatchTrials& kind : design.catch_trials) {
    std::printf("  catch trials %lld%s: %s\n", static_cast<long long>(kind.count),
                blocks > 1 ? " in each block" : "", to_json(kind.condition).dump().c_str());
  }
}

}  // namespace impetus
