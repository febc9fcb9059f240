// Training: practice goes on until enough of the last answers were right, or a person decides.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/experiments/asked_study.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::training_test {

json training_protocol() {
  json protocol = asked_protocol({kAskYesNo});
  protocol["design"]["train_until"] = json::parse(R"({"right": 3, "of": 3, "most_trials": 7})");
  return protocol;
}

/// A participant who answers practice trials right from the given one on, and never before.
struct TrainingLab : TestLab {
  explicit TrainingLab(std::int64_t right_from, const json& study = training_protocol())
      : TestLab(60.0, study_of(study)) {
    input.on_page = [this, right_from](const Page& page) {
      pages.push_back(page);
      Answer answer;
      if (page.response == "yes_no") {
        const PlannedTrial& trial = plan[slots_asked++];
        const bool yes_is_right = std::get<double>(trial.condition.front().value) > 0.0;
        const bool right = trial.slot >= right_from;
        answer.choice = yes_is_right == right ? 0 : 1;
      }
      return on_other_page ? on_other_page(page, answer) : answer;
    };
  }

  SessionResult run(const SessionHistory& history = {}) {
    return run_session(protocol.script, plan, history, ports());
  }
  [[nodiscard]] std::int64_t practised() const {
    return std::count_if(recorder.attempts.begin(), recorder.attempts.end(),
                         [](const AttemptRecord& attempt) { return attempt.slot <= 7; });
  }
  [[nodiscard]] const Page* titled(const std::string& title) const {
    const auto found = std::find_if(pages.begin(), pages.end(),
                                    [&](const Page& page) { return page.title == title; });
    return found == pages.end() ? nullptr : &*found;
  }

  Plan plan = make_plan(protocol.design, {protocol.name, "P01", 1});
  std::size_t slots_asked{0};
  std::vector<Page> pages;
  std::function<Answer(const Page&, Answer)> on_other_page;
};

TEST(Training, IsPlannedInFullWithItsConditionsInOrderAgainAndAgain) {
  const TrainingLab lab(1);
  ASSERT_EQ(lab.plan.size(), 7U + 4U);
  for (std::size_t index = 0; index < 7; ++index) {
    EXPECT_EQ(lab.plan[index].phase, TrialPhase::kPractice);
    EXPECT_EQ(lab.plan[index].condition, lab.protocol.design.practice[index % 2]);
    EXPECT_EQ(lab.plan[index].repetition, static_cast<std::int64_t>(index / 2) + 1);
  }
  EXPECT_EQ(lab.plan[7].phase, TrialPhase::kMain);
}

TEST(Training, IsOverAsSoonAsEnoughOfTheLastAnswersWereRight) {
  for (std::int64_t right_from = 1; right_from <= 5; ++right_from) {
    TrainingLab lab(right_from);
    const SessionResult result = lab.run();
    EXPECT_EQ(result.ending, SessionEnding::kFinished);
    EXPECT_EQ(lab.practised(), right_from + 2);
    EXPECT_EQ(lab.titled("Please call the experimenter"), nullptr);
    ASSERT_NE(lab.titled("Practice is over"), nullptr);
    EXPECT_EQ(lab.titled("Practice is over")->paragraphs.front(),
              "You answered 3 of the last 3 right.");
  }
}

TEST(Training, WhoDoesNotLearnPractisesToTheEndAndTheExperimenterDecides) {
  for (const std::size_t decision : {0U, 1U}) {
    TrainingLab lab(6);
    lab.on_other_page = [&](const Page& page, Answer answer) {
      answer.choice = page.title == "Please call the experimenter" ? decision : answer.choice;
      return answer;
    };
    EXPECT_EQ(lab.run().ending, decision == 0 ? SessionEnding::kFinished : SessionEnding::kQuit);
    EXPECT_EQ(lab.practised(), 7);
    EXPECT_EQ(lab.recorder.attempts.size(), decision == 0 ? 11U : 7U);
    EXPECT_EQ(std::count_if(
                  lab.recorder.notes.begin(), lab.recorder.notes.end(),
                  [](const NoteRecord& note) { return note.kind == "practice not understood"; }),
              1);
  }
}

TEST(Training, TellsTheRuleAndAfterEachAnswerWhetherItWasRight) {
  TrainingLab lab(2);
  lab.run();
  ASSERT_NE(lab.titled("Practice"), nullptr);
  EXPECT_EQ(lab.titled("Practice")->paragraphs.back(),
            "Practice ends when 3 of the last 3 answers were right.");
  std::string said;
  for (const Page& page : lab.pages) {
    for (const std::string& paragraph : page.paragraphs) {
      said += paragraph == "That was right."          ? "r"
              : paragraph.starts_with("That was not") ? "w"
                                                      : "";
    }
  }
  EXPECT_EQ(said, "wrrr");
}

