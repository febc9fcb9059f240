// The languages that come with the program, a lab's own, and single texts in a protocol.
// SPDX-License-Identifier: MIT
#include "experiments/languages/language_file.hpp"
#include "experiments/files/protocol_files.hpp"

#include <regex>
#include <set>

#include "experiments/protocol/checks/participant_checks.hpp"
#include "experiments/protocol/protocol_language.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::language_file_test {

const std::set<std::string> kShipped{"ar", "de", "en", "es", "fr", "pt", "zh"};

json shipped_language(const std::string& name) {
  return json::parse(shipped("experiments/languages/" + name + ".json"));
}

/// A lab's language: German with one value changed, or taken out where there is none.
JsonDocument dutch(const std::string& pointer = "", const json& value = nullptr) {
  json language = shipped_language("de");
  language["title"] = "Dutch";
  if (value.is_null() && !pointer.empty()) {
    erase(language, pointer);
  } else if (!pointer.empty()) {
    language[json::json_pointer(pointer)] = value;
  }
  return parse_json("nl.json", language.dump());
}

std::string dutch_refusal(const std::string& pointer, const json& value) {
  return refusal([&] { static_cast<void>(read_language(dutch(pointer, value))); });
}

TEST(Languages, ThatAreShippedAreCompleteAndKeepWhatIsPutIn) {
  std::set<std::string> names;
  for (const auto& [name, language] : shipped_languages()) {
    names.insert(name);
    const JsonDocument file = parse_json(name, shipped_language(name).dump());
    EXPECT_EQ(refusal([&] { static_cast<void>(read_language(file)); }), "accepted");
    EXPECT_EQ(refusal([&] { check_letters(file); }), "accepted");
    EXPECT_EQ(language.texts().size(), kTextRows.size());
    EXPECT_EQ(language.title(), file.value["title"].get<std::string>());
  }
  EXPECT_EQ(names, kShipped);
}

TEST(Languages, ThatAreShippedLeaveNoSentenceInEnglish) {
  const std::regex two_words("[a-z] [a-z]");
  for (const auto& [name, language] : shipped_languages()) {
    for (std::size_t i = 0; i < kTextRows.size() && name != "en"; ++i) {
      const std::string& text = english().texts()[i];
      if (std::regex_search(text, two_words)) {
        EXPECT_NE(language.texts()[i], text) << name << ": " << kTextRows[i].key;
      }
    }
  }
}

TEST(Languages, OfALabAreRefusedAtTheTextThatIsWrong) {
  EXPECT_EQ(dutch_refusal("", nullptr), "accepted");
  EXPECT_EQ(dutch_refusal("/texts/pause", nullptr),
            "nl.json:/texts: expected a text for \"pause\" (\"Pause\" in English), which is "
            "missing");
  EXPECT_EQ(dutch_refusal("/texts/pause", ""), dutch_refusal("/texts/pause", nullptr));
  EXPECT_EQ(dutch_refusal("/texts/pauze", "Pauze"),
            "nl.json:/texts/pauze: expected the key of a text that participants see, such as "
            "\"continue\", got \"pauze\"");
  EXPECT_EQ(dutch_refusal("/texts/time_to_answer", "U hebt even."),
            "nl.json:/texts/time_to_answer: expected {seconds} in it, as in \"You have {seconds} s "
            "to answer.\", got \"U hebt even.\"");
  EXPECT_EQ(dutch_refusal("/texts/time_to_answer", "U hebt {seconds} {tijd}."),
            "nl.json:/texts/time_to_answer: expected only what \"You have {seconds} s to answer.\" "
            "has in braces, got \"{tijd}\"");
  EXPECT_EQ(dutch_refusal("/texts/yes_key", "ja"),
            "nl.json:/texts/yes_key: expected a key, one letter from a to z, got \"ja\"");
  EXPECT_EQ(dutch_refusal("/texts/no_key", "j"),
            "nl.json:/texts/no_key: expected another key than that of \"yes_key\", got \"j\"");
  EXPECT_EQ(
      dutch_refusal("/texts/back_key", "n"),
      "nl.json:/texts/back_key: expected another key than that of \"decline_key\", got \"n\"");
  EXPECT_EQ(dutch_refusal("/texts/yes", 1), "nl.json:/texts/yes: expected a text, got 1");
  EXPECT_EQ(dutch_refusal("/title", nullptr),
            "nl.json:/: expected the key \"title\", which is missing");
}

