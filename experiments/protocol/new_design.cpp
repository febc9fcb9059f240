// SPDX-License-Identifier: MIT
#include "experiments/protocol/new_design.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline protocol {
namespace {

constexpr double kTrials = 60.0;  ///< of a study, about
constexpr int kTrialsPerTrack = 40;
constexpr std::size_t kLeastChosenFrom = 4;

OrderedJson number_of(double number) {
  const bool whole = std::floor(number) == number && std::abs(number) < 1e15;
  return whole ? OrderedJson(static_cast<std::int64_t>(number)) : OrderedJson(number);
}

/// A number, true, false, or a word.
OrderedJson level_from(const std::string& text) {
  if (text == "true" || text == "false") {
    return text == "true";
  }
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end != '\0' || !std::isfinite(number)) {
    return text;
  }
  return number_of(number);
}

OrderedJson levels_from(const std::string& words) {
  OrderedJson levels = OrderedJson::array();
  for (std::size_t begin = 0; begin <= words.size();) {
    const std::size_t end = std::min(words.find(',', begin), words.size());
    levels.push_back(level_from(words.substr(begin, end - begin)));
    begin = end + 1;
  }
  return levels;
}

/// "/crowd/spin_deg_s" as spin_deg_s
std::string last_token(const std::string& pointer) {
  return pointer.substr(pointer.rfind('/') + 1);
}

/// A factor of the design, of one --vary.
OrderedJson factor_from(const std::string& vary, const OrderedJson& offered, bool fine) {
  const std::size_t equals = std::min(vary.find('='), vary.size());
  const std::string name = vary.substr(0, equals);
  OrderedJson factor;
  if (name.rfind('/', 0) == 0) {
    factor = {{"name", last_token(name)}, {"label", last_token(name)}, {"pointer", name}};
  } else if (offered.contains(name)) {
    factor = {{"name", name}};
    factor.update(offered[name]);
  } else {
    throw InputError("--vary: expected one of " + key_list(offered) +
                     ", or a JSON Pointer into the scene, got " + name);
  }
  if (fine && factor.contains("fine_levels")) {
    factor["levels"] = factor["fine_levels"];
  }
  factor.erase("fine_levels");
  if (equals < vary.size()) {
    factor["levels"] = levels_from(vary.substr(equals + 1));
  }
  if (!factor.contains("levels") || factor["levels"].size() < 2) {
    throw InputError("--vary: expected " + name + "= and two levels or more, got " + vary);
  }
  const OrderedJson& levels = factor["levels"];
  if (std::any_of(levels.begin(), levels.end(), [&](const OrderedJson& level) {
        return level == "" || level.is_number() != levels.front().is_number();
      })) {
    throw InputError("--vary: expected levels of " + name +
                     " that are all numbers or all words, got " + vary);
  }
  return factor;
}

/// The condition in which every factor has its first level, or its last.
OrderedJson end_condition(const OrderedJson& factors, bool last) {
  OrderedJson condition = OrderedJson::object();
  for (const OrderedJson& factor : factors) {
    const OrderedJson& levels = factor["levels"];
    condition[factor["name"].get<std::string>()] = last ? levels.back() : levels.front();
  }
  return condition;
}

/// Refuses levels that are no scale from hard to easy: from the natural one away.
void require_scale(const OrderedJson& factor, const OrderedJson& natural) {
  const OrderedJson& levels = factor["levels"];
  const bool numbers = std::all_of(levels.begin(), levels.end(),
                                   [](const OrderedJson& level) { return level.is_number(); });
  if (levels.size() < kLeastChosenFrom || !numbers ||
      !std::is_sorted(levels.begin(), levels.end())) {
    throw InputError("--levels: to choose from, expected four numbers or more of " +
                     factor["name"].get<std::string>() + ", rising from hard to easy, got " +
                     levels.dump());
  }
  if (levels.front() != natural) {
    throw InputError("--levels: to choose from, expected levels of " +
                     factor["name"].get<std::string>() +
                     " that rise from the most natural, of these " + natural.dump() +
                     ", next to the scene's own, got " + levels.dump());
  }
}

OrderedJson staircase_of(const OrderedJson& levels, bool two_intervals) {
  return {{"up", 1},
          {"down", two_intervals ? 3 : 2},
          {"steps", {2, 1}},
          {"starts", {levels.back(), levels[levels.size() / 2]}}};
}

