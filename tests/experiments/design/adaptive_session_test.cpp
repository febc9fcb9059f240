// Adaptive levels in a session: chosen one by one, stored before they are shown, resumed, derived
// anew.
// SPDX-License-Identifier: MIT
#include "experiments/design/adaptive_levels.hpp"

#include <gtest/gtest.h>

#include <map>

#include "experiments/questions/response_kinds.hpp"
#include "experiments/store/adaptive_rows.hpp"
#include "tests/experiments/asked_study.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::adaptive_session_test {

/// Two tracks of six trials, one for each speed, by a staircase over four delays.
Protocol adaptive_protocol() {
  json protocol = asked_protocol({kAskYesNo});
  json& design = protocol["design"];
  design["factors"] = json::parse(R"([
    {"name": "delay_ms", "pointer": "/imposed/contact_hold_ms", "levels": [0, 100, 200, 300]},
    {"name": "speed_deg_s", "pointer": "/meeting/speed_deg_s", "levels": [5, 10]}])");
  design["repetitions"] = 1;
  design["practice"] = json::array();
  design.erase("longest_runs");
  design["adaptive"] = json::parse(R"({"factor": "delay_ms", "trials_per_track": 6,
    "staircase": {"up": 1, "down": 1, "starts": [300]}})");
  return study_of(protocol);
}

constexpr std::int64_t kTrials = 12;

double level_in(const Condition& condition, std::size_t factor) {
  return std::get<double>(condition.at(factor).value);
}

/// A participant who answers yes to delays of 200 ms and more; the seventh trial times out.
struct AdaptiveLab : TestLab {
  AdaptiveLab() : TestLab(60.0, adaptive_protocol()) {
    input.on_page = [this](const Page& page) {
      Answer answer;
      if (page.response == "yes_no") {
        answer.choice = level_in(recorder.levels.back().condition, 0) >= 200.0 ? 0 : 1;
        answer.timed_out = ++asked_so_far == 7;
      }
      return on_answer ? on_answer(page, answer) : answer;
    };
  }

  SessionResult run(const SessionHistory& history = {}) {
    return run_session(protocol.script, plan, history, ports(), protocol.design);
  }

  /// The session's trials as a study would give them back.
  [[nodiscard]] std::vector<RecordedLevel> recorded() const {
    std::vector<RecordedLevel> levels;
    for (const ChosenLevel& chosen : recorder.levels) {
      RecordedLevel level;
      level.trial_id = 100 + chosen.slot;
      level.chosen = chosen;
      level.track = *plan[static_cast<std::size_t>(chosen.slot) - 1].track;
      for (const AttemptRecord& attempt : recorder.attempts) {
        if (attempt.slot == chosen.slot && attempt.outcome == AttemptOutcome::kCompleted) {
          level.completed = true;
          level.counted_answer = counted_answer(attempt);
        }
      }
      levels.push_back(level);
    }
    return levels;
  }

  Plan plan = make_plan(protocol.design, {protocol.name, "P01", 1});
  int asked_so_far{0};
  std::function<Answer(const Page&, Answer)> on_answer;
};

TEST(AdaptiveSession, EveryTrackGoesItsOwnWayByItsOwnAnswers) {
  AdaptiveLab lab;
  EXPECT_EQ(lab.run().ending, SessionEnding::kFinished);
  ASSERT_EQ(lab.recorder.levels.size(), static_cast<std::size_t>(kTrials));
  std::map<double, std::vector<double>> delays;
  for (const ChosenLevel& chosen : lab.recorder.levels) {
    delays[level_in(chosen.condition, 1)].push_back(level_in(chosen.condition, 0));
  }
  ASSERT_EQ(delays.size(), 2U);
  // 300 and 200 are seen, 100 is not, and so on; a trial that timed out changes nothing.
  const std::vector<double> undisturbed{300, 200, 100, 200, 100, 200};
  int disturbed = 0;
  for (const auto& [speed, shown] : delays) {
    ASSERT_EQ(shown.size(), 6U);
    disturbed += shown == undisturbed ? 0 : 1;
  }
  EXPECT_EQ(disturbed, 1);
}

