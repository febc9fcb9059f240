// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/sense_checks.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "experiments/design/between_participants.hpp"
#include "experiments/protocol/factor_values.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline protocol {
namespace {

/// No factor overrides a part of what another one does: the later would undo the earlier.
void check_overlaps(const Protocol& protocol) {
  const std::vector<Factor>& factors = protocol.design.factors;
  std::vector<std::string> taken;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const std::vector<std::string> own = overridden_by(factors[i]);
    for (const std::string& pointer : own) {
      for (const std::string& other : taken) {
        if (pointer.starts_with(other + "/") || other.starts_with(pointer + "/")) {
          refuse(protocol.document, item("/design/factors", i),
                 "expected values that no other factor overrides, got \"" + pointer +
                     "\" beside \"" + other + "\"");
        }
      }
    }
    taken.insert(taken.end(), own.begin(), own.end());
  }
}

/// A level beside the factor's own is one that it knows, where it puts no number into the scene.
void require_known(const Protocol& protocol, const std::string& place, const FactorLevel& level) {
  const Factor& factor = *find_factor(protocol.design, level.factor);
  if (!factor.sets.empty() && !has_set(factor, level.value)) {
    refuse(protocol.document, place + "/" + level.factor,
           "expected a word that \"sets\" has, got " + json_text(level.value));
  }
  if (overridden_by(factor).empty() && !has_level(factor, level.value)) {
    refuse(protocol.document, place + "/" + level.factor,
           "expected one of the factor's levels " + list_text(factor.levels) + ", got " +
               json_text(level.value));
  }
}

void check_levels_beside(const Protocol& protocol) {
  for (const ConditionBeside& beside : conditions_beside(protocol.design)) {
    for (const FactorLevel& level : beside.condition) {
      require_known(protocol, beside.place, level);
    }
  }
}

/// A block's keys are those of its answers, unless a factor says them for each trial.
void check_question_blocks(const Protocol& protocol) {
  for (const auto& question : protocol.script.asked) {
    question->check_sense(protocol.document, protocol.design);
    const std::string block = question->kind().protocol_key;
    for (const Factor& factor : protocol.design.factors) {
      if (factor.keys_of == block && !question->keys().empty()) {
        refuse(protocol.document, "/" + block + "/keys",
               "expected none beside the factor \"" + factor.name +
                   "\", whose levels are the keys, got " +
                   protocol.document.value[block]["keys"].dump());
      }
    }
  }
}

/// The standard can look otherwise than the test.
void check_standard_changes(const Protocol& protocol) {
  const TwoIntervalQuestion* question = find_two_interval(protocol.script);
  if (question == nullptr) {
    return;
  }
  const std::string place = "/two_interval/standard";
  const Condition& standard = question->standard_levels();
  for (const FactorLevel& level : standard) {
    require_known(protocol, place, level);
  }
  if (std::all_of(standard.begin(), standard.end(), [&](const FactorLevel& level) {
        return overridden_by(*find_factor(protocol.design, level.factor)).empty();
      })) {
    refuse(protocol.document, place,
           "expected a level that changes the scene, or both intervals show the same, got " +
               to_json(standard).dump());
  }
}

/// QUEST+ expects as many right answers as guessing reaches, or its thresholds would be far off.
void check_guess_rates(const Protocol& protocol) {
  const std::optional<Adaptive>& adaptive = protocol.design.adaptive;
  const auto* method = adaptive ? std::get_if<QuestPlus>(&adaptive->method) : nullptr;
  if (method == nullptr) {
    return;
  }
  const double least = *std::min_element(method->guess_rates.begin(), method->guess_rates.end());
  for (const auto& question : protocol.script.asked) {
    const ResponseKind& kind = question->kind();
    if (least < kind.guessed_share) {
      refuse(protocol.document, "/design/adaptive/quest_plus/guess_rates",
             "expected rates of at least " + printed("%g", kind.guessed_share) +
                 ", which guessing " + kind.guessing + " reaches, got " + printed("%g", least));
    }
  }
}

/// Training goes through all that there is to train with.
void check_training_reach(const Protocol& protocol) {
  const auto practice = static_cast<std::int64_t>(protocol.design.practice.size());
  if (protocol.script.training_rule && protocol.script.training_rule->most_trials < practice) {
    refuse(protocol.document, "/design/train_until/most_trials",
           "expected at least the " + count_of(practice, "trial") + " of practice, got " +
               std::to_string(protocol.script.training_rule->most_trials));
  }
}

/// Options are of a field that is chosen from, a least and a most of one for a number.
void check_fields(const Protocol& protocol) {
  const std::vector<Field>& fields = protocol.script.demographics;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const JsonDocument& document = protocol.document;
    const std::string place = item("/session/demographics", i);
    for (const auto& [key, kind] :
         {std::pair("options", Field::Kind::kChoice), std::pair("minimum", Field::Kind::kNumber),
          std::pair("maximum", Field::Kind::kNumber)}) {
      if (fields[i].kind != kind &&
          document.value.at(nlohmann::json::json_pointer(place)).contains(key)) {
        refuse(document, place + "/" + key,
               std::string("expected none, for the field is no ") +
                   (kind == Field::Kind::kChoice ? "choice" : "number"));
      }
    }
  }
}

/// What of one scene cannot be meant; "": nothing.
std::string nonsense_of(const Scene& scene) {
  if (scene.meeting && scene.intended_hold_s() > 0.0 &&
      std::any_of(scene.bodies->begin(), scene.bodies->end(),
                  [](const BodySettings& body) { return body.passes_through; })) {
    return "expected a contact_hold_ms of 0 where a body passes through, which no contact holds, "
           "got " +
           printed("%g", 1e3 * scene.intended_hold_s());
  }
  if (!scene.sound) {
    return "";
  }
  const std::optional<double> at_s = scene.sound->at_s;
  const double lasting_s = scene.lasting_s(scene.intended_hold_s());
  if (at_s && *at_s > lasting_s) {
    return "expected a sound's at_s of at most the " + printed("%g", lasting_s) +
           " s that the scene lasts, got " + printed("%g", *at_s);
  }
  const bool is_known = at_s || scene.meeting_s() > 0.0;
  const double onset_s = at_s ? *at_s : scene.showing.still_s + scene.meeting_s();
  if (is_known && 1e3 * onset_s + scene.sound->lag_ms < 0.0) {
    return "expected a sound's lag_ms of at least " + printed("%g", -1e3 * onset_s) +
           ", or it would come before the stimulus, got " + printed("%g", scene.sound->lag_ms);
  }
  return "";
}

void check_scenes_sense(const Protocol& protocol) {
  const auto check = [&](const std::string& place, const Condition& condition) {
    const std::string nonsense = nonsense_of(Scene(scene_under(protocol, condition)));
    if (!nonsense.empty()) {
      const std::string where = condition.empty() ? "" : " under " + to_json(condition).dump();
      refuse(protocol.document, place, nonsense + where);
    }
  };
  for (const Condition& cell : cells(protocol.design)) {
    check("/design/factors", cell);
  }
  for (const ConditionBeside& beside : conditions_beside(protocol.design)) {
    for (const Condition& condition : in_every_group(beside.condition, protocol.design)) {
      check(beside.place, condition);
    }
  }
}

}  // namespace

void check_sense(const Protocol& protocol) {
  check_question_blocks(protocol);
  check_overlaps(protocol);
  check_levels_beside(protocol);
  check_standard_changes(protocol);
  check_guess_rates(protocol);
  check_training_reach(protocol);
  check_fields(protocol);
  check_scenes_sense(protocol);
}

}  // namespace impetus::inline protocol
