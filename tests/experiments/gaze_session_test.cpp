// Sessions of the gaze-contingent study: demonstrations, practice until it is understood.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/experiments/refusals.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::gaze_session_test {

/// The shipped study with stimuli of a tenth of a second and one repetition.
Protocol tiny_study(const std::function<void(json& protocol, json& scene)>& change = {}) {
  json protocol = json::parse(shipped("protocols/gaze-contingent.json"));
  json scene = json::parse(shipped("stimuli/l-blocks-in-a-cube.json"));
  scene["duration_s"] = 0.1;
  protocol["gaze"].erase("calibration");
  protocol["design"]["repetitions"] = 1;
  protocol["design"]["factors"][1]["levels"] = {5, 10, 15};
  if (change) {
    change(protocol, scene);
  }
  return make_protocol(parse_json("gaze.json", protocol.dump()),
                       parse_json("cube.json", scene.dump()));
}

/// A participant who clicks in every trial or in none, and rates by the scene's scheduling.
struct PracticeLab : TestLab {
  PracticeLab() : TestLab(60.0, tiny_study()), eye(clock, 0) {
    gaze = &eye;
    eye.at = [](std::int64_t taken_ns) {
      return taken_ns % 7 == 0 ? Fixation{} : Fixation{{0.01, -0.02}};
    };
    input.on_clicks = [this]() -> std::vector<ClickRecord> {
      return clicks ? std::vector<ClickRecord>{{"mouse", clock.now_ns(), 0}}
                    : std::vector<ClickRecord>{};
    };
    input.on_page = [this](const Page& page) {
      Answer answer;
      if (page.layout == Page::Layout::kScale) {
        const PlannedTrial& trial = plan[recorder.attempts.size()];
        const auto& kind = std::get<std::string>(trial.condition.front().value);
        answer.choice = !rates_well ? 2 : kind == "all-good" ? 4 : kind == "all-bad" ? 0 : 2;
      }
      return on_other_page ? on_other_page(page, answer) : answer;
    };
  }

  SessionResult run(const SessionHistory& history = {}) {
    return run_session(protocol.script, plan, history, ports());
  }
  [[nodiscard]] std::int64_t titled(const std::string& title) const {
    return std::count(input.titles.begin(), input.titles.end(), title);
  }
  [[nodiscard]] std::int64_t practised() const {
    return std::count_if(recorder.attempts.begin(), recorder.attempts.end(),
                         [](const AttemptRecord& attempt) { return attempt.slot <= 12; });
  }
  [[nodiscard]] std::int64_t noted(const std::string& kind) const {
    return std::count_if(recorder.notes.begin(), recorder.notes.end(),
                         [&](const NoteRecord& note) { return note.kind == kind; });
  }

  ScriptedGaze eye;
  Plan plan = make_plan(protocol.design, {protocol.name, "P01", 1});
  bool clicks{true};
  bool rates_well{true};
  std::function<Answer(const Page&, Answer)> on_other_page;
};

TEST(GazeSession, ThreeRoundsOfPracticeArePlannedBeforeTheMainTrials) {
  const PracticeLab lab;
  ASSERT_EQ(lab.plan.size(), 3U * 4U + 12U);
  EXPECT_EQ(lab.plan[4].condition, lab.plan[0].condition);
  EXPECT_EQ(lab.plan[4].repetition, 2);
  EXPECT_EQ(lab.plan[11].phase, TrialPhase::kPractice);
  EXPECT_EQ(lab.plan[12].phase, TrialPhase::kMain);
}

TEST(GazeSession, WhoUnderstandsPractisesOnce) {
  PracticeLab lab;
  const SessionResult result = lab.run();
  EXPECT_EQ(result.ending, SessionEnding::kFinished);
  EXPECT_EQ(lab.practised(), 4);
  EXPECT_EQ(lab.recorder.attempts.size(), 4U + 12U);
  EXPECT_EQ(result.completed_trials, 16);
  EXPECT_EQ(result.expected_trials, 16);
  EXPECT_EQ(lab.titled("Practice is over"), 1);
  EXPECT_EQ(lab.titled("Once more"), 0);
}

TEST(GazeSession, WhoNeverClicksPractisesAgainUntilTheExperimenterDecides) {
  PracticeLab lab;
  lab.clicks = false;
  EXPECT_EQ(lab.run().ending, SessionEnding::kFinished);
  EXPECT_EQ(lab.practised(), 12);
  EXPECT_EQ(lab.titled("Once more"), 2);
  EXPECT_EQ(lab.titled("Please call the experimenter"), 1);
  EXPECT_EQ(lab.noted("practice not understood"), 1);
}