TEST(Languages, SayOneInTheirOwnWay) {
  EXPECT_EQ(dutch_refusal("/texts/clicked_one", "U klikte een keer."), "accepted");
  const Language german = shipped_languages().at("de");
  EXPECT_EQ(german.counted_text("clicked", 1), "Sie haben einmal geklickt.");
  EXPECT_EQ(german.counted_text("clicked", 2), "Sie haben 2-mal geklickt.");
  EXPECT_EQ(german.number("0.5"), "0,5");
  EXPECT_EQ(german.quoted("a{b}"), "„a{b}“");
  EXPECT_EQ(Language().percent(0.5), "50 %");
}

// ---------------------------------------------------------------- a protocol's language

TEST(ProtocolLanguage, IsEnglishUnlessItIsNamed) {
  EXPECT_EQ(Study().made().script.language.title(), "English");
  EXPECT_EQ(Study().with("/language", "fr").made().script.language.text("continue"), "Continuer");
  EXPECT_EQ(Study().with("/language", "klingon").refused(),
            std::string(kProtocolName) +
                ":/language: expected one of \"ar\", \"de\", \"en\", \"es\", \"fr\", \"pt\", "
                "\"zh\", or a "
                "file that ends in .json, got \"klingon\"");
  EXPECT_EQ(Study().with("/language", 1).refused(),
            std::string(kProtocolName) + ":/language: expected a text or an object, got 1");
}

TEST(ProtocolLanguage, HasTheProtocolsOwnTextsInItsPlace) {
  const Language language = Study()
                                .with("/language", "de")
                                .with("/texts", {{"continue", "Los"}, {"practice_advice", ""}})
                                .made()
                                .script.language;
  EXPECT_EQ(language.text("continue"), "Los");
  EXPECT_EQ(language.text("practice_advice"), "");
  EXPECT_EQ(language.text("pause"), "Pause");
}

TEST(ProtocolLanguage, TextsAreRefusedWhereTheyWouldLeaveSomethingUnsaid) {
  const auto refused = [](const json& texts) {
    const std::string words = Study().with("/texts", texts).refused();
    const std::string name = std::string(kProtocolName) + ":/texts";
    return words.starts_with(name) ? words.substr(name.size()) : words;
  };
  EXPECT_EQ(refused({{"contine", "Go"}}),
            "/contine: expected the key of a text that participants see, such as \"continue\", got "
            "\"contine\"");
  EXPECT_EQ(refused({{"continue", ""}}),
            "/continue: expected a text that is not empty: what has a name or a key cannot be "
            "without it, got \"\"");
  EXPECT_EQ(refused({{"break_progress", "{done} are done."}}),
            "/break_progress: expected {total} in it, as in \"{done} of {total} trials are done "
            "and saved.\", got \"{done} are done.\"");
  EXPECT_EQ(refused({{"yes_key", "n"}}),
            "/no_key: expected another key than that of \"yes_key\", got \"n\"");
}

/// A study in a folder whose language is a file.
struct LabsStudy {
  explicit LabsStudy(const json& language) {
    json protocol = json::parse(shipped(kProtocolName));
    protocol["language"] = "languages/nl.json";
    file = folder.write("protocols/a.json", protocol.dump());
    folder.write("protocols/languages/nl.json", language.dump());
    folder.write(kSceneName, shipped(kSceneName));
  }

  [[nodiscard]] std::string refused() const {
    std::string words = refusal([&] { static_cast<void>(load_protocol(file)); });
    const std::string place = folder.path().string() + "/";
    const std::size_t at = words.find(place);
    return at == std::string::npos ? words : words.erase(at, place.size());
  }

