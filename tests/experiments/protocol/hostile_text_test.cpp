// What people or foreign files say stays text: in names, in exports, on pages, in SQL.
// SPDX-License-Identifier: MIT
#include <regex>
#include <set>

#include "experiments/protocol/participant_code.hpp"
#include "experiments/protocol/protocol_page.hpp"
#include "tests/experiments/csv_reading.hpp"
#include "tests/experiments/refusals.hpp"
#include "tests/experiments/whole_study.hpp"

namespace impetus::hostile_text_test {

/// Each has its own way of becoming more than text.
const std::vector<std::string>& hostile_texts() {
  static const std::vector<std::string> kTexts{"Robert'); DROP TABLE trial;--",
                                               "<script>alert(1)</script>",
                                               "%s%n%s%n",
                                               "=1+1",
                                               "@SUM(A1)",
                                               "a,b\"c\"",
                                               "two\nlines",
                                               "tab\there",
                                               "[link](javascript:alert(1)) `code` | cell",
                                               "\xE2\x80\xAEthgir ot tfel",
                                               std::string(10'000, 'x')};
  return kTexts;
}

std::string in_sql(const std::string& text) {
  std::string quoted = "'";
  for (const char letter : text) {
    quoted += letter == '\'' ? "''" : std::string(1, letter);
  }
  return quoted + "'";
}

/// The study with these texts wherever somebody's words can stand: the n-th in the n-th row added.
void plant(const TemporaryFolder& folder) {
  std::string sql;
  int number = 100;
  for (const std::string& text : hostile_texts()) {
    const std::string words = in_sql(text);
    const std::string id = std::to_string(++number);
    sql += "INSERT INTO participant (id, pseudonym, simulated) VALUES (" + id + ", " + words +
           ", 0); INSERT INTO exclusion (participant_id, excluded, reason, decided_utc) VALUES (" +
           id + ", 1, " + words + ", ''); INSERT INTO answer (session_id, kind, question, words, " +
           "answer) VALUES (1, 'question', " + words + ", " + words + ", " + words +
           "); INSERT INTO note (session_id, written_utc, kind, text) VALUES (1, '', " + words +
           ", " + words + "); INSERT INTO response SELECT 1, " + id + ", 'free_text', " + words +
           ", " + words + ", NULL, NULL, '{}', 'key', 1, 2, 1, 0;";
  }
  WholeStudy::once().copy_to(folder, sql);
}

/// The last cells of a column, as many as there are hostile texts.
std::vector<std::string> last_cells(const CsvTable& table, const std::string& column) {
  std::vector<std::string> cells;
  const std::size_t count = hostile_texts().size();
  for (std::size_t i = 0; i < count && count <= table.rows.size(); ++i) {
    cells.push_back(table.at(table.rows.size() - count + i, column).text);
  }
  return cells;
}

// ---------------------------------------------------------------- the code of a participant

TEST(ParticipantCode, IsTextOnOneLine) {
  for (const std::string code :
       {"P01", "Ann-Marie 2", "Žofie", "参加者", "Robert'); DROP TABLE trial;--", "=1+1", "%s%n",
        "<b>", ".", "a.b", "😀"}) {
    EXPECT_TRUE(is_participant_code(code)) << code;
  }
  EXPECT_TRUE(is_participant_code(std::string(64, 'a')));
  for (const std::string& code :
       {std::string(), std::string(65, 'a'), std::string("a\nb"), std::string("a\tb"),
        std::string("a\x7f"), std::string("a\0b", 3), std::string("a/b"), std::string("a\\b"),
        std::string(" a"), std::string("a "), std::string("\xC3"), std::string("\xC0\xAF"),
        std::string("\xC2\x85"), std::string("P\xE2\x80\x8B"), std::string("\xE2\x80\xAEP"),
        std::string("\xEF\xBB\xBFP"), std::string("a\xE2\x80\xA8")}) {
    EXPECT_FALSE(is_participant_code(code)) << testing::PrintToString(code);
  }
}

TEST(ParticipantCode, WhatReadsLikeANameIsTold) {
  for (const std::string name :
       {"Anna", "Anna Schmidt", "Ann-Marie", "J\xC3\xBCrgen M\xC3\xBCller"}) {
    EXPECT_TRUE(looks_like_name(name)) << name;
  }
  for (const std::string code : {"P01", "guest", "Anna2", "VP", "S07", "A-B", "MEG01", ""}) {
    EXPECT_FALSE(looks_like_name(code)) << code;
  }
}

TEST(ParticipantCode, AnotherIsRefusedBeforeAnythingOpens) {
  const TemporaryFolder folder;
  const std::string expected =
      "--participant: expected a code of at most 64 bytes of text without control characters, "
      "unseen ones, / and \\, and without a space at its ends, got ";
  expect_refused_without_a_file(folder, simulated_run({"--participant", "a\nb"}),
                                expected + "\"a\\nb\"");
  expect_refused_without_a_file(folder, simulated_run({"--participant", "../P01"}),
                                expected + "\"../P01\"");
  expect_refused_without_a_file(folder, simulated_run({"--participant", "\xFF"}),
                                expected + "\"\\ufffd\"");
  expect_refused_without_a_file(folder, simulated_run({"--participant", std::string(9000, 'x')}),
                                expected + "\"" + std::string(64, 'x') + "\" ...");
}

// ---------------------------------------------------------------- exports

TEST(HostileText, IsTheSameTextInEveryCsvFile) {
  const TemporaryFolder folder;
  plant(folder);
  const ProgramResult result = run_program(folder, {"export", "a.sqlite", "--out", "out"});
  ASSERT_EQ(result.status, 0) << result.errors;
  const auto table = [&](const char* file) { return read_csv(text_of(folder / file)); };
  EXPECT_EQ(last_cells(table("out/participants.csv"), "pseudonym"), hostile_texts());
  EXPECT_EQ(last_cells(table("out/exclusions.csv"), "participant"), hostile_texts());
  EXPECT_EQ(last_cells(table("out/exclusions.csv"), "reason"), hostile_texts());
  EXPECT_EQ(last_cells(table("out/questionnaire.csv"), "answer"), hostile_texts());
  EXPECT_EQ(last_cells(table("out/notes.csv"), "text"), hostile_texts());
  std::set<std::string> answers;
  const CsvTable responses = table("out/responses.csv");
  for (std::size_t row = 0; row < responses.rows.size(); ++row) {
    answers.insert(responses.at(row, "answer").text);
  }
  for (const std::string& text : hostile_texts()) {
    EXPECT_EQ(answers.count(text), 1U) << text;
  }
}

TEST(HostileText, FormulasAreNamedAndInvalidBytesReplaced) {
  const TemporaryFolder folder;
  WholeStudy::once().copy_to(folder,
                             "UPDATE exclusion SET reason = '=1+1'; UPDATE note SET text = "
                             "CAST(x'61ff62' AS TEXT) WHERE kind = 'test'");
  const ProgramResult result = run_program(folder, {"export", "a.sqlite", "--out", "out"});
  EXPECT_EQ(result.errors,
            "note: 2 texts begin with = + - or @; import text as text where a spreadsheet would "
            "take it for a formula\n"
            "note: 1 texts were no UTF-8; bytes that are none became U+FFFD\n");
  const CsvTable notes = read_csv(text_of(folder / "out/notes.csv"));
  EXPECT_EQ(notes.at(notes.rows.size() - 1, "text").text,
            "a\xEF\xBF\xBD"
            "b");
}

TEST(HostileText, AFactorsNameIsTextInItsColumnAndInTheCodebook) {
  const TemporaryFolder folder;
  const std::string factor = "\"); DROP TABLE trial; -- <b> | x";
  const std::string condition = nlohmann::json{{factor, "1"}}.dump();
  WholeStudy::once().copy_to(folder,
                             "UPDATE trial SET condition = " + in_sql(condition) + " WHERE id = 1");
  ASSERT_EQ(run_program(folder, {"export", "a.sqlite", "--out", "out"}).status, 0);
  const CsvTable trials = read_csv(text_of(folder / "out/trials.csv"));
  EXPECT_EQ(trials.at(0, "factor_" + factor).text, "1");
  EXPECT_EQ(text_of(folder / "out/codebook.md").find("<b>"), std::string::npos);
}

TEST(HostileText, AProtocolsNameIsNoPath) {
  const TemporaryFolder folder;
  WholeStudy::once().copy_to(folder,
                             "UPDATE protocol SET name = '../../out2/x' || id, hash = "
                             "'/etc/passwd' || id");
  ASSERT_EQ(run_program(folder, {"export", "a.sqlite", "--out", "out"}).status, 0);
  EXPECT_TRUE(
      std::filesystem::exists(folder / "out/protocols/1-------out2-x1--etc-passwd1.protocol.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out2"));
}

TEST(HostileText, InACodeIsTextToExclude) {
  const TemporaryFolder folder;
  plant(folder);
  change(folder, "DELETE FROM exclusion");
  for (const std::string& text : hostile_texts()) {
    const ProgramResult excluded =
        run_program(folder, {"exclude", "a.sqlite", "--participant", text, "--reason", text});
    EXPECT_EQ(excluded.status, 0) << excluded.errors;
    EXPECT_EQ(value_of(folder, "SELECT reason FROM exclusion ORDER BY id DESC LIMIT 1"), text);
  }
}

TEST(HostileText, InACodeIsTextToReplay) {
  const TemporaryFolder folder;
  const std::string code = hostile_texts()[0] + hostile_texts()[2];
  WholeStudy::once().copy_to(folder, "UPDATE participant SET pseudonym = " + in_sql(code));
  const ProgramResult replayed =
      run_program(folder, {"replay", "a.sqlite", "--participant", code, "--trial", "1"});
  EXPECT_EQ(replayed.status, 0) << replayed.errors;
}

TEST(HostileText, TheNameOfAViewIsNoSqlToTheMigration) {
  const TemporaryFolder folder;
  std::filesystem::copy_file(source_folder() + "/tests/recordings/gap.sqlite", folder / "a.sqlite");
  change(folder, "CREATE VIEW \"a\"\"; DROP TABLE trial; --\" AS SELECT 1 AS x");
  const ProgramResult result = run_program(folder, {"replay", "a.sqlite", "--trial", "1"});
  EXPECT_EQ(result.status, 0) << result.errors;
}

// ---------------------------------------------------------------- pages and screens

TEST(HostileText, MarkupInAProtocolIsTextOnItsPage) {
  const std::string hostile = "<script>alert(1)</script> [x](javascript:y) | `z`\n# heading";
  const std::string page = protocol_page(Study()
                                             .with("/title", hostile)
                                             .with("/rating/question", hostile)
                                             .with("/rating/low_anchor", hostile)
                                             .with("/design/factors/0/label", hostile)
                                             .with("/session/welcome/title", hostile)
                                             .with("/session/consent/paragraphs/0", hostile)
                                             .scene_with("/title", hostile)
                                             .made());
  EXPECT_EQ(page.find("<script>"), std::string::npos);
  EXPECT_EQ(page.find("[x]("), std::string::npos);
  EXPECT_EQ(page.find("\n# heading"), std::string::npos);
  EXPECT_NE(page.find("# &lt;script&gt;alert(1)&lt;/script&gt; \\[x\\](javascript:y)"),
            std::string::npos);
}

/// The window shows text by calls that would read it as a format: the format is always our own.
TEST(HostileText, IsNeverAFormatOnAScreen) {
  const std::regex call(
      R"(ImGui::(Text|TextWrapped|TextDisabled|BulletText|SetTooltip)\(\s*([^\s]))");
  const std::regex coloured(R"(ImGui::TextColored\([^;]*?\),\s*([^\s]))");
  int calls = 0;
  for (const char* room : {"window", "viewers", "drawing"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(source_folder() + "/experiments/" + room)) {
      if (!entry.is_regular_file()) {
        continue;
      }
      const std::string text = text_of(entry.path());
      for (std::sregex_iterator match(text.begin(), text.end(), call), none; match != none;
           ++match) {
        EXPECT_EQ((*match)[2].str(), "\"") << entry.path() << ": " << match->str();
        ++calls;
      }
      for (std::sregex_iterator match(text.begin(), text.end(), coloured), none; match != none;
           ++match) {
        EXPECT_EQ((*match)[1].str(), "\"") << entry.path() << ": " << match->str();
        ++calls;
      }
    }
  }
  EXPECT_GT(calls, 5) << "the screens were not found";
}

}  // namespace impetus::hostile_text_test
