// SPDX-License-Identifier: MIT
#include "experiments/session/session.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <set>

#include "tests/experiments/fakes.hpp"

namespace impetus::session_test {

SessionResult run(TestLab& lab, const Plan& plan, const SessionHistory& history = {}) {
  return run_session(lab.protocol.script, plan, history, lab.ports());
}

bool showed(const TestLab& lab, const std::string& title) {
  return std::find(lab.input.titles.begin(), lab.input.titles.end(), title) !=
         lab.input.titles.end();
}

TEST(Session, GoesFromWelcomeToThanksInOrder) {
  TestLab lab;
  const Plan plan = short_plan(lab.protocol, 2);
  EXPECT_EQ(run(lab, plan).ending, SessionEnding::kFinished);
  const std::string question = lab.protocol.document.value["rating"]["question"];
  const std::vector<std::string> expected{
      "Welcome",          "Your consent",   "About you",        "What you will see",
      "What you will do", "Practice",       question,           "You answered 1",
      question,           "You answered 1", "Practice is over", "Ready?",
      question,           question,         "One question",     "Thank you!"};
  EXPECT_EQ(lab.input.titles, expected);
  EXPECT_TRUE(lab.recorder.finished);
  EXPECT_EQ(lab.recorder.attempts.size(), 4U);
}

TEST(Session, ABreakComesAfterEvery27MainTrialsButNotAtTheEnd) {
  TestLab lab;
  const Plan plan = make_plan(lab.protocol.design, {"causality", "P01", 1});
  run(lab, plan);
  EXPECT_EQ(std::count(lab.input.titles.begin(), lab.input.titles.end(), "Time for a break"), 2);
}

TEST(Session, WithoutConsentNothingIsShown) {
  TestLab lab;
  lab.input.on_page = [](const Page& page) {
    Answer answer;
    answer.choice = page.title == "Your consent" ? 1 : 0;
    return answer;
  };
  EXPECT_EQ(run(lab, short_plan(lab.protocol, 1)).ending, SessionEnding::kDeclined);
  EXPECT_TRUE(lab.recorder.attempts.empty());
  EXPECT_EQ(lab.recorder.answers.front().answer, "declined");
  EXPECT_FALSE(lab.recorder.finished);
}

/// Chooses, page by page, the label that is next in the list; elsewhere the first choice.
std::function<Answer(const Page&)> choosing(std::deque<std::string> labels) {
  return [labels = std::move(labels)](const Page& page) mutable {
    Answer answer;
    for (std::size_t i = 0; !labels.empty() && i < page.choices.size(); ++i) {
      if (page.choices[i].label == labels.front()) {
        answer.choice = i;
        labels.pop_front();
        break;
      }
    }
    return answer;
  };
}

TEST(Session, ARefusalIsAskedOnceMoreThankedAndStored) {
  TestLab lab;
  lab.input.on_page = choosing({"No, I do not", "Yes, end here"});
  EXPECT_EQ(run(lab, short_plan(lab.protocol, 1)).ending, SessionEnding::kDeclined);
  EXPECT_EQ(lab.input.titles, (std::vector<std::string>{"Welcome", "Your consent",
                                                        "Do you really not want to take part?",
                                                        "Thank you for your time"}));
  ASSERT_EQ(lab.recorder.answers.size(), 1U);
  EXPECT_EQ(lab.recorder.answers[0].answer, "declined");
  EXPECT_EQ(lab.recorder.answers[0].text, lab.protocol.script.consent_statement);
  EXPECT_TRUE(lab.display.pictures.empty());
}

TEST(Session, ARefusalIsSavedBeforeItsThanks) {
  TestLab lab;
  std::size_t awaits = 0;
  lab.input.on_page = [&](const Page& page) {
    Answer answer;
    answer.choice = page.title == "Your consent" ? 1 : 0;
    if (page.title == "Thank you for your time") {
      awaits = lab.recorder.awaited.size();
      answer.interruption = Interruption::kDisplayClosed;
    }
    return answer;
  };
  EXPECT_EQ(run(lab, short_plan(lab.protocol, 1)).ending, SessionEnding::kDeclined);
  EXPECT_EQ(awaits, 1U);
}

TEST(Session, ARefusalThatWasNotMeantLeadsBackToTheConsent) {
  TestLab lab;
  lab.input.on_page = choosing({"No, I do not", "Back", "Yes, I agree"});
  EXPECT_EQ(run(lab, short_plan(lab.protocol, 1)).ending, SessionEnding::kFinished);
  EXPECT_EQ(std::count(lab.input.titles.begin(), lab.input.titles.end(), "Your consent"), 2);
  EXPECT_EQ(lab.recorder.answers.front().answer, "agreed");
  EXPECT_FALSE(showed(lab, "Thank you for your time"));
}

TEST(Session, ConsentAloneNeedsTheEndOfItsPage) {
  TestLab lab;
  lab.input.on_page = [](const Page& page) {
    EXPECT_EQ(page.choice_at_end.has_value(), page.title == "Your consent") << page.title;
    if (page.choice_at_end) {
      EXPECT_EQ(page.choices[*page.choice_at_end].label, "Yes, I agree");
    }
    return Answer{};
  };
  run(lab, short_plan(lab.protocol, 1));
}

TEST(Session, AWayBackLeadsToThePageBeforeWhereNothingWasAnswered) {
  TestLab lab;
  lab.input.on_page = choosing({"Back", "Yes, I agree", "Back"});
  EXPECT_EQ(run(lab, short_plan(lab.protocol, 1)).ending, SessionEnding::kFinished);
  const std::vector<std::string> expected{
      "Welcome",           "Your consent",     "Welcome",           "Your consent",    "About you",
      "What you will see", "What you will do", "What you will see", "What you will do"};
  EXPECT_EQ(std::vector<std::string>(lab.input.titles.begin(), lab.input.titles.begin() + 9),
            expected);
}

TEST(Session, NoWayLeadsBackOverAnAnswer) {
  TestLab lab;
  std::set<std::string> lead_back;
  lab.input.on_page = [&](const Page& page) {
    for (const Choice& choice : page.choices) {
      if (choice.label == "Back") {
        lead_back.insert(page.title);
      }
    }
    return Answer{};
  };
  run(lab, short_plan(lab.protocol, 1));
  EXPECT_EQ(lead_back, (std::set<std::string>{"What you will do", "Your consent"}));
}

TEST(Session, WhatIsAgreedToIsShownAndStoredAsItWasShown) {
  TestLab lab;
  lab.protocol.script.consent_statement = "I agree: 100 %s of <b>it</b>,\nall of it.";
  std::string shown;
  lab.input.on_page = [&](const Page& page) {
    shown += page.title == "Your consent" ? page.statement : "";
    return Answer{};
  };
  run(lab, short_plan(lab.protocol, 1));
  EXPECT_EQ(shown, "I agree: 100 %s of <b>it</b>,\nall of it.");
  EXPECT_EQ(lab.recorder.answers.front().id, "consent");
  EXPECT_EQ(lab.recorder.answers.front().text, shown);
}

TEST(Session, ATrialIsSavedBeforeTheNextIsShown) {
  TestLab lab;
  run(lab, short_plan(lab.protocol, 3));
  // One await before each of the five stimuli, with all attempts before it handed over; then the
  // awaits of the end.
  ASSERT_GE(lab.recorder.awaited.size(), 5U);
  for (std::size_t trial = 0; trial < 5; ++trial) {
    EXPECT_EQ(lab.recorder.awaited[trial], trial);
  }
}

TEST(Session, APausedTrialIsShownAgainAsTheNextAttempt) {
  TestLab lab;
  lab.input.on_frame = [](std::int64_t frame) {
    return frame == 100 ? Interruption::kPauseRequested : Interruption::kNone;
  };
  EXPECT_EQ(run(lab, short_plan(lab.protocol, 1)).ending, SessionEnding::kFinished);
  ASSERT_EQ(lab.recorder.attempts.size(), 4U);
  EXPECT_EQ(lab.recorder.attempts[0].outcome, AttemptOutcome::kInterrupted);
  EXPECT_TRUE(lab.recorder.attempts[0].ratings.empty());
  EXPECT_EQ(lab.recorder.attempts[1].slot, lab.recorder.attempts[0].slot);
  EXPECT_EQ(lab.recorder.attempts[1].number, 2);
  EXPECT_TRUE(showed(lab, "Pause"));
}

TEST(Session, QuittingAsksFirstAndNoGoesBack) {
  TestLab lab;
  lab.input.on_frame = [](std::int64_t frame) {
    return frame == 100 ? Interruption::kPauseRequested : Interruption::kNone;
  };
  int pauses = 0;
  lab.input.on_page = [&](const Page& page) {
    Answer answer;
    if (page.title == "Pause") {
      answer.choice = ++pauses == 1 ? 1 : 0;  // quit, then continue
    } else if (page.title == "Quit the session?") {
      answer.choice = 1;  // no, go back
    }
    return answer;
  };
  EXPECT_EQ(run(lab, short_plan(lab.protocol, 1)).ending, SessionEnding::kFinished);
  EXPECT_EQ(pauses, 2);
}

TEST(Session, AFormThatIsShownAgainAfterAPauseHasWhatWasFilledIn) {
  TestLab lab;
  std::vector<std::string> begins_with;
  lab.input.on_page = [&](const Page& page) {
    Answer answer;
    if (page.title == "About you") {
      begins_with.push_back(page.fields.front().answer);
      answer.fields = {"33"};
      answer.interruption =
          begins_with.size() == 1 ? Interruption::kPauseRequested : Interruption::kNone;
    }
    return answer;
  };
  EXPECT_EQ(run(lab, short_plan(lab.protocol, 1)).ending, SessionEnding::kFinished);
  EXPECT_EQ(begins_with, (std::vector<std::string>{"", "33"}));
}

TEST(Session, QuitThenResumeContinuesAtTheNextTrialInThePlannedOrder) {
  const Plan plan = short_plan(causality(), 5);
  TestLab first;
  int ratings = 0;
  first.input.on_page = [&](const Page& page) {
    Answer answer;
    if (page.layout == Page::Layout::kScale && ++ratings == 5) {
      answer.interruption = Interruption::kPauseRequested;
    }
    answer.choice = page.title == "Pause" ? 1 : 0;
    return answer;
  };
  const SessionResult quit = run(first, plan);
  EXPECT_EQ(quit.ending, SessionEnding::kQuit);
  EXPECT_EQ(quit.completed_trials, 4);

  SessionHistory history;
  history.resumed = true;
  for (const AttemptRecord& attempt : first.recorder.attempts) {
    history.attempts[attempt.slot] = attempt.number;
    if (attempt.outcome == AttemptOutcome::kCompleted) {
      history.completed_slots.insert(attempt.slot);
    }
  }
  for (const QuestionRecord& answer : first.recorder.answers) {
    history.answered.insert(answer.id);
  }
  TestLab second;
  EXPECT_EQ(run(second, plan, history).ending, SessionEnding::kFinished);
  EXPECT_TRUE(showed(second, "Welcome back"));
  EXPECT_FALSE(showed(second, "Your consent"));
  EXPECT_FALSE(showed(second, "About you"));
  EXPECT_TRUE(showed(second, "What you will do"));
  ASSERT_EQ(second.recorder.attempts.size(), 3U);
  EXPECT_EQ(second.recorder.attempts[0].slot, 5);
  EXPECT_EQ(second.recorder.attempts[0].number, 2);
  EXPECT_EQ(second.recorder.attempts[2].slot, 7);
}

TEST(Session, WhatWasNotSavedAboutSomebodyIsAskedAgain) {
  TestLab lab;
  SessionHistory history;
  history.answered = {"consent", lab.protocol.script.demographics.front().id};  // killed amid them
  EXPECT_EQ(run(lab, short_plan(lab.protocol, 1), history).ending, SessionEnding::kFinished);
  ASSERT_GE(lab.recorder.answers.size(), lab.protocol.script.demographics.size() - 1);
  EXPECT_EQ(lab.recorder.answers.front().id, lab.protocol.script.demographics[1].id);
}

TEST(Session, WhoNeverConsentedIsWelcomedAsAnyone) {
  SessionHistory history;
  history.resumed = true;  // the first session ended before a page was answered
  TestLab lab;
  EXPECT_EQ(run(lab, short_plan(lab.protocol, 1), history).ending, SessionEnding::kFinished);
  EXPECT_FALSE(showed(lab, "Welcome back"));
  EXPECT_TRUE(showed(lab, "Your consent"));
}

TEST(Session, AClosedDisplayEndsItWithTheAttemptKept) {
  TestLab lab;
  lab.input.on_frame = [](std::int64_t frame) {
    return frame >= 100 ? Interruption::kDisplayClosed : Interruption::kNone;
  };
  const SessionResult result = run(lab, short_plan(lab.protocol, 1));
  EXPECT_EQ(result.ending, SessionEnding::kDisplayClosed);
  ASSERT_EQ(lab.recorder.attempts.size(), 1U);
  EXPECT_EQ(lab.recorder.notes.back().kind, "display closed");
  const AttemptRecord& kept = lab.recorder.attempts.front();
  std::int64_t last_shown = -1;
  for (const StepRecord& step : kept.steps) {
    last_shown = std::max(last_shown, step.shown_frame);
  }
  EXPECT_EQ(last_shown, kept.frames.back().frame) << "the frame that closed it was shown to nobody";
}

TEST(Session, APauseOnTheFirstFrameOfAStimulusHasShownIt) {
  TestLab lab;
  bool asked = false;
  lab.input.on_frame = [&](std::int64_t /*frame*/) {
    const bool at_first = !asked && !lab.display.pictures.back().bodies.empty();
    asked = asked || at_first;
    return at_first ? Interruption::kPauseRequested : Interruption::kNone;
  };
  run(lab, short_plan(lab.protocol, 1));
  const AttemptRecord& paused = lab.recorder.attempts.front();
  EXPECT_EQ(paused.interrupted_by, "pause");
  EXPECT_EQ(paused.frames.back().phase, FramePhase::kStimulus);
  EXPECT_EQ(paused.onset_ns, paused.frames.back().flip.flipped_ns);
}

TEST(Session, ProgressIsVisibleOnPagesAndBetweenTrialsAndOffStimuli) {
  TestLab lab;
  lab.input.on_page = [](const Page& page) {
    EXPECT_GT(page.progress.total, 0) << page.title;
    EXPECT_FALSE(page.progress.light_ground) << page.title;
    return Answer{};
  };
  run(lab, short_plan(lab.protocol, 1));
  int between = 0;
  for (const Picture& picture : lab.display.pictures) {
    const bool of_stimulus = picture.fixation_cross || !picture.bodies.empty();
    ASSERT_EQ(picture.progress.label.empty(), of_stimulus);
    between += of_stimulus ? 0 : 1;
  }
  EXPECT_GT(between, 0);
  EXPECT_EQ(lab.display.pictures.front().progress.label, "Practice 1 of 2");
}

TEST(Session, ProgressAndLightPagesAreThereWhereTheProtocolAsks) {
  TestLab lab;
  lab.protocol.script.progress_during_stimuli = true;
  lab.protocol.script.light_pages = true;
  lab.input.on_page = [](const Page& page) {
    EXPECT_TRUE(page.progress.light_ground) << page.title;
    return Answer{};
  };
  run(lab, short_plan(lab.protocol, 1));
  for (const Picture& picture : lab.display.pictures) {
    ASSERT_FALSE(picture.progress.label.empty());
  }
  EXPECT_EQ(lab.display.pictures.back().progress.label, "Trial 1 of 1");
}

TEST(Session, PracticeFeedbackTellsTheUseOfTheScale) {
  TestLab lab;
  std::vector<Page> pages;
  lab.input.on_page = [&](const Page& page) {
    pages.push_back(page);
    return Answer{};
  };
  run(lab, short_plan(lab.protocol, 1));
  const auto summary = std::find_if(pages.begin(), pages.end(), [](const Page& page) {
    return page.title == "Practice is over";
  });
  ASSERT_NE(summary, pages.end());
  EXPECT_EQ(
      summary->paragraphs,
      (std::vector<std::string>{"1 (“very believable”): 2 times",
                                "2 (between “very believable” and “very unbelievable”): "
                                "not used",
                                "3 (“very unbelievable”): not used",
                                "You used one point only. The whole scale is there for you."}));
}

TEST(Session, ABreakComesAfterEachBlockWhereTheProtocolSaysNoNumber) {
  TestLab lab;
  lab.protocol.script.break_every = 0;
  Design design = lab.protocol.design;
  design.blocks = Blocks{{"delay_ms"}, Blocks::Order::kFixed};
  design.longest_runs.clear();
  run(lab, make_plan(design, {"causality", "P01", 1}));
  std::vector<std::string> breaks;
  for (const NoteRecord& note : lab.recorder.notes) {
    if (note.kind == "break") {
      breaks.push_back(note.text);
    }
  }
  EXPECT_EQ(breaks, (std::vector<std::string>{"after main trial 27", "after main trial 54"}));
}

TEST(Session, WhatIsAdaptedToIsShownWithoutACrossOrAQuestionAndCountsForNothing) {
  TestLab lab;
  Plan plan = short_plan(lab.protocol, 2);
  const std::size_t first = plan.size() - 2;
  for (std::size_t i = first; i < first + 3; ++i) {
    PlannedTrial adaptor = plan[i];
    adaptor.phase = TrialPhase::kAdaptation;
    plan.insert(plan.begin() + static_cast<std::ptrdiff_t>(first), adaptor);
  }
  for (std::size_t i = 0; i < plan.size(); ++i) {
    plan[i].slot = static_cast<std::int64_t>(i) + 1;
  }
  EXPECT_EQ(run(lab, plan).ending, SessionEnding::kFinished);
  ASSERT_EQ(lab.recorder.attempts.size(), plan.size());
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const AttemptRecord& attempt = lab.recorder.attempts[i];
    EXPECT_EQ(attempt.ratings.size(), plan[i].is_asked() ? 1U : 0U);
    const bool has_cross =
        std::any_of(attempt.frames.begin(), attempt.frames.end(),
                    [](const FrameRecord& frame) { return frame.phase == FramePhase::kFixation; });
    EXPECT_EQ(has_cross, plan[i].is_asked()) << i;
    EXPECT_FALSE(attempt.steps.empty());
  }
  const std::vector<Picture>& pictures = lab.display.pictures;
  const auto is_shown = [&](const std::string& label) {
    return std::any_of(pictures.begin(), pictures.end(),
                       [&](const Picture& picture) { return picture.progress.label == label; });
  };
  EXPECT_TRUE(is_shown("Trial 1 of 2"));
  EXPECT_TRUE(is_shown("Trial 2 of 2"));
  EXPECT_FALSE(is_shown("Trial 3 of 5")) << "counts what is asked";
}

}  // namespace impetus::session_test
