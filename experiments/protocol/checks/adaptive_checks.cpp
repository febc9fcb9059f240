// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/adaptive_checks.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "experiments/design/psychometric.hpp"
#include "experiments/design/staircase.hpp"
#include "experiments/protocol/design_reading.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

/// Place of the adaptive factor among the design's. Refuses a name that is none's.
std::size_t adaptive_factor(const JsonDocument& protocol) {
  const json& design = protocol.value["design"];
  const auto name = design["adaptive"]["factor"].get<std::string>();
  for (std::size_t i = 0; i < design["factors"].size(); ++i) {
    if (design["factors"][i]["name"].get<std::string>() == name) {
      return i;
    }
  }
  refuse(protocol, "/design/adaptive/factor",
         "expected the name of a factor, got " + json(name).dump());
}

void check_levels_in_order(const JsonDocument& protocol, std::size_t factor) {
  const std::string place = item("/design/factors", factor) + "/levels";
  const json& levels = protocol.value["design"]["factors"][factor]["levels"];
  if (!std::all_of(levels.begin(), levels.end(),
                   [](const json& level) { return level.is_number(); })) {
    refuse(protocol, place, "expected numbers, as the factor is adaptive, got " + levels.dump());
  }
  if (levels.size() < 2) {
    refuse(protocol, place,
           "expected at least 2 levels to choose from, as the factor is adaptive, got " +
               levels.dump());
  }
  const auto numbers = levels.get<std::vector<double>>();
  const auto none = numbers.end();
  const bool rising = std::adjacent_find(numbers.begin(), none, std::greater_equal<>()) == none;
  const bool falling = std::adjacent_find(numbers.begin(), none, std::less_equal<>()) == none;
  if (!rising && !falling) {
    refuse(protocol, place,
           "expected levels from hard to easy, all rising or all falling, as the factor is "
           "adaptive, got " +
               levels.dump());
  }
}

void check_method(const JsonDocument& protocol) {
  const json& adaptive = protocol.value["design"]["adaptive"];
  const bool both = adaptive.contains("staircase") && adaptive.contains("quest_plus");
  const bool neither = !adaptive.contains("staircase") && !adaptive.contains("quest_plus");
  if (both || neither) {
    refuse(protocol, "/design/adaptive",
           std::string("expected either \"staircase\" or \"quest_plus\", got ") +
               (both ? "both" : "neither"));
  }
}

void check_starts(const JsonDocument& protocol, std::size_t factor) {
  const json& design = protocol.value["design"];
  if (!design["adaptive"].contains("staircase")) {
    return;
  }
  const json& levels = design["factors"][factor]["levels"];
  const json& starts = design["adaptive"]["staircase"]["starts"];
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (std::find(levels.begin(), levels.end(), starts[i]) == levels.end()) {
      refuse(protocol, item("/design/adaptive/staircase/starts", i),
             "expected one of the factor's levels " + levels.dump() + ", got " + starts[i].dump());
    }
  }
}

void check_order(const JsonDocument& protocol) {
  const json& design = protocol.value["design"];
  if (design["repetitions"].get<std::int64_t>() != 1) {
    refuse(protocol, "/design/repetitions",
           "expected 1 with adaptive levels, where trials_per_track says how many trials there "
           "are, got " +
               design["repetitions"].dump());
  }
  const json rules = design.value("longest_runs", json::array());
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (rules[i]["factor"] == design["adaptive"]["factor"]) {
      refuse(protocol, item("/design/longest_runs", i) + "/factor",
             "expected a factor whose levels are known beforehand, got " +
                 rules[i]["factor"].dump() + ", which is adaptive");
    }
  }
}

void check_question(const JsonDocument& protocol) {
  if (!protocol.value.contains("yes_no") && !protocol.value.contains("two_interval")) {
    refuse(protocol, "",
           "expected the key \"yes_no\" or \"two_interval\", because adaptive levels follow "
           "answers that are positive or negative, but both are missing");
  }
}

constexpr const char* kQuestPlus = "/design/adaptive/quest_plus/";

