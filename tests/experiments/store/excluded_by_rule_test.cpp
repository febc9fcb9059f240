// Who is left out by rules of a protocol, against a count of the answers one by one.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include "experiments/settings/json_document.hpp"
#include "tests/experiments/program.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::excluded_by_rule_test {

/// Six simulated participants of a short study, with rules that some of them meet.
class ExcludedByRule : public testing::Test {
 protected:
  static constexpr int kEqual = 5;
  static constexpr int kAlternations = 5;
  static constexpr int kRight = 9;

  static void SetUpTestSuite() {
    using nlohmann::json;
    const TemporaryFolder& folder = *(shared() = std::make_unique<TemporaryFolder>());
    json protocol = json::parse(text_of(source_file("protocols/what-will-happen.json")));
    protocol["design"]["repetitions"] = 1;
    protocol["exclude_when"] = {{"equal_answers_in_a_row", kEqual},
                                {"alternations_in_a_row", kAlternations},
                                {"practice_right_below", kRight}};
    std::filesystem::create_directories(folder / "protocols");
    std::filesystem::create_directories(folder / "stimuli");
    folder.write("protocols/short.json", protocol.dump());
    folder.write("stimuli/what-will-happen.json",
                 text_of(source_file("stimuli/what-will-happen.json")));
    const ProgramResult result =
        run_program(folder, {"run", "protocols/short.json", "--db", "a.sqlite", "--participants",
                             "6", "--observer",
                             source_file("experiments/observers/what-will-happen.json").string()});
    ASSERT_EQ(result.status, 0) << result.errors;
  }

  static void TearDownTestSuite() { shared().reset(); }

  /// Each test has a copy of the study.
  void SetUp() override {
    std::filesystem::copy_file(*shared() / "a.sqlite", folder_ / "a.sqlite");
  }

  [[nodiscard]] std::string asked(const std::string& sql) const {
    return value_of(folder_ / "a.sqlite", sql);
  }

  TemporaryFolder folder_;

 private:
  static std::unique_ptr<TemporaryFolder>& shared() {
    static std::unique_ptr<TemporaryFolder> folder;
    return folder;
  }
};

/// The longest run, in letters of answers such as "ynny": alike, or each unlike the one before.
int longest_run(const std::string& answers, bool alike) {
  int longest = 0;
  int run = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    run = i > 0 && (answers[i] == answers[i - 1]) == alike ? run + 1 : 1;
    longest = std::max(longest, run);
  }
  return longest;
}

TEST_F(ExcludedByRule, NamesThoseWhoMeetOneAndNobodyElse) {
  int met = 0;
  for (int person = 1; person <= 6; ++person) {
    const std::string code = "S0" + std::to_string(person);
    const std::string answers = asked(
        "SELECT group_concat(substr(answer, 1, 1), '') FROM (SELECT answer FROM "
        "trial_response WHERE phase = 'main' AND participant = '" +
        code + "' ORDER BY slot)");
    ASSERT_EQ(answers.size(), 30U);
    const int right = std::stoi(asked(
        "SELECT sum(correct) FROM trial_response WHERE phase = 'practice' AND participant = '" +
        code + "'"));
    std::string expected;
    if (longest_run(answers, false) - 1 >= kAlternations) {
      expected += "alternations_in_a_row " + std::to_string(longest_run(answers, false) - 1) + ";";
    }
    if (longest_run(answers, true) >= kEqual) {
      expected += "equal_answers_in_a_row " + std::to_string(longest_run(answers, true)) + ";";
    }
    if (right < kRight) {
      expected += "practice_right_below " + std::to_string(right) + ";";
    }
    EXPECT_EQ(asked("SELECT coalesce(group_concat(rule || ' ' || number || ';', ''), '') FROM "
                    "(SELECT * FROM excluded_by_rule WHERE participant = '" +
                    code + "' ORDER BY rule)"),
              expected)
        << answers;
    EXPECT_EQ(
        asked("SELECT count(*) FROM excluded WHERE trial IS NULL AND participant = '" + code + "'"),
        expected.empty() ? "0" : "1");
    met += expected.empty() ? 0 : 1;
  }
  EXPECT_GT(met, 0);
  EXPECT_LT(met, 6);
}

TEST_F(ExcludedByRule, IsTakenBackByHand) {
  const std::string code = asked("SELECT min(participant) FROM excluded");
  EXPECT_EQ(run_program(folder_, {"exclude", "a.sqlite", "--participant", code, "--reason",
                                  "the rule was not meant for this", "--take-back"})
                .status,
            0);
  EXPECT_EQ(asked("SELECT count(*) FROM excluded WHERE participant = '" + code + "'"), "0");
  EXPECT_NE(asked("SELECT count(*) FROM excluded_by_rule WHERE participant = '" + code + "'"), "0");
}

}  // namespace impetus::excluded_by_rule_test