TEST(AdaptiveSession, ATrialThatTimedOutCountsInItsTrackButLeavesItsStateAsItWas) {
  AdaptiveLab lab;
  lab.run();
  const std::int64_t track = *lab.plan[6].track;
  std::vector<FactorLevel> before = lab.recorder.levels[6].state;
  for (std::size_t next = 7; next < lab.plan.size(); ++next) {
    if (lab.plan[next].track == track) {
      before[0].value = std::get<double>(before[0].value) + 1.0;
      EXPECT_EQ(before[0].factor, "trials");
      EXPECT_EQ(lab.recorder.levels[next].state, before);
      return;
    }
  }
  FAIL() << "the track has no later trial";
}

TEST(AdaptiveSession, WhatIsShownIsTheLevelThatWasChosen) {
  AdaptiveLab lab;
  lab.run();
  for (std::size_t trial = 0; trial < lab.recorder.attempts.size(); ++trial) {
    EXPECT_DOUBLE_EQ(lab.recorder.attempts[trial].realised_hold_s * 1e3,
                     level_in(lab.recorder.levels[trial].condition, 0));
  }
}

TEST(AdaptiveSession, ATrialShownAgainAfterAPauseKeepsItsLevel) {
  AdaptiveLab lab;
  lab.input.on_frame = [](std::int64_t frame) {
    return frame == 60 ? Interruption::kPauseRequested : Interruption::kNone;
  };
  lab.run();
  EXPECT_EQ(lab.recorder.attempts.size(), static_cast<std::size_t>(kTrials) + 1);
  EXPECT_EQ(lab.recorder.levels.size(), static_cast<std::size_t>(kTrials));
}

// ---------------------------------------------------------------- stored and resumed

std::string all_levels(const std::filesystem::path& path) {
  return value_of(path,
                  "SELECT group_concat(condition || coalesce(adaptive_state, 'not chosen'), ' ') "
                  "FROM (SELECT * FROM trial ORDER BY slot)");
}

/// Says yes to a freeze of 200 ms and more, and quits at the question after `most`.
class SeeingParticipant final : public Input {
 public:
  SeeingParticipant(VirtualClock& clock, int most) : clock_(&clock), most_(most) {}

  Answer ask(const Page& page) override {
    Answer answer;
    answer.fields.resize(page.fields.size());
    answer.device = "simulated";
    answer.shown_ns = clock_->now_ns();
    clock_->advance_by(500'000'000);
    answer.arrived_ns = clock_->now_ns();
    if (page.response == "yes_no") {
      answer.choice = hold_s_ >= 0.2 ? 0 : 1;
      answer.interruption = ++asked_ > most_ ? Interruption::kPauseRequested : Interruption::kNone;
    }
    answer.choice = page.title == "Pause" ? 1 : answer.choice;
    return answer;
  }
  Interruption interruption() override { return Interruption::kNone; }
  void witnessed(const AttemptRecord& shown, const StagedScene& /*scene*/) override {
    hold_s_ = shown.realised_hold_s;
  }

 private:
  VirtualClock* clock_;
  int most_;
  int asked_{0};
  double hold_s_{0.0};
};

/// The study's only participant, who comes for one sitting.
struct StoredLab : TestLab {
  explicit StoredLab(const std::filesystem::path& path)
      : TestLab(60.0, adaptive_protocol()), study(opened(path)) {}

  SessionEnding run(int most) {
    std::optional<Enrolment> enrolment = find_enrolment(study, "P01", false, texts_of(protocol));
    if (!enrolment) {
      const Plan plan = make_plan(protocol.design, {protocol.name, "P01", 1});
      enrolment = enrol(study, "P01", false, texts_of(protocol), 1, stored(plan));
    }
    Plan plan;
    for (const StoredTrial& trial : enrolment->trials) {
      plan.push_back({trial.slot, trial.phase, trial.repetition,
                      condition_from_json(json::parse(trial.condition), protocol.design),
                      trial.seed, trial.block, trial.catch_trial, trial.track});
    }
    SeeingParticipant participant(clock, most);
    StudyWriter writer(study, *enrolment, facts());
    const Ports ports{display, participant, scenes, writer, nullptr, &clock, &clock};
    return run_session(protocol.script, plan, enrolment->history, ports, protocol.design).ending;
  }

  StudyFile study;
};