OrderedJson quest_plus_of(const OrderedJson& levels, bool two_intervals) {
  constexpr int kThresholds = 25;
  const auto least = levels.front().get<double>();
  const double range = levels.back().get<double>() - least;
  OrderedJson thresholds = OrderedJson::array();
  for (int step = 0; step < kThresholds; ++step) {
    thresholds.push_back(short_number(least + range * step / (kThresholds - 1)));
  }
  OrderedJson slopes = OrderedJson::array();
  for (const double share : {0.0625, 0.125, 0.25}) {
    slopes.push_back(short_number(range * share));
  }
  const OrderedJson guesses = two_intervals ? OrderedJson{0.5} : OrderedJson{0.02, 0.1};
  return {{"function", "normal"},     {"scale", "linear"},
          {"thresholds", thresholds}, {"slopes", slopes},
          {"guess_rates", guesses},   {"lapse_rates", OrderedJson::array({0.02})}};
}

OrderedJson adaptive_of(const OrderedJson& factor, const AskedDesign& asked) {
  require_scale(factor, asked.natural);
  OrderedJson adaptive{{"factor", factor["name"]}, {"trials_per_track", kTrialsPerTrack}};
  if (asked.choice == LevelChoice::kStaircase) {
    adaptive["staircase"] = staircase_of(factor["levels"], asked.two_intervals);
  } else {
    adaptive["quest_plus"] = quest_plus_of(factor["levels"], asked.two_intervals);
  }
  return adaptive;
}

}  // namespace

OrderedJson short_number(double number) { return number_of(std::round(number * 1e6) / 1e6); }

std::string key_list(const OrderedJson& object) {
  return listed(object.items(), [](const auto& each) { return each.key(); });
}

LevelChoice level_choice(const std::string& name) {
  for (const auto& [known, choice] : {std::pair("all", LevelChoice::kAll),
                                      {"staircase", LevelChoice::kStaircase},
                                      {"quest", LevelChoice::kQuestPlus}}) {
    if (name == known) {
      return choice;
    }
  }
  throw InputError("--levels: expected all, staircase or quest, got " + name);
}

OrderedJson factors_from(const std::vector<std::string>& vary, const OrderedJson& offered,
                         LevelChoice choice) {
  OrderedJson factors = OrderedJson::array();
  const std::vector<std::string> first{offered.begin().key()};
  for (const std::string& each : vary.empty() ? first : vary) {
    factors.push_back(factor_from(each, offered, choice != LevelChoice::kAll && factors.empty()));
  }
  return factors;
}

OrderedJson natural_level(const OrderedJson& factor, const OrderedJson& scene) {
  const OrderedJson& levels = factor["levels"];
  if (levels.front().is_string()) {
    return levels.front();  // words are offered from the best on
  }
  const OrderedJson::json_pointer place(factor.value("pointer", std::string()));
  const OrderedJson own = scene.contains(place) ? scene.at(place) : OrderedJson();
  const auto distance = [&](const OrderedJson& level) {
    return level.is_number() && own.is_number() ? std::abs(level.get<double>() - own.get<double>())
                                                : (level == own ? 0.0 : 1.0);
  };
  return *std::min_element(levels.begin(), levels.end(), [&](const auto& one, const auto& other) {
    return distance(one) < distance(other);
  });
}

OrderedJson design_of(const OrderedJson& factors, const AskedDesign& asked) {
  double cells = 1.0;
  for (const OrderedJson& factor : factors) {
    cells *= static_cast<double>(factor["levels"].size());
  }
  const auto repetitions = asked.choice == LevelChoice::kAll
                               ? std::max<std::int64_t>(2, std::llround(kTrials / cells))
                               : 1;
  OrderedJson practice = OrderedJson::array();
  for (const bool last : {false, true}) {
    OrderedJson condition = end_condition(factors, last);
    if (!asked.two_intervals || condition.front() != asked.natural) {
      practice.push_back(std::move(condition));
    }
  }
  OrderedJson design{
      {"factors", factors}, {"repetitions", repetitions}, {"practice", std::move(practice)}};
  if (asked.choice != LevelChoice::kAll) {
    design["adaptive"] = adaptive_of(factors.front(), asked);
  }
  return design;
}

}  // namespace impetus::inline protocol