TEST(GazeSession, TheExperimenterMayStopWhoDidNotUnderstand) {
  PracticeLab lab;
  lab.rates_well = false;
  lab.on_other_page = [](const Page& page, Answer answer) {
    answer.choice = page.title == "Please call the experimenter" ? 1 : answer.choice;
    return answer;
  };
  EXPECT_EQ(lab.run().ending, SessionEnding::kQuit);
  EXPECT_EQ(lab.recorder.attempts.size(), 12U);
  EXPECT_EQ(lab.noted("quit"), 1);
}

TEST(GazeSession, WhoLearnsInTheSecondRoundGoesOn) {
  PracticeLab lab;
  lab.clicks = false;
  lab.on_other_page = [&](const Page& page, const Answer& answer) {
    lab.clicks = lab.clicks || page.title == "Once more";
    return answer;
  };
  EXPECT_EQ(lab.run().ending, SessionEnding::kFinished);
  EXPECT_EQ(lab.practised(), 8);
  EXPECT_EQ(lab.titled("Once more"), 1);
  EXPECT_EQ(lab.titled("Please call the experimenter"), 0);
}

TEST(GazeSession, ARoundDoneInAnEarlierSessionCounts) {
  PracticeLab lab;
  SessionHistory history;
  history.resumed = true;
  for (std::int64_t slot = 1; slot <= 4; ++slot) {
    history.completed_slots.insert(slot);
    // Slots 1 and 4 are all bad, 2 is all good.
    history.practice[slot] = {{}, slot == 2 ? 5 : 1, 1};
  }
  EXPECT_EQ(lab.run(history).ending, SessionEnding::kFinished);
  EXPECT_EQ(lab.practised(), 0);
  EXPECT_EQ(lab.recorder.attempts.size(), 12U);
}

TEST(GazeSession, WhoComesBackAfterAllRoundsIsNotToldToPractiseOnceMore) {
  PracticeLab lab;
  SessionHistory history;
  history.resumed = true;
  for (std::int64_t slot = 1; slot <= 12; ++slot) {
    history.completed_slots.insert(slot);
    history.practice[slot] = {{}, 1, 0};  // never a click
  }
  EXPECT_EQ(lab.run(history).ending, SessionEnding::kFinished);
  EXPECT_EQ(lab.practised(), 0);
  EXPECT_EQ(lab.titled("Once more"), 0);
  EXPECT_EQ(lab.titled("Please call the experimenter"), 1);
}

TEST(GazeSession, DemonstrationsAreShownNamedAndAgainOnRequest) {
  PracticeLab lab;
  bool again = true;
  lab.on_other_page = [&](const Page& page, Answer answer) {
    if (page.title == "That was: Bad collisions" && again) {
      answer.choice = 1;
      again = false;
    }
    return answer;
  };
  lab.run();
  EXPECT_EQ(lab.titled("Good collisions"), 1);
  EXPECT_EQ(lab.titled("That was: Bad collisions"), 2);
  EXPECT_EQ(lab.titled("That was: The worst simulation: 1"), 1);
  EXPECT_EQ(lab.noted("demonstration"), 5);
}

TEST(GazeSession, ADemonstrationShowsWhatItSets) {
  PracticeLab lab;
  lab.run();
  const Picture* first = nullptr;
  for (const Picture& picture : lab.display.pictures) {
    if (!picture.bodies.empty()) {
      first = &picture;
      break;
    }
  }
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->bodies.size(), 2U);
  EXPECT_TRUE(first->enclosure);
}

TEST(GazeSession, APauseInADemonstrationGoesOnAfterwards) {
  PracticeLab lab;
  lab.input.on_frame = [](std::int64_t frame) {
    return frame == 20 ? Interruption::kPauseRequested : Interruption::kNone;
  };
  EXPECT_EQ(lab.run().ending, SessionEnding::kFinished);
  EXPECT_EQ(lab.noted("pause"), 1);
}

TEST(GazeSession, PracticeSaysHowOftenWasClicked) {
  PracticeLab lab;
  std::vector<std::string> words;
  lab.on_other_page = [&](const Page& page, const Answer& answer) {
    if (page.title.starts_with("You answered")) {
      words.push_back(page.paragraphs.front());
    }
    return answer;
  };
  lab.clicks = false;
  lab.run();
  ASSERT_FALSE(words.empty());
  EXPECT_EQ(words.front(), "You did not click.");
}