TEST(AdaptiveSession, InterruptedThenResumedEqualsUninterrupted) {
  const TemporaryFolder folder;
  {
    StoredLab whole(folder / "whole.sqlite");
    EXPECT_EQ(whole.run(100), SessionEnding::kFinished);
  }
  for (int sitting = 0; sitting < 4; ++sitting) {
    StoredLab part(folder / "parts.sqlite");
    const SessionEnding ending = part.run(3);
    EXPECT_EQ(ending, sitting < 3 ? SessionEnding::kQuit : SessionEnding::kFinished);
  }
  const std::string levels = all_levels(folder / "whole.sqlite");
  EXPECT_EQ(levels.find("not chosen"), std::string::npos);
  EXPECT_EQ(all_levels(folder / "parts.sqlite"), levels);
}

TEST(AdaptiveSession, AChosenLevelIsNeverOverwritten) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "a.sqlite";
  StoredLab lab(path);
  lab.run(1);
  const std::string before = all_levels(path);
  EXPECT_EQ(sentence_of([&] {
              update_chosen_level(lab.study.database(), 1, {1, {{"delay_ms", 0.0}}, {}});
            }),
            "trial 1 has its level already");
  EXPECT_EQ(all_levels(path), before);
}

TEST(AdaptiveSession, NumbersAreStoredWithEveryDigitAndTextWithEveryLetter) {
  const std::vector<FactorLevel> values{
      {"threshold", 1.0 / 3.0}, {"b", true}, {"a", std::string("say \"x\"\n")}, {"n", 1e-300}};
  const json read = json::parse(to_json(values).dump());
  EXPECT_EQ(read["threshold"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(read["n"].get<double>(), 1e-300);
  EXPECT_EQ(read["b"].get<bool>(), true);
  EXPECT_EQ(read["a"].get<std::string>(), "say \"x\"\n");
  EXPECT_EQ(to_json(Condition{{"b", 2.0}, {"a", 1.0}}).dump(), R"({"a":1,"b":2})");
}

// ---------------------------------------------------------------- derived anew

TEST(AdaptiveReplay, DerivesEveryLevelAndStateAsItWas) {
  AdaptiveLab lab;
  lab.run();
  EXPECT_TRUE(level_divergences(lab.protocol.design, lab.recorded()).empty());
}

TEST(AdaptiveReplay, TellsALevelThatAnotherOneShouldHaveBeen) {
  AdaptiveLab lab;
  lab.run();
  std::vector<RecordedLevel> recorded = lab.recorded();
  recorded[4].chosen.condition[0].value = 0.0;
  const auto divergences = level_divergences(lab.protocol.design, recorded);
  ASSERT_GE(divergences.size(), 1U);
  EXPECT_EQ(divergences[0].trial_id, 105);
  EXPECT_EQ(divergences[0].words, "the level chosen was 0, derived anew it is " +
                                      to_text(lab.recorder.levels[4].condition[0].value));
}

TEST(AdaptiveReplay, TellsATrackThatTheDesignHasNot) {
  AdaptiveLab lab;
  lab.run();
  Design design = lab.protocol.design;
  design.adaptive.reset();
  const auto divergences = level_divergences(design, lab.recorded());
  ASSERT_EQ(divergences.size(), lab.recorded().size());
  EXPECT_EQ(divergences[0].words,
            "its track is " + std::to_string(lab.recorded()[0].track) + ", but the design has 0");
}

TEST(AdaptiveReplay, TellsAChangedAnswerAtTheNextTrialOfItsTrack) {
  AdaptiveLab lab;
  lab.run();
  std::vector<RecordedLevel> recorded = lab.recorded();
  recorded[0].counted_answer = !recorded[0].counted_answer.value();
  const auto divergences = level_divergences(lab.protocol.design, recorded);
  ASSERT_EQ(divergences.size(), 1U);  // the first of the track
  std::size_t next = 1;
  while (recorded[next].track != recorded[0].track) {
    ++next;
  }
  EXPECT_EQ(divergences[0].trial_id, recorded[next].trial_id);
  EXPECT_EQ(divergences[0].words, "the level chosen was 200, derived anew it is 300");
}

}  // namespace impetus::adaptive_session_test
