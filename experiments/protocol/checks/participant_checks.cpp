// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/participant_checks.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/questions/rating.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/record/shown_letters.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/settings/schema_sentences.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

/// The letters in which a document may be written, and how messages call them.
struct Letters {
  bool wide{false};

  [[nodiscard]] bool has(std::uint32_t code) const {
    return is_shown_letter(code) || is_right_to_left_letter(code) ||
           (wide && is_wide_letter(code)) || code == '\n' || code == '\r' || code == '\t';
  }
  [[nodiscard]] std::string words() const {
    return wide ? "Latin, Greek, Cyrillic, Hebrew, Arabic, Chinese, Japanese, Korean, signs"
                : "Latin, Greek, Cyrillic, Hebrew, Arabic, signs";
  }
};

bool has_wide_letter(std::string_view text) {
  while (const auto point = text.empty() ? std::nullopt : first_code_point(text)) {
    if (is_wide_letter(point->value)) {
      return true;
    }
    text.remove_prefix(point->bytes);
  }
  return false;
}

Letters letters_of(const Language& language) {
  return {std::any_of(language.texts().begin(), language.texts().end(), has_wide_letter)};
}

void check_text(const JsonDocument& protocol, const json::json_pointer& place,
                std::string_view text, const Letters& letters) {
  for (int letter = 1; !text.empty(); ++letter) {
    const auto point = first_code_point(text);
    if (!point) {
      return;  // the parser takes UTF-8 alone
    }
    if (!letters.has(point->value)) {
      const std::string code = printed("U+%04X", static_cast<unsigned>(point->value));
      refuse(protocol, place.to_string(),
             "expected letters that screens can show (" + letters.words() + "), got " + code +
                 " as character " + std::to_string(letter));
    }
    text.remove_prefix(point->bytes);
  }
}

/// All texts of a part of the protocol but values of the scene, which nobody reads.
void check_texts_in(const JsonDocument& protocol, const json::json_pointer& place,
                    const json& value, const Letters& letters) {
  const std::set<std::string> values_of_scene{"set", "standard"};
  if (value.is_string()) {
    check_text(protocol, place, value.get_ref<const std::string&>(), letters);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      check_texts_in(protocol, place / i, value[i], letters);
    }
  } else if (value.is_object()) {
    for (auto entry = value.begin(); entry != value.end(); ++entry) {
      if (values_of_scene.count(entry.key()) == 0) {
        check_texts_in(protocol, place / entry.key(), entry.value(), letters);
      }
    }
  }
}

}  // namespace

void check_participants(const Protocol& protocol) {
  const JsonDocument& document = protocol.document;
  if (protocol.has_participants) {
    for (const char* key : {"timing", "session"}) {
      if (!document.value.contains(key)) {
        refuse(document, "", "expected the key \"" + std::string(key) + "\", which is missing");
      }
    }
    return;
  }
  std::vector<std::string> keys{"/timing", "/session"};
  for (const ResponseKind& kind : listed_kinds()) {
    keys.push_back("/" + kind.protocol_key);
  }
  for (std::size_t i = 0; i < protocol.design.factors.size(); ++i) {
    keys.push_back(item("/design/factors", i) + "/between");
    keys.push_back(item("/design/factors", i) + "/keys_of");
  }
  keys.insert(keys.end(), {"/gaze", "/question_order", "/design/practice", "/design/practice_until",
                           "/design/train_until", "/design/adaptive", "/exclude_when"});
  for (const std::string& key : keys) {
    if (document.value.contains(json::json_pointer(key))) {
      refuse(document, key, "expected none where nobody takes part");
    }
  }
}

void check_texts(const Protocol& protocol) {
  const JsonDocument& document = protocol.document;
  std::vector<std::string> parts{"session", "language", "texts"};
  for (const ResponseKind& kind : listed_kinds()) {
    parts.push_back(kind.protocol_key);
  }
  for (const std::string& part : parts) {
    if (document.value.contains(part)) {
      check_texts_in(document, json::json_pointer() / part, document.value[part],
                     letters_of(protocol.script.language));
    }
  }
}

void check_letters(const JsonDocument& language) {
  check_texts_in(language, json::json_pointer(), language.value, Letters{/*wide=*/true});
}

void check_responses(const Protocol& protocol) {
  const Script& script = protocol.script;
  if (protocol.has_participants && script.asked.empty()) {
    refuse(protocol.document, "",
           "expected something that participants answer, a key " +
               list_keys([](const ResponseKind&) { return true; }) + ", but there is none");
  }
  for (const auto& question : script.asked) {
    question->check_in_design(protocol.document, protocol.design);
  }
  if (script.practice_rule && find_scale(script) == nullptr) {
    refuse(protocol.document, "/design/practice_until",
           "expected the key \"rating\" in the protocol, because the best level must be rated "
           "better than the worst, but it is missing");
  }
}

void check_training(const Protocol& protocol) {
  const std::string place = "/design/train_until";
  if (!protocol.script.training_rule) {
    return;
  }
  if (protocol.script.practice_rule) {
    refuse(protocol.document, place, "expected either this or practice_until, but both are there");
  }
  if (!has_right_answers(protocol.script)) {
    refuse(protocol.document, place,
           "expected a question that has a right answer (yes_no or choice with right_when, or "
           "two_interval), but there is none");
  }
  if (protocol.design.practice.empty()) {
    refuse(protocol.document, place,
           "expected conditions to train with in /design/practice, but there are none");
  }
}

void check_standard(const Protocol& protocol) {
  const TwoIntervalQuestion* question = find_two_interval(protocol.script);
  if (question == nullptr) {
    return;
  }
  const std::string place = "/two_interval/standard";
  const auto place_of = [&](const FactorLevel& level) { return place + "/" + level.factor; };
  for (const FactorLevel& level : question->standard_levels()) {
    require_level_in_schema(protocol, level, place_of(level));
  }
  for (const Condition& cell : cells(protocol.design)) {
    const Condition standard = question->standard(cell);
    const json scene = scene_under(protocol, standard);
    const auto problems = scene_problems(scene, *protocol.shapes);
    if (!problems.empty()) {
      refuse_fault(protocol, question->standard_levels(), place_of, problems.front().message);
      refuse(protocol.document, place,
             problems.front().pointer + " of the scene under " + to_json(standard).dump() + ": " +
                 problems.front().message);
    }
    if (depends_on_gaze(scene["engine"]) && !protocol.script.gaze) {
      refuse(protocol.document, place,
             "expected the key \"gaze\" in the protocol, because the detail of collisions depends "
             "on the gaze under " +
                 to_json(standard).dump() + ", but it is missing");
    }
  }
}

}  // namespace impetus::inline protocol
