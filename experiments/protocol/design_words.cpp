// SPDX-License-Identifier: MIT
#include "experiments/protocol/design_words.hpp"
#include "experiments/protocol/factor_values.hpp"

#include "experiments/design/adaptive_levels.hpp"
#include "experiments/design/between_participants.hpp"
#include "experiments/design/blocks.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline protocol {
namespace {

std::string cells_line(const Design& design) {
  if (design.adaptive) {
    const auto tracks = static_cast<std::int64_t>(adaptive_tracks(design).size());
    return count_of(tracks, "track", "tracks, interleaved at random") + ", of " +
           count_of(design.adaptive->trials_per_track, "trial", "trials each") + ".";
  }
  std::string product;
  std::size_t within = 0;
  for (const Factor& factor : design.factors) {
    if (!factor.between) {
      product += (product.empty() ? "" : " × ") + std::to_string(factor.levels.size());
      ++within;
    }
  }
  return (product.empty() ? "1" : product) +
         (within > 1    ? " cells, "
          : within == 1 ? (product == "1" ? " level, " : " levels, ")
                        : " cell, ") +
         count_of(design.repetitions, "repetition") + " of each.";
}

/// "" where all factors vary within participants.
std::string between_line(const Design& design) {
  std::string names;
  for (const Factor& factor : design.factors) {
    if (factor.between) {
      names += (names.empty() ? "`" : " × `") + factor.name + "`";
    }
  }
  return names.empty()
             ? ""
             : "Between participants: " + names + ", " + std::to_string(groups(design).size()) +
                   " groups. Whoever is planned for joins one that has the fewest so far, "
                   "drawn by seed and code; that is kept with the plan.";
}

std::string blocks_line(const Design& design) {
  const Blocks& blocks = *design.blocks;
  if (blocks.factors.empty()) {
    return std::to_string(blocks.count) +
           " blocks alike, each with every cell equally often, in random order within.";
  }
  const std::size_t count = block_order(design, {"", "P01", 1}).size();
  std::string names;
  for (const std::string& factor : blocks.factors) {
    names += (names.empty() ? "`" : " × `") + factor + "`";
  }
  const std::string each = std::to_string(count) + " blocks, one for each " + names + ", ";
  switch (blocks.order) {
    case Blocks::Order::kFixed:
      return each + "in the order listed.";
    case Blocks::Order::kLatinSquare:
      return each + "by the " + std::to_string(williams_square(count).size()) +
             " rows of a Latin square (Williams 1949): the row goes by the number that the "
             "participant's code ends in.";
    default:
      return each + "in random order.";
  }
}

std::string staircase_words(const Staircase& staircase) {
  const std::string share = printed("%.1f", 100.0 * settling_share(staircase));
  return "by a staircase, harder after " +
         count_of(staircase.down, "positive answer", "positive answers in a row") +
         " and easier after " + count_of(staircase.up, "negative one", "negative ones in a row") +
         ", which settles at " + share + " % positive answers";
}

std::string quest_plus_words(const QuestPlus& quest_plus) {
  return "by QUEST+ (Watson 2017), among " + std::to_string(candidates_of(quest_plus).size()) +
         (quest_plus.function == QuestPlus::Function::kNormal ? " normal" : " Weibull") +
         " functions";
}

std::string adaptive_line(const Adaptive& adaptive) {
  const auto* staircase = std::get_if<Staircase>(&adaptive.method);
  return "The level of `" + adaptive.factor + "` is chosen trial by trial " +
         (staircase != nullptr ? staircase_words(*staircase)
                               : quest_plus_words(std::get<QuestPlus>(adaptive.method))) +
         ".";
}

std::string practice_line(const Design& design) {
  const auto trials = static_cast<std::int64_t>(design.practice.size());
  std::string line = "Practice: " + count_of(trials, "trial");
  if (design.most_practice_trials > 0) {
    line += ", again and again until it is learnt, at most " +
            std::to_string(design.most_practice_trials) + " in all";
  } else if (design.practice_rounds > 1) {
    line += ", up to " + std::to_string(design.practice_rounds) + " times until it is understood";
  }
  return line + ".";
}

}  // namespace

std::string level_list(const Factor& factor) { return listed(factor.levels, to_text); }

std::string changed_by(const Factor& factor) {
  if (!factor.keys_of.empty()) {
    return "keys of " + factor.keys_of;
  }
  const std::string pointers = listed(overridden_by(factor));
  return pointers.empty() ? "nothing of the scene" : pointers;
}

std::vector<std::string> design_lines(const Design& design,
                                      std::string (*text_of)(std::string_view)) {
  std::vector<std::string> lines{cells_line(design_of_group(design, groups(design).front()))};
  if (const std::string line = between_line(design); !line.empty()) {
    lines.push_back(line);
  }
  if (design.adaptive) {
    lines.push_back(adaptive_line(*design.adaptive));
  }
  lines.push_back(design.blocks ? blocks_line(design) : "In random order.");
  for (const LongestRun& rule : design.longest_runs) {
    lines.push_back("At most " + std::to_string(rule.longest) + " trials in a row with equal `" +
                    rule.factor + "`.");
  }
  for (const CatchTrials& trials : design.catch_trials) {
    lines.push_back(count_of(trials.count, "catch trial") +
                    (design.blocks ? " in each block" : "") +
                    ", outside the design: " + text_of(condition_words(trials.condition)) + ".");
  }
  for (const Adaptation& stream : design.adaptation) {
    std::string conditions;
    for (const Condition& condition : stream.conditions) {
      conditions += (conditions.empty() ? "" : "; ") + condition_words(condition);
    }
    const std::string where =
        stream.when.empty() ? "everywhere" : "where " + text_of(condition_words(stream.when));
    lines.push_back("Adaptation " + where + ": " + count_of(stream.first, "trial") +
                    " before the first of a block, " + std::to_string(stream.before_each) +
                    " before each other one, of which nothing is asked: " + text_of(conditions) +
                    ".");
  }
  if (!design.practice.empty()) {
    lines.push_back(practice_line(design));
  }
  return lines;
}

}  // namespace impetus::inline protocol
