// SPDX-License-Identifier: MIT
#include "experiments/protocol/design_words.hpp"

namespace impetus {
namespace {

std::string count_of(std::int64_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string cells_line(const Design& design) {
  std::string product;
  for (const Factor& factor : design.factors) {
    if (!design.adaptive || factor.name != design.adaptive->factor) {
      product += (product.empty() ? "" : " × ") + std::to_string(factor.levels.size());
    }
  }
  if (design.adaptive) {
    return product.empty() ? "One track." : "Tracks: " + product + ", interleaved at random.";
  }
  return product + (design.factors.size() > 1 ? " cells, " : " levels, ") +
         count_of(design.repetitions, "repetition", "repetitions") + " of each.";
}

std::string blocks_line(const Blocks& blocks) {
  std::string names;
  for (const std::string& factor : blocks.factors) {
    names += (names.empty() ? "`" : " × `") + factor + "`";
  }
  switch (blocks.order) {
    case Blocks::Order::kFixed:
      return "A block for each " + names + ", in the order listed.";
    case Blocks::Order::kLatinSquare:
      return "A block for each " + names +
             ", counterbalanced by a Latin square over the number that the participant's code ends "
             "in.";
    default:
      return "A block for each " + names + ", in random order.";
  }
}

std::string staircase_words(const Staircase& staircase) {
  return "by " +
         count_of(static_cast<std::int64_t>(staircase.starts.size()), "staircase",
                  "interleaved staircases") +
         ": harder after " + count_of(staircase.down, "positive answer", "positive answers") +
         ", easier after " + count_of(staircase.up, "negative one", "negative ones");
}

std::string adaptive_line(const Adaptive& adaptive) {
  const auto* staircase = std::get_if<Staircase>(&adaptive.method);
  const std::string method =
      staircase != nullptr ? staircase_words(*staircase) : "by QUEST+ (Watson 2017)";
  return "The level of `" + adaptive.factor + "` is chosen trial by trial, " + method + "; " +
         count_of(adaptive.trials_per_track, "trial", "trials") + " to a track.";
}

}  // namespace

std::string level_list(const Factor& factor) {
  std::string text;
  for (const LevelValue& level : factor.levels) {
    text += (text.empty() ? "" : ", ") + to_text(level);
  }
  return text;
}

std::string condition_words(const Condition& condition) {
  std::string text;
  for (const FactorLevel& level : condition) {
    text += (text.empty() ? "" : ", ") + level.factor + " " + to_text(level.value);
  }
  return text;
}

std::vector<std::string> design_lines(const Design& design) {
  std::vector<std::string> lines{cells_line(design)};
  if (design.adaptive) {
    lines.push_back(adaptive_line(*design.adaptive));
  }
  lines.push_back(design.blocks ? blocks_line(*design.blocks) : "In random order.");
  for (const LongestRun& rule : design.longest_runs) {
    lines.push_back("At most " + std::to_string(rule.longest) + " trials in a row with equal `" +
                    rule.factor + "`.");
  }
  for (const CatchTrials& trials : design.catch_trials) {
    lines.push_back(count_of(trials.count, "catch trial", "catch trials") +
                    (design.blocks ? " in each block" : "") +
                    ", outside the design: " + condition_words(trials.condition) + ".");
  }
  if (!design.practice.empty()) {
    const auto trials = static_cast<std::int64_t>(design.practice.size());
    lines.push_back("Practice: " + count_of(trials, "trial", "trials") +
                    (design.practice_rounds > 1
                         ? ", up to " + std::to_string(design.practice_rounds) + " times"
                         : "") +
                    ".");
  }
  return lines;
}

}  // namespace impetus
