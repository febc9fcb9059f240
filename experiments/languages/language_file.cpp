// SPDX-License-Identifier: MIT
#include "experiments/languages/language_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "experiments/languages/embedded_languages.hpp"
#include "experiments/settings/schema_sentences.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline languages {
namespace {

using nlohmann::json;

std::string shown(const std::string& words) { return json(words).dump(); }

/// What a language file says.
struct LanguageFile {
  std::string title;
  std::map<std::string, std::string> texts;
};

const Kind<LanguageFile>& language_kind() {
  using L = LanguageFile;
  static const Kind<L> kind =
      object<L>("", rows_of_file<L>({required("texts", &L::texts, by_name(any_text()))},
                                    {required("title", &L::title, text())}));
  return kind;
}

/// A text that is to stand in a row, and where it came from.
class Candidate {
 public:
  /// `english` is the row's text in English; "": this is English itself.
  Candidate(const JsonDocument& document, std::string place, const TextRow& row,
            const std::string& english, const std::string& words)
      : document_(document),
        place_(std::move(place)),
        row_(row),
        english_(english),
        words_(words) {}

  void require_sound() const {
    if (row_.use == TextUse::kKey) {
      require_key();
    }
    for (const std::string& name : placeholders(words_)) {
      require_known(name);
    }
    for (const std::string& name : placeholders(english_)) {
      require_kept(name);
    }
  }

 private:
  void require_key() const {
    if (words_.size() != 1 || words_[0] < 'a' || words_[0] > 'z') {
      refuse(document_, place_, "expected a key, one letter from a to z, got " + shown(words_));
    }
  }

  void require_known(const std::string& name) const {
    if (!english_.empty() && !has(english_, name)) {
      refuse(document_, place_,
             "expected only what " + shown(english_) + " has in braces, got " +
                 shown("{" + name + "}"));
    }
  }

  void require_kept(const std::string& name) const {
    const bool is_one = name == "count" && row_.key.ends_with("_one");
    if (!is_one && !has(words_, name)) {
      refuse(document_, place_,
             "expected {" + name + "} in it, as in " + shown(english_) + ", got " + shown(words_));
    }
  }

  static bool has(const std::string& text, const std::string& name) {
    return text.find("{" + name + "}") != std::string::npos;
  }

  const JsonDocument& document_;
  std::string place_;
  const TextRow& row_;
  const std::string& english_;
  const std::string& words_;
};

/// Keys that are pressed on one page, of which each must mean one thing.
constexpr std::array<std::array<TextKey, 2>, 5> kKeysOfAPage{{{"agree_key", "decline_key"},
                                                              {"agree_key", "back_key"},
                                                              {"decline_key", "back_key"},
                                                              {"yes_key", "no_key"},
                                                              {"go_on_key", "stop_key"}}};

void require_different_keys(const JsonDocument& document, const std::string& place,
                            const std::vector<std::string>& texts) {
  for (const auto& [one, other] : kKeysOfAPage) {
    const std::string& key = texts[other.place()];
    if (texts[one.place()] == key) {
      refuse(document, place + "/" + std::string(kTextRows[other.place()].key),
             "expected another key than that of " + shown(std::string(kTextRows[one.place()].key)) +
                 ", got " + shown(key));
    }
  }
}

std::size_t known_text(const JsonDocument& document, const std::string& place,
                       const std::string& key) {
  const std::size_t row = find_text(key);
  if (row == kTextRows.size()) {
    refuse(document, place,
           "expected the key of a text that participants see, such as \"continue\", got " +
               shown(key));
  }
  return row;
}

/// Whether a language has all texts of this build.
enum class Missing { kRefused, kInEnglish };

/// `english`: empty for English itself.
Language read_beside(const std::vector<std::string>& english, const JsonDocument& document,
                     const std::string& place, Missing missing) {
  static const json schema = file_schema("", "", language_kind());
  const json& value = document.value.at(json::json_pointer(place));
  if (const auto problem = find_schema_problem(schema, value)) {
    refuse(document, place + problem->pointer, problem->message);
  }
  const LanguageFile file = language_kind().read(value);
  const std::string list = place + "/texts";
  for (const auto& [key, words] : file.texts) {
    known_text(document, list + "/" + key, key);
  }
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < kTextRows.size(); ++i) {
    const std::string key(kTextRows[i].key);
    const std::string in_english = english.empty() ? "" : english[i];
    const auto found = file.texts.find(key);
    if (found == file.texts.end() && missing == Missing::kInEnglish) {
      texts.push_back(in_english);
      continue;
    }
    if (found == file.texts.end() || found->second.empty()) {
      refuse(document, list,
             "expected a text for \"" + key + "\" (" + shown(in_english) +
                 " in English), which is missing");
    }
    Candidate(document, list + "/" + key, kTextRows[i], in_english, found->second).require_sound();
    texts.push_back(found->second);
  }
  require_different_keys(document, list, texts);
  return {file.title, texts};
}

std::map<std::string, Language> read_shipped() {
  std::map<std::string, Language> languages;
  for (const EmbeddedFile& file : kLanguageFiles) {
    const std::string name = std::filesystem::path(file.name).stem().string();
    languages.emplace(name,
                      name == "en" ? english() : read_language(parse_json(file.name, file.text)));
  }
  return languages;
}

Language read_english() {
  const auto* const file =
      std::find_if(std::begin(kLanguageFiles), std::end(kLanguageFiles),
                   [](const EmbeddedFile& each) { return std::string(each.name) == "en.json"; });
  return read_beside({}, parse_json(file->name, file->text), "", Missing::kRefused);
}

}  // namespace

const Language& english() {
  static const Language language = read_english();
  return language;
}

const std::map<std::string, Language>& shipped_languages() {
  static const std::map<std::string, Language> languages = read_shipped();
  return languages;
}

Language read_language(const JsonDocument& document, const std::string& place) {
  return read_beside(english().texts(), document, place, Missing::kRefused);
}

Language read_stored_language(const JsonDocument& document, const std::string& place) {
  return read_beside(english().texts(), document, place, Missing::kInEnglish);
}

Language with_texts(const Language& language, const JsonDocument& document,
                    const std::string& place) {
  std::vector<std::string> texts = language.texts();
  for (const auto& [key, value] : document.value.at(json::json_pointer(place)).items()) {
    const std::string here = place + "/" + key;
    const std::size_t row = known_text(document, here, key);
    const auto words = value.get<std::string>();
    if (!words.empty()) {
      Candidate(document, here, kTextRows[row], english().texts()[row], words).require_sound();
    } else if (kTextRows[row].use != TextUse::kWords) {
      refuse(document, here,
             "expected a text that is not empty: what has a name or a key cannot be without it, "
             "got \"\"");
    }
    texts[row] = words;
  }
  require_different_keys(document, place, texts);
  return {language.title(), texts};
}

}  // namespace impetus::inline languages