TEST(GazeSession, WhatWasSavedReplaysAndResumes) {
  const TemporaryFolder folder;
  PracticeLab lab;
  lab.run();
  StudyFile study = opened(folder / "gaze.sqlite");
  const Enrolment enrolment =
      enrol(study, "P01", false, texts_of(lab.protocol), 1, stored(lab.plan));
  {
    StudyWriter writer(study, enrolment, facts());
    for (const AttemptRecord& attempt : lab.recorder.attempts) {
      writer.save(attempt);
    }
    writer.await_saved();
  }
  for (const StoredAttempt& attempt : load_attempts(study)) {
    const std::vector<StepRecord> steps = load_steps(study.database(), attempt.id);
    const auto record =
        std::find_if(lab.recorder.attempts.begin(), lab.recorder.attempts.end(),
                     [&](const AttemptRecord& one) { return one.slot == attempt.trial.slot; });
    ASSERT_EQ(steps.size(), record->steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
      EXPECT_EQ(steps[i].gaze.fixation, record->steps[i].gaze.fixation);
      EXPECT_EQ(steps[i].gaze.taken_ns, record->steps[i].gaze.taken_ns);
      EXPECT_EQ(steps[i].gaze.age_ns, record->steps[i].gaze.age_ns);
      EXPECT_EQ(steps[i].gaze.region.has_value(), record->steps[i].gaze.region.has_value());
      EXPECT_EQ(steps[i].shown_frame, record->steps[i].shown_frame);
    }
    EXPECT_EQ(load_clicks(study, attempt.id).size(), record->clicks.size());
    const std::vector<GazeSample> gaze = load_gaze(study, attempt.id);
    ASSERT_EQ(gaze.size(), record->gaze.size());
    for (std::size_t i = 0; i < gaze.size(); ++i) {
      EXPECT_EQ(gaze[i].taken_ns, record->gaze[i].taken_ns);
      EXPECT_EQ(gaze[i].at, record->gaze[i].at);
      EXPECT_EQ(gaze[i].loss, record->gaze[i].loss);
    }
  }
  const auto found = find_enrolment(study, "P01", false, texts_of(lab.protocol));
  EXPECT_EQ(found->history.practice.size(), 4U);
  EXPECT_EQ(found->history.practice.at(2).rating, 5);
  EXPECT_GT(found->history.practice.at(1).clicks, 0);
}

// ---------------------------------------------------------------- refusals

std::string study_refusal(const std::function<void(json& protocol, json& scene)>& change) {
  return refusal([&] { tiny_study(change); });
}

TEST(GazeProtocol, ARegionAtTheGazeNeedsAGaze) {
  EXPECT_EQ(study_refusal([](json& protocol, json&) { protocol.erase("gaze"); }),
            "gaze.json:/: expected the key \"gaze\", because the detail of collisions depends on "
            "the gaze under {\"bodies\":5,\"scheduling\":\"tracked\"}, but it is missing");
}

TEST(GazeProtocol, AnUnknownKindOfRegionIsRefusedWithTheKnownOnes) {
  EXPECT_EQ(study_refusal([](json& protocol, json&) {
              protocol["design"]["factors"][0]["levels"][3] = "yoked";
            }),
            "gaze.json:/design/factors/0/levels/3: expected one of \"all-good\", \"all-bad\", "
            "\"tracked\", \"random\", \"fixed\", \"recorded\", got \"yoked\"");
}

TEST(GazeProtocol, ADemonstrationNeedsNoGazeAndSetsSingleValues) {
  EXPECT_EQ(study_refusal([](json& protocol, json&) {
              protocol["session"]["demonstrations"][0]["set"]["/engine/region/kind"] = "tracked";
            }),
            "gaze.json:/session/demonstrations/0/set: expected a scene whose detail does not "
            "depend on the gaze, which is not followed yet");
  EXPECT_EQ(study_refusal([](json& protocol, json&) {
              protocol["session"]["demonstrations"][1]["set"]["/crowd/number"] = 3;
            }),
            "gaze.json:/session/demonstrations/1/set: expected pointers to single values of "
            "cube.json, got \"/crowd/number\"");
  EXPECT_EQ(study_refusal([](json& protocol, json&) {
              protocol["session"]["demonstrations"][1]["id"] = "good_collisions";
            }),
            "gaze.json:/session/demonstrations/1/id: expected an id of its own, got "
            "\"good_collisions\" again");
}

TEST(GazeProtocol, PracticeIsJudgedByLevelsThatArePractised) {
  EXPECT_EQ(study_refusal([](json& protocol, json&) {
              protocol["design"]["practice_until"]["best"] = "random";
            }),
            "gaze.json:/design/practice_until/best: expected a level of scheduling that is "
            "practised, got \"random\"");
  EXPECT_EQ(study_refusal([](json& protocol, json&) {
              protocol["design"]["practice_until"]["factor"] = "kind";
            }),
            "gaze.json:/design/practice_until/factor: expected the name of a factor, got \"kind\"");
}

TEST(GazeProtocol, EveryCellMustHaveRoomForItsCrowd) {
  EXPECT_EQ(study_refusal([](json&, json& scene) { scene["enclosure"].erase("edge_at_count"); }),
            "accepted");
  EXPECT_EQ(study_refusal([](json& protocol, json& scene) {
              scene["enclosure"].erase("edge_at_count");
              protocol["design"]["factors"][1]["levels"] = {5, 10, 900};
            }),
            "gaze.json:/design/factors/1/levels/2: expected as many bodies as the enclosure has "
            "room for, got 900");
}

}  // namespace impetus::gaze_session_test
