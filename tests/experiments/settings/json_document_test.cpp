// What a JSON file must be before anything in it is read: every refusal, word for word.
// SPDX-License-Identifier: MIT
#include "experiments/settings/json_document.hpp"

#include <sys/stat.h>

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
            missing + ": expected a JSON file, but it cannot be read: there is no such file");
  EXPECT_EQ(refusal([&] { read_json(folder.path()); }),
            folder.path().string() +
                ": expected a JSON file, but it cannot be read: it is a directory, not a file");
}

TEST(JsonDocument, OnlyARegularFileIsOpened) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe.json").c_str(), 0600), 0);
  std::filesystem::create_symlink("loop.json", folder / "loop.json");
  folder.write("file", "{}");
  std::filesystem::create_symlink("/dev/zero", folder / "zero.json");
  std::filesystem::create_symlink("file", folder / "link.json");
  const std::string long_name(300, 'x');
  const std::vector<std::pair<std::filesystem::path, std::string>> cases{
      {folder / "pipe.json", "it is a named pipe, not a file"},
      {"/dev/zero", "it is a device, not a file"},
      {folder / "zero.json", "it is a device, not a file"},
      {folder / "loop.json", "its links lead round in a circle"},
      {folder / long_name, "its name is too long"},
      {folder / "file/a.json", "a part of its path is a file, not a directory"}};
  for (const auto& each : cases) {
    const auto& path = each.first;
    EXPECT_EQ(refusal([&] { read_json(path); }),
              path.string() + ": expected a JSON file, but it cannot be read: " + each.second);
  }
  EXPECT_EQ(refusal([&] { read_json(folder / "link.json"); }), "accepted");
}

TEST(JsonDocument, AFileOfNothingThatIsHugeIsRefusedUnread) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.write("huge.json", "");
  std::filesystem::resize_file(path, 1'000'000'000'000);  // sparse: it takes no room
  EXPECT_EQ(refusal([&] { read_json(path); }),
            path.string() +
                ": expected a JSON file, but it cannot be read: it has 1000000000000 bytes, more "
                "than the 500000000 that are read");
}

TEST(JsonDocument, MoreValuesThanAnybodyMeansAreRefusedWhereTheyBegin) {
  std::string text = "{\"a\": [[]";
  for (int i = 0; i < 1'000'000; ++i) {
    text += ",0";
  }
  EXPECT_EQ(json_refusal(text + "]}"),
            "a.json:/a/999998: expected at most 1000000 values in a file, got more");
}

TEST(JsonDocument, BracketsWithoutEndAreRefusedAtTheFirstThatIsTooDeep) {
  std::string place;
  for (int level = 0; level < 64; ++level) {
    place += "/0";
  }
  EXPECT_EQ(json_refusal(std::string(10'000'000, '[')),
            "a.json:" + place + ": expected at most 64 levels of nesting, got more");
}

TEST(JsonDocument, AListOfManyObjectsIsReadAtOnce) {
  std::string text = "[{}";
  for (int i = 1; i < 900'000; ++i) {
    text += ",{}";
  }
  EXPECT_EQ(json_refusal(text + "]"), "accepted");  // a second; hours when each asks for all others
}

}  // namespace impetus::json_document_test
