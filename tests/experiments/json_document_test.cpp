// What a JSON file must be before anything in it is read: every refusal, word for word.
// SPDX-License-Identifier: MIT
#include "experiments/protocol/json_document.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::json_document_test {

TEST(JsonDocument, MalformedJsonIsRefusedAtItsLineAndColumn) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "a.json:1:1: expected valid JSON, got the end of the file"},
      {"[1,2", "a.json:1:5: expected valid JSON, got the end of the file"},
      {"{\n  \"a\": 1,\n}", "a.json:3:1: expected valid JSON, got '}'"},
      {"{\"a\" 1}", "a.json:1:6: expected valid JSON, got '1'"},
      {"{\"a\": tru}", "a.json:1:10: expected valid JSON, got '}'"},
      {"{\"a\": 'x'}", "a.json:1:7: expected valid JSON, got '''"},
      {"// words\n{}", "a.json:1:1: expected valid JSON, got '/'"},
      {"{} {}", "a.json:1:4: expected valid JSON, got '{'"},
      {"{\n\"a\": \"x\ny\"}", "a.json:2:8: expected valid JSON, got the end of the line"},
      {"[\"a\tb\"]", "a.json:1:4: expected valid JSON, got a control character"},
      {"[NaN]", "a.json:1:2: expected valid JSON, got 'N'"}};
  for (const auto& [text, sentence] : cases) {
    EXPECT_EQ(json_refusal(text), sentence);
  }
}

TEST(JsonDocument, AColumnIsACharacterAndNotAByte) {
  EXPECT_EQ(json_refusal("[\"é°\" é]"), "a.json:1:7: expected valid JSON, got 'é'");
}

TEST(JsonDocument, TextInAnotherEncodingIsRefusedAsSuch) {
  EXPECT_EQ(json_refusal("{\"a\": \"\xb0/s\"}"),
            "a.json:1:8: expected text in UTF-8, got a byte that is not");
}

TEST(JsonDocument, AKeyThatStandsTwiceIsRefusedAtItsPlace) {
  EXPECT_EQ(json_refusal(R"({"a": 1, "a": 1})"), "a.json:/a: expected each key once, got it twice");
  EXPECT_EQ(json_refusal(R"({"a": [{"b": 1}, {"b": 1, "c": {}, "b": 2}]})"),
            "a.json:/a/1/b: expected each key once, got it twice");
  EXPECT_EQ(json_refusal(R"({"a": {"x": 1}, "b": {"x": 1}})"), "accepted");
}

TEST(JsonDocument, ANumberTooLargeIsRefusedAtItsPlace) {
  EXPECT_EQ(json_refusal(R"({"a": [1, [], 1e400]})"),
            "a.json:/a/2: expected a number of at most 1.8e308, got 1e400");
}

TEST(JsonDocument, BottomlessNestingIsRefused) {
  const std::string open(65, '[');
  const std::string close(65, ']');
  std::string place;
  for (int level = 0; level < 64; ++level) {
    place += "/0";
  }
  EXPECT_EQ(json_refusal(open + close),
            "a.json:" + place + ": expected at most 64 levels of nesting, got more");
  EXPECT_EQ(json_refusal(open.substr(1) + close.substr(1)), "accepted");
}

TEST(JsonDocument, AFileThatCannotBeReadIsRefusedWithTheReason) {
  const TemporaryFolder folder;
  const std::string missing = (folder / "none.json").string();
  EXPECT_EQ(refusal([&] { read_json(missing); }),
            missing + ": expected a JSON file, but it cannot be read: No such file or directory");
  EXPECT_EQ(
      refusal([&] { read_json(folder.path()); }),
      folder.path().string() + ": expected a JSON file, but it cannot be read: it is a directory");
}

}  // namespace impetus::json_document_test
