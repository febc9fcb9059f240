// What a protocol has the screens say: texts of a size, without control characters, in letters that
// the screens have. Everything else is refused before a window opens.
// SPDX-License-Identifier: MIT
#include "experiments/files/protocol_files.hpp"
#include "experiments/record/shown_letters.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::shown_text_test {

/// The shipped study as files in a folder, with one value changed.
std::string refusal_of_file(const std::string& pointer, const json& value) {
  const TemporaryFolder folder;
  json protocol = json::parse(shipped(kProtocolName));
  protocol[json::json_pointer(pointer)] = value;
  const std::filesystem::path file = folder.write("protocols/a.json", protocol.dump());
  folder.write(kSceneName, shipped(kSceneName));
  const std::string words = refusal([&] { static_cast<void>(load_protocol(file)); });
  const std::string name = file.string();
  return words.starts_with(name) ? "a.json" + words.substr(name.size()) : words;
}

TEST(JsonText, IsAsLongAsTenThousandBytesAndNoLonger) {
  EXPECT_EQ(json_refusal("[\"" + std::string(10'000, 'x') + "\"]"), "accepted");
  EXPECT_EQ(json_refusal("{\"a\": [1, \"" + std::string(10'001, 'x') + "\"]}"),
            "a.json:/a/1: expected at most 10000 bytes of text, got 10001");
  EXPECT_EQ(json_refusal("{\"" + std::string(10'001, 'x') + "\": 1}"),
            "a.json:/a key: expected at most 10000 bytes of text, got 10001");
  // A mesh that a stored scene holds is no text.
  EXPECT_EQ(json_refusal("{\"base64\": \"" + std::string(1'000'000, 'A') + "\"}"), "accepted");
}

TEST(JsonText, HasNoControlCharactersButLineBreaksAndTabs) {
  const std::string expected = "expected text without control characters but line breaks and tabs";
  EXPECT_EQ(json_refusal(R"({"a": "two\r\nlines\tand a tab"})"), "accepted");
  EXPECT_EQ(json_refusal(R"({"a": "red \u001b[31m"})"), "a.json:/a: " + expected + ", got \\u001b");
  EXPECT_EQ(json_refusal(R"({"a": ["", "nothing \u0000 more"]})"),
            "a.json:/a/1: " + expected + ", got \\u0000");
  EXPECT_EQ(json_refusal(R"(["\u007f"])"), "a.json:/0: " + expected + ", got \\u007f");
  EXPECT_EQ(json_refusal(R"(["\u009b"])"), "a.json:/0: " + expected + ", got \\u009b");
  EXPECT_EQ(json_refusal(R"({"a\u001b": 1})"), "a.json:/a\\u001b: " + expected + ", got \\u001b");
  EXPECT_EQ(json_refusal(R"(["\u00a0\u00e9"])"), "accepted");
}

// The library that checks schemas searches for patterns by recursion, a level for each letter.
TEST(ProtocolTexts, ANameOfAMillionLettersIsRefusedAndNoStackEnds) {
  EXPECT_EQ(refusal_of_file("/name", std::string(1'000'000, 'a')),
            "a.json:/name: expected at most 10000 bytes of text, got 1000000");
  const std::string longest(10'000, 'a');
  EXPECT_EQ(refusal_of_file("/name", longest), "accepted");
  EXPECT_EQ(refusal_of_file("/name", std::string(9'999, 'a') + "A").substr(0, 43),
            "a.json:/name: expected a text of lower-case");
}

TEST(ProtocolTexts, LettersThatScreensCannotShowAreRefusedAtTheirPlace) {
  const std::string expected =
      ": expected letters that screens can show (Latin, Greek, Cyrillic, Hebrew, Arabic, signs), "
      "got ";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"\u05E9\u05B8", "U+05B8 as character 2"},
      {"an \u0645\u064E", "U+064E as character 5"},
      {"\u0928\u092E\u0938\u094D\u0924\u0947", "U+0928 as character 1"},
      {"\u53C2", "U+53C2 as character 1"},
      {"\U0001F600", "U+1F600 as character 1"},
      {"e\u0301", "U+0301 as character 2"},
      {"a\u200B", "U+200B as character 2"},
      {"\u202Eabc", "U+202E as character 1"}};
  for (const auto& [text, got] : cases) {
    EXPECT_EQ(refusal_of_file("/session/welcome/title", text),
              "a.json:/session/welcome/title" + expected + got);
    EXPECT_EQ(refusal_of_file("/session/demographics/1/options/2", text),
              "a.json:/session/demographics/1/options/2" + expected + got);
    EXPECT_EQ(refusal_of_file("/rating/question", text),
              "a.json:/rating/question" + expected + got);
  }
}

TEST(ProtocolTexts, EuropeanWordsMarkupAndLineBreaksAreText) {
  for (const char* text : {"Größe, œuvre, Žofie", "Σωκράτης", "Привет", "½ ≤ 2 µm – “quoted” … €",
                           "a\tb\r\nc", "<script>alert(1)</script> %s%n ##id ###id [x](y) `z`"}) {
    EXPECT_EQ(refusal_of_file("/session/welcome/title", text), "accepted") << text;
  }
}

TEST(ProtocolTexts, WhatNobodyReadsMayBeInAnyLetters) {
  EXPECT_EQ(refusal_of_file("/title", "\u53C2\u52A0\u8005"), "accepted");
}

TEST(ShownLetters, AreInOrderAndApart) {
  for (std::size_t i = 0; i < kShownLetters.size(); ++i) {
    EXPECT_LE(kShownLetters[i].first, kShownLetters[i].last);
    EXPECT_TRUE(i == 0 || kShownLetters[i - 1].last < kShownLetters[i].first);
  }
}

}  // namespace impetus::shown_text_test
