// SPDX-License-Identifier: MIT
#include "experiments/protocol/protocol_language.hpp"

#include <string>

#include "experiments/languages/language_file.hpp"
#include "experiments/protocol/checks/participant_checks.hpp"
#include "experiments/record/shown_letters.hpp"
#include "experiments/settings/named_file.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

constexpr const char* kPlace = "/language";
constexpr const char* kEnglish = "en";

std::string shipped_names() {
  std::string names;
  for (const auto& [name, language] : shipped_languages()) {
    names += "\"" + name + "\", ";
  }
  return names;
}

/// The language without the protocol's own texts.
Language named_language(const JsonDocument& protocol) {
  const json name = protocol.value.value("language", json(kEnglish));
  if (name.is_object()) {
    return read_stored_language(protocol, kPlace);
  }
  const auto found = shipped_languages().find(name.get<std::string>());
  if (found == shipped_languages().end()) {
    refuse(
        protocol, kPlace,
        "expected one of " + shipped_names() + "or a file that ends in .json, got " + name.dump());
  }
  return found->second;
}

void add_letters_of_text(std::string_view text, std::set<std::uint16_t>& letters) {
  while (const auto point = text.empty() ? std::nullopt : first_code_point(text)) {
    if (is_wide_letter(point->value) || is_right_to_left_letter(point->value)) {
      letters.insert(static_cast<std::uint16_t>(point->value));
    }
    text.remove_prefix(point->bytes);
  }
}

void add_letters_of_value(const json& value, std::set<std::uint16_t>& letters) {
  if (value.is_string()) {
    add_letters_of_text(value.get_ref<const std::string&>(), letters);
  } else if (value.is_structured()) {
    for (const json& part : value) {
      add_letters_of_value(part, letters);
    }
  }
}

}  // namespace

RowList<Protocol> language_rows() {
  const Form language{{{"type", {"string", "object"}}}};
  return {
      unread<Protocol>(
          "language", language,
          "Of all that participants read and the protocol does not say, keys to press included: "
          "one that comes with the program (ar, de, en, es, fr, pt, zh), or a file of a lab's own, "
          "seen from this one; en when left out."),
      unread<Protocol>(
          "texts", by_name(any_text()),
          "In place of the language's: by the keys of its file. \"\" switches a text off.")};
}

void hold_language(JsonDocument& protocol, const std::filesystem::path& path) {
  if (!protocol.value.is_object() || !protocol.value.contains("language")) {
    return;
  }
  json& language = protocol.value["language"];
  if (language.is_object()) {
    static_cast<void>(read_language(protocol, kPlace));
  }
  if (!language.is_string() || !language.get_ref<const std::string&>().ends_with(".json")) {
    return;
  }
  const JsonDocument file = read_json(named_file(protocol, path, kPlace, "a file with a language"));
  static_cast<void>(read_language(file));
  check_letters(file);
  language = file.value;
  protocol.text = protocol.value.dump();
}

Language language_of(const JsonDocument& protocol) {
  const Language language = named_language(protocol);
  return protocol.value.contains("texts") ? with_texts(language, protocol, "/texts") : language;
}

std::set<std::uint16_t> wide_letters(const Protocol& protocol) {
  std::set<std::uint16_t> letters;
  add_letters_of_value(protocol.document.value, letters);
  for (const std::string& text : protocol.script.language.texts()) {
    add_letters_of_text(text, letters);
  }
  return letters;
}

}  // namespace impetus::inline protocol