std::string number_text_of(const char* format, double number) {
  char text[32];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

void check_staircase(const JsonDocument& protocol, const Staircase& staircase) {
  constexpr double kGuessedOfTwo = 0.5;
  const double share = settling_share(staircase);
  if (protocol.value.contains("two_interval") && share < kGuessedOfTwo + 1e-6) {
    refuse(protocol, "/design/adaptive/staircase",
           "expected a rule that settles above 50 % right answers, which guessing between two "
           "intervals reaches, got " +
               std::to_string(staircase.up) + " up, " + std::to_string(staircase.down) +
               " down, which settles at " + number_text_of("%.1f", 100.0 * share) + " %");
  }
}

/// The levels' place in the file and their values.
struct Levels {
  std::string pointer;
  json as_written;
  std::vector<double> values;
};

Levels adaptive_levels_of(const json& design) {
  for (std::size_t i = 0; i < design["factors"].size(); ++i) {
    const json& factor = design["factors"][i];
    if (factor["name"] == design["adaptive"]["factor"]) {
      return {item("/design/factors", i) + "/levels", factor["levels"],
              factor["levels"].get<std::vector<double>>()};
    }
  }
  return {};
}

/// Levels rise, since the chance of a positive answer rises with them, and are on the scale.
void check_levels_on_scale(const JsonDocument& protocol, const QuestPlus& method,
                           const Levels& levels) {
  if (levels.values.front() > levels.values.back()) {
    refuse(protocol, levels.pointer,
           "expected levels that rise from hard to easy, because the functions of QUEST+ rise "
           "with the level, got " +
               levels.as_written.dump());
  }
  const double least = levels.values.front();
  if (method.scale != QuestPlus::Scale::kLinear && !(least > 0.0)) {
    refuse(
        protocol, item(levels.pointer, 0),
        "expected a level above 0, which has a logarithm, got " + levels.as_written.front().dump());
  }
  if (!is_defined(method.function, method.scale, least, 1.0)) {
    refuse(protocol, item(levels.pointer, 0),
           "expected a level of at least 0, for a Weibull function of the level itself, got " +
               levels.as_written.front().dump());
  }
}

void check_rates(const JsonDocument& protocol, const QuestPlus& method) {
  const json& object = protocol.value["design"]["adaptive"]["quest_plus"];
  for (const char* list : {"guess_rates", "lapse_rates"}) {
    for (std::size_t i = 0; i < object[list].size(); ++i) {
      const double rate = object[list][i].get<double>();
      if (!(rate >= 0.0 && rate < 1.0)) {
        refuse(
            protocol, item(std::string(kQuestPlus) + list, i),
            "expected a probability of at least 0 and less than 1, got " + object[list][i].dump());
      }
    }
  }
  const double guess = *std::max_element(method.guess_rates.begin(), method.guess_rates.end());
  const double lapse = *std::max_element(method.lapse_rates.begin(), method.lapse_rates.end());
  if (guess + lapse >= 1.0) {
    refuse(protocol, std::string(kQuestPlus) + "lapse_rates",
           "expected the largest guess rate and the largest lapse rate to add up to less than 1, "
           "or no level has a higher share of positive answers than another, got " +
               number_text_of("%g", guess) + " and " + number_text_of("%g", lapse));
  }
}

void check_grids(const JsonDocument& protocol, const QuestPlus& method, const Levels& levels) {
  const json& object = protocol.value["design"]["adaptive"]["quest_plus"];
  for (std::size_t i = 0; i < method.slopes.size(); ++i) {
    if (!(method.slopes[i] > 0.0)) {
      refuse(protocol, item(std::string(kQuestPlus) + "slopes", i),
             "expected a number > 0, got " + object["slopes"][i].dump());
    }
  }
  const double least = on_scale(method.scale, levels.values.front());
  const double most = on_scale(method.scale, levels.values.back());
  for (std::size_t i = 0; i < method.thresholds.size(); ++i) {
    const double threshold = method.thresholds[i];
    const std::string place = item(std::string(kQuestPlus) + "thresholds", i);
    const std::string got = ", got " + object["thresholds"][i].dump();
    const double slack = 1e-9 * (most - least);
    if (threshold < least - slack || threshold > most + slack) {
      refuse(protocol, place,
             "expected a threshold that some level can reach, from " + number_text_of("%g", least) +
                 " to " + number_text_of("%g", most) + " on the scale" + got);
    }
    if (!is_defined(method.function, method.scale, 0.0, threshold)) {
      refuse(protocol, place,
             "expected a threshold above 0, for a Weibull function of the level itself" + got);
    }
  }
}

/// Entries of the table that is made before a session, and gone through before every trial.
void check_table_size(const JsonDocument& protocol, const QuestPlus& method, const Levels& levels) {
  constexpr double kMostEntries = 1e6;
  const std::array<std::size_t, 5> sizes{levels.values.size(), method.thresholds.size(),
                                         method.slopes.size(), method.guess_rates.size(),
                                         method.lapse_rates.size()};
  double entries = 1.0;
  for (const std::size_t size : sizes) {
    entries *= static_cast<double>(size);
  }
  if (entries > kMostEntries) {
    refuse(protocol, "/design/adaptive/quest_plus",
           "expected at most 1000000 combinations of the levels and the grids, got " +
               number_text_of("%.15g", entries));
  }
  if (entries == static_cast<double>(levels.values.size())) {
    refuse(protocol, "/design/adaptive/quest_plus",
           "expected grids with at least two psychometric functions to tell apart, got one");
  }
}

}  // namespace

void check_adaptive(const JsonDocument& protocol) {
  if (!protocol.value["design"].contains("adaptive")) {
    return;
  }
  const std::size_t factor = adaptive_factor(protocol);
  check_levels_in_order(protocol, factor);
  check_method(protocol);
  check_starts(protocol, factor);
  check_order(protocol);
  check_question(protocol);
}

void check_thresholds(const JsonDocument& protocol) {
  const json& design = protocol.value["design"];
  if (!design.contains("adaptive")) {
    return;
  }
  const Adaptive adaptive = *design_from(design).adaptive;
  if (const auto* staircase = std::get_if<Staircase>(&adaptive.method)) {
    check_staircase(protocol, *staircase);
    return;
  }
  const auto& method = std::get<QuestPlus>(adaptive.method);
  const Levels levels = adaptive_levels_of(design);
  check_levels_on_scale(protocol, method, levels);
  check_rates(protocol, method);
  check_grids(protocol, method, levels);
  check_table_size(protocol, method, levels);
}

}  // namespace impetus::inline protocol
