// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/adaptive_checks.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/design/psychometric.hpp"
#include "experiments/design/staircase.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline protocol {
namespace {

void check_levels_in_order(const Protocol& protocol, std::size_t factor) {
  const std::string place = item("/design/factors", factor) + "/levels";
  const std::vector<LevelValue>& levels = protocol.design.factors[factor].levels;
  const std::string got = ", as the factor is adaptive, got " + list_text(levels);
  if (!std::all_of(levels.begin(), levels.end(),
                   [](const LevelValue& level) { return level.index() == 0; })) {
    refuse(protocol.document, place, "expected numbers" + got);
  }
  if (levels.size() < 2) {
    refuse(protocol.document, place, "expected at least 2 levels to choose from" + got);
  }
  const auto values = numbers(levels);
  const auto none = values.end();
  const bool rising = std::adjacent_find(values.begin(), none, std::greater_equal<>()) == none;
  const bool falling = std::adjacent_find(values.begin(), none, std::less_equal<>()) == none;
  if (!rising && !falling) {
    refuse(protocol.document, place,
           "expected levels from hard to easy, all rising or all falling" + got);
  }
}

void check_method(const JsonDocument& protocol) {
  const auto& adaptive = protocol.value["design"]["adaptive"];
  if (adaptive.contains("staircase") == adaptive.contains("quest_plus")) {
    refuse(protocol, "/design/adaptive",
           std::string("expected either \"staircase\" or \"quest_plus\", got ") +
               (adaptive.contains("staircase") ? "both" : "neither"));
  }
}

void check_starts(const Protocol& protocol, std::size_t factor) {
  const auto* staircase = std::get_if<Staircase>(&protocol.design.adaptive->method);
  for (std::size_t i = 0; staircase != nullptr && i < staircase->starts.size(); ++i) {
    if (!has_level(protocol.design.factors[factor], staircase->starts[i])) {
      refuse(protocol.document, item("/design/adaptive/staircase/starts", i),
             "expected one of the factor's levels " +
                 list_text(protocol.design.factors[factor].levels) + ", got " +
                 json_text(staircase->starts[i]));
    }
  }
}

void check_order(const Protocol& protocol) {
  const Design& design = protocol.design;
  if (design.repetitions != 1) {
    refuse(protocol.document, "/design/repetitions",
           "expected 1 with adaptive levels, where trials_per_track says how many trials there "
           "are, got " +
               std::to_string(design.repetitions));
  }
  for (std::size_t i = 0; i < design.longest_runs.size(); ++i) {
    if (design.longest_runs[i].factor == design.adaptive->factor) {
      refuse(protocol.document, item("/design/longest_runs", i) + "/factor",
             "expected a factor whose levels are known beforehand, got " +
                 json_text(design.adaptive->factor) + ", which is adaptive");
    }
  }
}

/// Adaptive levels follow answers that have two sides.
void check_question(const Protocol& protocol) {
  const Questions& asked = protocol.script.asked;
  if (std::none_of(asked.begin(), asked.end(),
                   [](const auto& question) { return question->kind().is_two_sided; })) {
    const auto two_sided = [](const ResponseKind& kind) { return kind.is_two_sided; };
    refuse(protocol.document, "",
           "expected the key " + list_keys(two_sided) +
               ", because adaptive levels follow answers that are positive or negative, but both "
               "are missing");
  }
}

constexpr const char* kQuestPlus = "/design/adaptive/quest_plus/";

void check_staircase(const Protocol& protocol, const Staircase& staircase) {
  const double share = settling_share(staircase);
  for (const auto& question : protocol.script.asked) {
    const ResponseKind& kind = question->kind();
    if (kind.guessed_share > 0.0 && share < kind.guessed_share + 1e-6) {
      refuse(protocol.document, "/design/adaptive/staircase",
             "expected a rule that settles above " + printed("%g", 100.0 * kind.guessed_share) +
                 " % right answers, which guessing " + kind.guessing + " reaches, got " +
                 std::to_string(staircase.up) + " up, " + std::to_string(staircase.down) +
                 " down, which settles at " + printed("%.1f", 100.0 * share) + " %");
    }
  }
}

/// Levels rise, since the chance of a positive answer rises with them, and are on the scale.
void check_levels_on_scale(const Protocol& protocol, const QuestPlus& method, std::size_t factor) {
  const std::vector<LevelValue>& levels = protocol.design.factors[factor].levels;
  const std::string place = item("/design/factors", factor) + "/levels";
  const double least = std::get<double>(levels.front());
  const std::string got = ", got " + json_text(least);
  if (levels.front() > levels.back()) {
    refuse(protocol.document, place,
           "expected levels that rise from hard to easy, because the functions of QUEST+ rise "
           "with the level, got " +
               list_text(levels));
  }
  if (method.scale != QuestPlus::Scale::kLinear && !(least > 0.0)) {
    refuse(protocol.document, item(place, 0),
           "expected a level above 0, which has a logarithm" + got);
  }
  if (!is_defined(method.function, method.scale, least, 1.0)) {
    refuse(protocol.document, item(place, 0),
           "expected a level of at least 0, for a Weibull function of the level itself" + got);
  }
}

void check_rates(const Protocol& protocol, const QuestPlus& method) {
  for (const auto& [name, rates] : {std::pair("guess_rates", &method.guess_rates),
                                    std::pair("lapse_rates", &method.lapse_rates)}) {
    for (std::size_t i = 0; i < rates->size(); ++i) {
      if (const double rate = (*rates)[i]; !(rate >= 0.0 && rate < 1.0)) {
        refuse(protocol.document, item(std::string(kQuestPlus) + name, i),
               "expected a probability of at least 0 and less than 1, got " + json_text(rate));
      }
    }
  }
  const double guess = *std::max_element(method.guess_rates.begin(), method.guess_rates.end());
  const double lapse = *std::max_element(method.lapse_rates.begin(), method.lapse_rates.end());
  if (guess + lapse >= 1.0) {
    refuse(protocol.document, std::string(kQuestPlus) + "lapse_rates",
           "expected the largest guess rate and the largest lapse rate to add up to less than 1, "
           "or no level has a higher share of positive answers than another, got " +
               printed("%g", guess) + " and " + printed("%g", lapse));
  }
}

void check_grids(const Protocol& protocol, const QuestPlus& method,
                 const std::vector<double>& levels) {
  for (std::size_t i = 0; i < method.slopes.size(); ++i) {
    if (!(method.slopes[i] > 0.0)) {
      refuse(protocol.document, item(std::string(kQuestPlus) + "slopes", i),
             "expected a number > 0, got " + json_text(method.slopes[i]));
    }
  }
  const double least = on_scale(method.scale, levels.front());
  const double most = on_scale(method.scale, levels.back());
  for (std::size_t i = 0; i < method.thresholds.size(); ++i) {
    const double threshold = method.thresholds[i];
    const std::string place = item(std::string(kQuestPlus) + "thresholds", i);
    const std::string got = ", got " + json_text(threshold);
    const double slack = 1e-9 * (most - least);
    if (threshold < least - slack || threshold > most + slack) {
      refuse(protocol.document, place,
             "expected a threshold that some level can reach, from " + printed("%g", least) +
                 " to " + printed("%g", most) + " on the scale" + got);
    }
    if (!is_defined(method.function, method.scale, 0.0, threshold)) {
      refuse(protocol.document, place,
             "expected a threshold above 0, for a Weibull function of the level itself" + got);
    }
  }
}

/// Entries of the table that is made before a session, and gone through before every trial.
void check_table_size(const Protocol& protocol, const QuestPlus& method, std::size_t level_count) {
  constexpr double kMostEntries = 1e6;
  const std::array<std::size_t, 5> sizes{level_count, method.thresholds.size(),
                                         method.slopes.size(), method.guess_rates.size(),
                                         method.lapse_rates.size()};
  double entries = 1.0;
  for (const std::size_t size : sizes) {
    entries *= static_cast<double>(size);
  }
  if (entries > kMostEntries) {
    refuse(protocol.document, "/design/adaptive/quest_plus",
           "expected at most 1000000 combinations of the levels and the grids, got " +
               printed("%.15g", entries));
  }
  if (entries == static_cast<double>(level_count)) {
    refuse(protocol.document, "/design/adaptive/quest_plus",
           "expected grids with at least two psychometric functions to tell apart, got one");
  }
}

}  // namespace

void check_adaptive(const Protocol& protocol) {
  if (!protocol.design.adaptive) {
    return;
  }
  const std::string& name = protocol.design.adaptive->factor;
  factor_within(protocol.document, "/design/adaptive/factor", protocol.design, name);
  const std::size_t factor = factor_place(protocol.design, name);
  check_levels_in_order(protocol, factor);
  check_method(protocol.document);
  check_starts(protocol, factor);
  check_order(protocol);
  check_question(protocol);
  if (const auto* staircase = std::get_if<Staircase>(&protocol.design.adaptive->method)) {
    check_staircase(protocol, *staircase);
    return;
  }
  const auto& method = std::get<QuestPlus>(protocol.design.adaptive->method);
  const std::vector<double> levels = numbers(protocol.design.factors[factor].levels);
  check_levels_on_scale(protocol, method, factor);
  check_rates(protocol, method);
  check_grids(protocol, method, levels);
  check_table_size(protocol, method, levels.size());
}

}  // namespace impetus::inline protocol
