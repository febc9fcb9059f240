// `impetus verify` gives every answer to its question again: what that would keep otherwise is
// named.
// SPDX-License-Identifier: MIT
#include "experiments/study/answer_check.hpp"

#include "tests/experiments/small_study.hpp"

namespace impetus::answer_check_test {

using nlohmann::json;

/// The small protocol, which asks this in place of its rating.
Protocol asking(const char* questions) {
  json changed = small_protocol().document.value;
  changed.erase("rating");
  changed.update(json::parse(questions));
  return make_protocol(parse_json("small.json", changed.dump()), causality().scene);
}

constexpr const char* kQuestions = R"({
  "yes_no": {"question": "Seen?", "right_when": {"factor": "delay_ms", "above": 50}},
  "choice": {"question": "Which?", "options": ["a late one", "none"],
             "right_when": {"factor": "delay_ms",
                            "options": {"0": "none", "100": "a late one"}}},
  "slider": {"scales": [{"question": "How sure?", "minimum": 0, "maximum": 10,
                         "words": ["not", "quite"]}]},
  "free_text": {"question": "What was it?"}})";

constexpr const char* kTwoIntervals = R"({
  "two_interval": {"question": "In which?", "standard": {"delay_ms": 0}}})";

/// A study of one person, whose third trial is of 100 ms; to be copied and changed.
class AnsweredStudy {
 public:
  explicit AnsweredStudy(const char* questions)
      : whole_(small_study(folder_ / "whole.sqlite", {"P01"}, asking(questions))) {}

  /// What is wrong with the answers after such a change.
  [[nodiscard]] Failures failures_after(const std::string& sql) const {
    const std::filesystem::path path = folder_ / "a.sqlite";
    std::filesystem::copy_file(whole_, path, std::filesystem::copy_options::overwrite_existing);
    tamper(path, sql);
    StudyFile study = StudyFile::open_for_reading(path);
    Failures failures = wrong_answers(study, ProtocolShelf(study));
    for (std::string& failure : failures) {
      failure = failure.substr(failure.find(": ") + 2);
    }
    return failures;
  }

 private:
  TemporaryFolder folder_;
  std::filesystem::path whole_;
};

void expect_named(const AnsweredStudy& study,
                  const std::vector<std::pair<std::string, std::string>>& cases) {
  EXPECT_EQ(study.failures_after("SELECT 1"), Failures{});
  for (const auto& [sql, sentence] : cases) {
    EXPECT_EQ(study.failures_after(sql), Failures{sentence}) << sql;
  }
}

/// An update of the answer of this kind in the third trial.
std::string changed(const std::string& kind, const std::string& values) {
  return "UPDATE response SET " + values + " WHERE attempt_id = 3 AND kind = '" + kind + "'";
}

TEST(AnswerCheck, WhatAQuestionWouldKeepOtherwiseIsNamed) {
  const AnsweredStudy study(kQuestions);
  expect_named(
      study,
      {{changed("yes_no", "answer = 'maybe'"), "the answer maybe is none that can be given"},
       {changed("yes_no", "positive = 1 - positive"),
        "the answer yes is not kept with positive 1, as its protocol gives"},
       {changed("yes_no", "positive = NULL"),
        "the answer yes is not kept with positive 1, as its protocol gives"},
       {changed("yes_no", "question = 'Heard?'"), "was asked in other words than its protocol's"},
       {changed("yes_no", "timed_out = 1"), "the answer yes is none that can be given"},
       {changed("choice", "answer = 'a fly'"), "the answer a fly is none that can be given"},
       {changed("choice", "detail = '{\"options\":3,\"right\":\"none\"}'"),
        "the answer a late one is kept with {\"options\":3,\"right\":\"none\"}, its protocol gives "
        "{\"options\":2,\"right\":\"a late one\"}"},
       {changed("slider", "answer = '11'"), "the answer 11 is none that can be given"},
       {changed("slider", "answer = '5 or so'"), "the answer 5 or so is none that can be given"},
       {changed("free_text", "positive = 1"),
        "the answer  is not kept with positive empty, as its protocol gives"},
       {"DELETE FROM response WHERE attempt_id = 3 AND kind = 'slider'",
        "completed without the answer of kind slider that was asked for"}});
  EXPECT_EQ(study.failures_after("UPDATE response SET correct = 1 - correct WHERE kind = 'yes_no'")
                .size(),
            5U);
}

TEST(AnswerCheck, WhichIntervalWasTheTestsFollowsFromTheTrialsSeed) {
  const AnsweredStudy study(kTwoIntervals);
  EXPECT_EQ(study.failures_after("SELECT 1"), Failures{});
  EXPECT_EQ(
      study
          .failures_after("UPDATE response SET detail = json_set(detail, '$.test_interval', 3 - "
                          "(detail ->> '$.test_interval'))")
          .size(),
      5U);
  EXPECT_EQ(study
                .failures_after("UPDATE response SET answer = iif(answer = 'first', 'second', "
                                "'first')")
                .size(),
            5U);
}

TEST(AnswerCheck, PagesThatWereAskedBeforeTheTrialsHaveTheirAnswers) {
  const AnsweredStudy study(kQuestions);
  const Script script = asking(kQuestions).script;
  ASSERT_FALSE(script.demographics.empty());
  ASSERT_FALSE(script.questions.empty());
  for (const std::string& id :
       {std::string("consent"), script.demographics.front().id, script.questions.front().id}) {
    EXPECT_EQ(study.failures_after("DELETE FROM answer WHERE question = '" + id + "'"),
              Failures{"was shown trials, but what was answered to " + id + " is missing"});
  }
  EXPECT_EQ(study.failures_after("UPDATE enrolment SET finished_utc = NULL; "
                                 "DELETE FROM answer WHERE kind = 'question'"),
            Failures{});
}

}  // namespace impetus::answer_check_test