  TemporaryFolder folder;
  std::filesystem::path file;
};

TEST(ProtocolLanguage, OfAFileIsHeldByTheProtocolAsAStudyKeepsIt) {
  const LabsStudy study(dutch("/texts/continue", "Verder").value);
  const Protocol loaded = load_protocol(study.file);
  EXPECT_EQ(loaded.script.language.text("continue"), "Verder");
  const Protocol again = make_protocol(parse_json("study", loaded.document.text),
                                       parse_json("scene", loaded.scene.text));
  EXPECT_EQ(again.script.language.texts(), loaded.script.language.texts());
  EXPECT_EQ(again.hash, loaded.hash);
  EXPECT_NE(loaded.hash, load_protocol(LabsStudy(dutch().value).file).hash);
}

/// A build adds texts; what a study has stored without them replays.
TEST(ProtocolLanguage, ThatAStudyHasStoredMayLackATextWhichEnglishHas) {
  const LabsStudy study(dutch("/texts/continue", "Verder").value);
  const Protocol loaded = load_protocol(study.file);
  json stored = loaded.document.value;
  stored["language"]["texts"].erase("close");
  const Language language =
      make_protocol(parse_json("study", stored.dump()), parse_json("scene", loaded.scene.text))
          .script.language;
  EXPECT_EQ(language.text("continue"), "Verder");
  EXPECT_EQ(language.text("close"), "Close");
  study.folder.write("protocols/a.json", stored.dump());
  EXPECT_EQ(study.refused(),
            "protocols/a.json:/language/texts: expected a text for \"close\" (\"Close\" in "
            "English), which is missing");
}

TEST(ProtocolLanguage, OfAFileIsRefusedByTheNameOfThatFile) {
  EXPECT_EQ(LabsStudy(dutch("/texts/pause", nullptr).value).refused(),
            "protocols/languages/nl.json:/texts: expected a text for \"pause\" (\"Pause\" in "
            "English), which is missing");
  EXPECT_EQ(
      LabsStudy(dutch("/texts/pause", "\u05E9\u05B8").value).refused(),
      "protocols/languages/nl.json:/texts/pause: expected letters that screens can show "
      "(Latin, Greek, Cyrillic, Hebrew, Arabic, Chinese, Japanese, Korean, signs), got U+05B8 "
      "as character 2");
  const LabsStudy without(dutch().value);
  std::filesystem::remove(without.folder / "protocols/languages/nl.json");
  EXPECT_EQ(without.refused().substr(0, 104),
            "protocols/a.json:/language: expected a file with a language, seen from this one, got "
            "\"languages/nl.json\"");
}

TEST(ProtocolLanguage, OfWideLettersLetsAProtocolHaveThemToo) {
  const auto loaded = [](const char* language) {
    const TemporaryFolder folder;
    json protocol = json::parse(shipped(kProtocolName));
    protocol["language"] = language;
    protocol["session"]["welcome"]["title"] = "\u6B22\u8FCE\u60A8";
    const std::filesystem::path file = folder.write("protocols/a.json", protocol.dump());
    folder.write(kSceneName, shipped(kSceneName));
    return wide_letters(load_protocol(file));
  };
  EXPECT_EQ(refusal([&] { loaded("zh"); }), "accepted");
  EXPECT_NE(refusal([&] { loaded("de"); }), "accepted");
  const std::set<std::uint16_t> letters = loaded("zh");
  EXPECT_EQ(letters.count(0x6B22), 1U) << "of the protocol";
  EXPECT_EQ(letters.count(0x7EE7), 1U) << "of the language: \u7EE7\u7EED";
  EXPECT_TRUE(wide_letters(Study().with("/language", "de").made()).empty());
  EXPECT_EQ(wide_letters(Study().with("/language", "ar").made()).count(0x0645), 1U);
}

}  // namespace impetus::language_file_test