TEST(Training, ProgressCountsNoPracticeThatNobodyNeeds) {
  TrainingLab lab(1);
  const SessionResult result = lab.run();
  EXPECT_EQ(result.completed_trials, 3 + 4);
  EXPECT_EQ(result.expected_trials, 3 + 4);
  EXPECT_EQ(lab.display.pictures.front().progress.label, "Practice 1 of at most 7");
  EXPECT_EQ(lab.pages.back().progress.done, lab.pages.back().progress.total);
}

TEST(Training, NamedExtremesAreShownBeforeItAndAgainOnRequest) {
  json protocol = training_protocol();
  protocol["session"]["demonstrations"] = json::parse(R"([
    {"id": "best", "title": "No delay", "paragraphs": [], "set": {"/imposed/contact_hold_ms": 0}},
    {"id": "worst", "title": "Delay", "paragraphs": [], "set": {"/imposed/contact_hold_ms": 300}}])");
  TrainingLab lab(1, protocol);
  int asked_again = 0;
  lab.on_other_page = [&](const Page& page, Answer answer) {
    answer.choice = page.title == "That was: Delay" && asked_again++ < 2 ? 1 : answer.choice;
    return answer;
  };
  EXPECT_EQ(lab.run().ending, SessionEnding::kFinished);
  std::vector<std::string> shown;
  for (const NoteRecord& note : lab.recorder.notes) {
    shown.push_back(note.kind + " " + note.text);
  }
  EXPECT_EQ(shown, (std::vector<std::string>{"demonstration best", "demonstration worst",
                                             "demonstration worst", "demonstration worst"}));
}

TEST(Training, AnswersThatCameTooLateAreNotRight) {
  TrainingLab lab(1);
  lab.on_other_page = [&](const Page& page, Answer answer) {
    answer.timed_out = page.response == "yes_no" && lab.slots_asked == 2;
    return answer;
  };
  lab.run();
  EXPECT_EQ(lab.practised(), 5);
}

TEST(Training, GoesOnAfterASessionThatWasQuitWithWhatWasRightThen) {
  const TemporaryFolder folder;
  StudyFile study = opened(folder / "a.sqlite");
  TrainingLab first(1);
  const auto texts = texts_of(first.protocol);
  const Enrolment enrolment = enrol(study, "P01", false, texts, 1, stored(first.plan));
  first.on_other_page = [&](const Page& page, Answer answer) {
    const bool third = page.response == "yes_no" && first.slots_asked == 3;
    answer.interruption = third ? Interruption::kPauseRequested : Interruption::kNone;
    answer.choice = page.title == "Pause" ? 1 : answer.choice;
    return answer;
  };
  {
    StudyWriter writer(study, enrolment, facts());
    const Ports ports{first.display, first.input, first.scenes, writer};
    EXPECT_EQ(run_session(first.protocol.script, first.plan, {}, ports).ending,
              SessionEnding::kQuit);
    writer.end("quit");
  }
  const auto found = find_enrolment(study, "P01", false, texts);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->history.practice.size(), 2U);
  EXPECT_EQ(found->history.practice.at(1).right, true);
  EXPECT_FALSE(found->history.practice.at(1).rating);
  TrainingLab second(1);
  second.slots_asked = 2;
  EXPECT_EQ(second.run(found->history).ending, SessionEnding::kFinished);
  EXPECT_EQ(second.practised(), 1);
}

// Brute force over all answers of six trials: the rule looks at the last `of` alone.
TEST(Training, TheRuleIsTheOneStated) {
  for (std::int64_t of = 1; of <= 4; ++of) {
    for (std::int64_t right = 1; right <= of; ++right) {
      for (unsigned answers = 0; answers < 64; ++answers) {
        for (std::size_t made = 0; made <= 6; ++made) {
          std::vector<PracticeResult> results(made);
          std::int64_t right_of_last_ones = 0;
          for (std::size_t i = 0; i < made; ++i) {
            results[i].right = (answers >> i & 1U) != 0;
            const bool counts = static_cast<std::int64_t>(made - i) <= of;
            right_of_last_ones += counts && *results[i].right ? 1 : 0;
          }
          EXPECT_EQ(is_trained({right, of, 6}, results),
                    static_cast<std::int64_t>(made) >= of && right_of_last_ones >= right);
        }
      }
    }
  }
}

}  // namespace impetus::training_test
