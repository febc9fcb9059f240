// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/participant_checks.hpp"

#include <cstdio>
#include <string>
#include <string_view>

#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/design_reading.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/record/shown_letters.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/settings/schema_check.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

// ---------------------------------------------------------------- words

bool is_shown(std::uint32_t code) {
  return is_shown_letter(code) || code == '\n' || code == '\r' || code == '\t';
}

void check_text(const JsonDocument& protocol, const json::json_pointer& place,
                std::string_view text) {
  for (int letter = 1; !text.empty(); ++letter) {
    const auto point = first_code_point(text);
    if (!point) {
      return;  // the parser takes UTF-8 alone
    }
    if (!is_shown(point->value)) {
      char code[16];
      std::snprintf(code, sizeof code, "U+%04X", static_cast<unsigned>(point->value));
      refuse(protocol, place.to_string(),
             std::string("expected letters that screens can show (Latin, Greek, Cyrillic, signs), "
                         "got ") +
                 code + " as character " + std::to_string(letter));
    }
    text.remove_prefix(point->bytes);
  }
}

/// All texts of a part of the protocol but those under `settings`: values of the scene, which
/// nobody reads.
void check_texts_in(const JsonDocument& protocol, const json::json_pointer& place,
                    const json& value, const std::string& settings) {
  if (value.is_string()) {
    check_text(protocol, place, value.get_ref<const std::string&>());
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      check_texts_in(protocol, place / i, value[i], settings);
    }
  } else if (value.is_object()) {
    for (auto entry = value.begin(); entry != value.end(); ++entry) {
      if (entry.key() != settings) {
        check_texts_in(protocol, place / entry.key(), entry.value(), settings);
      }
    }
  }
}

void check_texts_of(const JsonDocument& protocol, const std::string& part,
                    const std::string& settings) {
  if (protocol.value.contains(part)) {
    check_texts_in(protocol, json::json_pointer() / part, protocol.value[part], settings);
  }
}

// ---------------------------------------------------------------- questions

/// `"rating", "yes_no" or "clicks"`: the keys of all kinds.
std::string keys_of_kinds() {
  std::string keys;
  for (const ResponseKind& kind : listed_kinds()) {
    const bool last = &kind == &listed_kinds().back().get();
    keys += (keys.empty() ? "\"" : last ? " or \"" : ", \"") + kind.protocol_key + "\"";
  }
  return keys;
}

void check_practice_rating(const JsonDocument& protocol) {
  if (protocol.value["design"].contains("practice_until") && !protocol.value.contains("rating")) {
    refuse(protocol, "/design/practice_until",
           "expected the key \"rating\" in the protocol, because the best level must be rated "
           "better than the worst, but it is missing");
  }
}

}  // namespace

bool has_participants(const json& protocol) { return !protocol.contains("participants"); }

void check_participants(const JsonDocument& protocol) {
  const auto refuse_key = [&](const std::string& pointer) {
    if (protocol.value.contains(json::json_pointer(pointer))) {
      refuse(protocol, pointer, "expected none where nobody takes part");
    }
  };
  if (has_participants(protocol.value)) {
    for (const char* key : {"timing", "session"}) {
      if (!protocol.value.contains(key)) {
        refuse(protocol, "", "expected the key \"" + std::string(key) + "\", which is missing");
      }
    }
    return;
  }
  refuse_key("/timing");
  refuse_key("/session");
  for (const ResponseKind& kind : listed_kinds()) {
    refuse_key("/" + kind.protocol_key);
  }
  refuse_key("/gaze");
  for (const char* key : {"practice", "practice_until", "train_until", "adaptive"}) {
    refuse_key("/design/" + std::string(key));
  }
}

void check_texts(const JsonDocument& protocol) {
  check_texts_of(protocol, "session", "set");
  for (const ResponseKind& kind : listed_kinds()) {
    std::string settings;
    for (const DeclaredValue& parameter : kind.parameters) {
      settings = parameter.levels ? parameter.name : settings;
    }
    check_texts_of(protocol, kind.protocol_key, settings);
  }
}

void check_responses(const JsonDocument& protocol) {
  if (has_participants(protocol.value) && read_questions(protocol.value).empty()) {
    refuse(protocol, "",
           "expected something that participants answer, a key " + keys_of_kinds() +
               ", but there is none");
  }
  check_questions_in_design(protocol);
  check_practice_rating(protocol);
}

void check_training(const Protocol& protocol) {
  const JsonDocument& document = protocol.document;
  const json& design = document.value["design"];
  if (!design.contains("train_until")) {
    return;
  }
  if (design.contains("practice_until")) {
    refuse(document, "/design/train_until",
           "expected either this or practice_until, but both are there");
  }
  if (!has_right_answers(protocol.script)) {
    refuse(document, "/design/train_until",
           "expected a question that has a right answer (yes_no with right_when, or two_interval), "
           "but there is none");
  }
  if (design.value("practice", json::array()).empty()) {
    refuse(document, "/design/train_until",
           "expected conditions to train with in /design/practice, but there are none");
  }
}

void check_standard(const Protocol& protocol) {
  const TwoIntervalQuestion* question = find_two_interval(protocol.script);
  if (question == nullptr) {
    return;
  }
  const std::string place = "/two_interval/standard";
  for (const FactorLevel& level : question->standard_levels()) {
    const std::string message = complaint(scene_under(protocol, {level}));
    if (!message.empty()) {
      refuse(protocol.document, place + "/" + level.factor, message);
    }
  }
  for (const Condition& cell : cells(protocol.design)) {
    const Condition standard = question->standard(cell);
    const json scene = scene_under(protocol, standard);
    const auto problems = scene_problems(scene);
    if (!problems.empty()) {
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
