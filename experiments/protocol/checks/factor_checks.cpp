// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/factor_checks.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/factor_values.hpp"
#include "experiments/questions/answer_keys.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline protocol {
namespace {

/// The protocol's question of this key that is answered by keys; null: there is none.
const Question* keyed_question(const Protocol& protocol, const std::string& key) {
  for (const auto& question : protocol.script.asked) {
    if (question->kind().protocol_key == key && question->keyed_answers() > 0) {
      return question.get();
    }
  }
  return nullptr;
}

/// Its levels are the keys of a question that no other factor has: the same keys in all levels, so
/// that each has its side.
void check_key_factor(const Protocol& protocol, const std::string& place, const Factor& factor,
                      std::set<std::string>& taken) {
  const Question* question = keyed_question(protocol, factor.keys_of);
  if (question == nullptr || !taken.insert(factor.keys_of).second) {
    refuse(protocol.document, place + "/keys_of",
           "expected a question of the protocol whose answers have keys (yes_no, two_interval, "
           "choice) and no other factor of keys, got " +
               json_text(factor.keys_of));
  }
  std::vector<std::string> first = keys_of_level(factor.levels.front());
  std::sort(first.begin(), first.end());
  for (std::size_t i = 0; i < factor.levels.size(); ++i) {
    std::vector<std::string> keys = keys_of_level(factor.levels[i]);
    const std::string level = item(place + "/levels", i);
    check_keys(protocol.document, level, keys, question->keyed_answers());
    std::sort(keys.begin(), keys.end());
    if (keys != first) {
      refuse(protocol.document, level,
             "expected the keys of the first level (" + json_text(factor.levels.front()) +
                 ") in another order, got " + json_text(factor.levels[i]));
    }
  }
}

/// The keys by which it says what its levels change.
std::vector<std::string> ways_of(const Factor& factor) {
  std::vector<std::string> ways;
  if (!factor.pointer.empty()) {
    ways.emplace_back("\"pointer\"");
  }
  if (!factor.sets.empty()) {
    ways.emplace_back("\"sets\"");
  }
  if (!factor.keys_of.empty()) {
    ways.emplace_back("\"keys_of\"");
  }
  return ways;
}

/// Whether its levels say when there is adaptation.
bool is_adapted_by(const Protocol& protocol, const std::string& factor) {
  const std::vector<Adaptation>& streams = protocol.design.adaptation;
  return std::any_of(streams.begin(), streams.end(), [&](const Adaptation& stream) {
    return find_level(stream.when, factor) != nullptr;
  });
}

/// Whether a question is chosen by the factor's levels.
bool is_asked_by(const Protocol& protocol, const std::string& factor) {
  const Questions& asked = protocol.script.asked;
  return std::any_of(asked.begin(), asked.end(), [&](const auto& question) {
    const std::vector<std::string> factors = question->asked_by();
    return std::find(factors.begin(), factors.end(), factor) != factors.end();
  });
}

/// Every level is a word with a set of its own, of values that the scene has and no other factor
/// overrides. Further sets are for practice and catch trials.
void check_sets(const Protocol& protocol, const std::string& place, const Factor& factor,
                std::set<std::string>& taken) {
  for (std::size_t i = 0; i < factor.levels.size(); ++i) {
    if (!has_set(factor, factor.levels[i])) {
      refuse(protocol.document, item(place + "/levels", i),
             "expected a word that \"sets\" has, got " + json_text(factor.levels[i]));
    }
  }
  for (const std::string& pointer : overridden_by(factor)) {
    if (!protocol.scene.value.contains(nlohmann::json::json_pointer(pointer))) {
      refuse(protocol.document, place + "/sets",
             "expected pointers to values of " + protocol.scene.name + ", got \"" + pointer + "\"");
    }
    if (!taken.insert(pointer).second) {
      refuse(protocol.document, place + "/sets",
             "expected values that no other factor overrides, got \"" + pointer + "\" again");
    }
  }
}

/// A level that the scene has put in the place of null may be another one again.
void check_levels_differ(const Protocol& protocol, const std::string& place, const Factor& factor) {
  for (auto level = factor.levels.begin(); level != factor.levels.end(); ++level) {
    if (std::find(factor.levels.begin(), level, *level) != level) {
      refuse(protocol.document, place + "/levels",
             "expected levels that differ, but null is the scene's own value: " +
                 list_text(factor.levels));
    }
  }
}

}  // namespace

void check_factors(const Protocol& protocol) {
  std::set<std::string> names;
  std::set<std::string> pointers;
  for (std::size_t i = 0; i < protocol.design.factors.size(); ++i) {
    const Factor& factor = protocol.design.factors[i];
    const std::string place = item("/design/factors", i);
    if (!names.insert(factor.name).second) {
      refuse(protocol.document, place + "/name",
             "expected a name of its own, got " + json_text(factor.name) + " again");
    }
    const std::vector<std::string> said = ways_of(factor);
    if (said.size() > 1) {
      refuse(protocol.document, place,
             "expected either " + said[0] + " or " + said[1] + ", got both");
    }
    if (said.empty() &&
        (is_asked_by(protocol, factor.name) || is_adapted_by(protocol, factor.name))) {
      continue;
    }
    if (said.empty()) {
      refuse(protocol.document, place, "expected the key \"pointer\", which is missing");
    }
    if (!factor.sets.empty()) {
      check_sets(protocol, place, factor, pointers);
      continue;
    }
    if (!factor.keys_of.empty()) {
      check_key_factor(protocol, place, factor, pointers);
      continue;
    }
    if (!pointers.insert(factor.pointer).second) {
      refuse(
          protocol.document, place + "/pointer",
          "expected a value that no other factor overrides, got \"" + factor.pointer + "\" again");
    }
    if (!names_single_value(protocol.scene.value, factor.pointer)) {
      refuse(protocol.document, place + "/pointer",
             "expected a pointer to a single value of " + protocol.scene.name + ", got \"" +
                 factor.pointer + "\"");
    }
    check_levels_differ(protocol, place, factor);
  }
}

}  // namespace impetus::inline protocol
