// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/adaptive_checks.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

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

}  // namespace impetus::inline protocol
