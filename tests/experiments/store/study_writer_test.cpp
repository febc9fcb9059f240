// What a session keeps in its study, and that it says in one sentence when it cannot.
// SPDX-License-Identifier: MIT
#include "experiments/run/live_run.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::study_writer_test {

/// Saves the recorded attempts one by one until one fails; returns how many were acknowledged and
/// the sentence: "3 file: could not ...".
std::string save_until_refused(EnrolledStudy& at, const std::function<void()>& fill_disk) {
  StudyWriter writer(at.study, at.enrolment, facts());
  int acknowledged = 0;
  for (const AttemptRecord& attempt : recorded_attempts()) {
    if (acknowledged == 3) {
      fill_disk();
    }
    writer.save(attempt);
    const std::string sentence = sentence_of([&] { writer.await_saved(); });
    if (sentence != "accepted") {
      // What comes after a gap must not stand in the file as if there were none.
      writer.save(QuestionRecord{"question", "strategy", "How?", "later"});
      EXPECT_EQ(sentence_of([&] { writer.await_saved(); }), sentence);
      return std::to_string(acknowledged) + " " + sentence;
    }
    ++acknowledged;
  }
  return "accepted";
}

void expect_three_whole_attempts(const std::filesystem::path& path) {
  opened(path);  // Opens, and leaves one file.
  EXPECT_EQ(value_of(path, "PRAGMA integrity_check"), "ok");
  EXPECT_EQ(value_of(path,
                     "SELECT group_concat(slot) FROM attempt JOIN trial "
                     "ON trial.id = trial_id WHERE outcome = 'completed'"),
            "1,2,3");
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM answer"), "0");
  StudyFile study = StudyFile::open_for_reading(path);
  for (const StoredAttempt& attempt : load_attempts(study)) {
    const auto slot = static_cast<std::size_t>(attempt.trial.slot);
    EXPECT_EQ(load_steps(study.database(), attempt.id).size(),
              recorded_attempts()[slot - 1].steps.size());
  }
}

TEST(StudyWriter, AFullDatabaseEndsInOneSentenceAndKeepsWhatWasAcknowledged) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  {
    EnrolledStudy at(path);
    EXPECT_EQ(
        save_until_refused(at, [&] { at.study.database().exec("PRAGMA max_page_count = 1"); }),
        "3 " + path +
            ": could not be written (database or disk is full); everything up to the last "
            "completed trial is saved");
  }
  expect_three_whole_attempts(path);
}

TEST(StudyWriter, AFileThatMayNotGrowEndsInOneSentenceAndKeepsWhatWasAcknowledged) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  recorded_attempts();
  EXPECT_EQ(in_child([&] {
              EnrolledStudy at(path);
              return save_until_refused(at, [&] {
                // The log grows by far more than this with every trial.
                const rlim_t size = std::filesystem::file_size(path + "-wal") + 5000;
                const rlimit limit{size, size};
                std::signal(SIGXFSZ, SIG_IGN);
                setrlimit(RLIMIT_FSIZE, &limit);
              });
            }),
            "3 " + path +
                ": could not be written (disk I/O error); everything up to the last completed "
                "trial is saved");
  expect_three_whole_attempts(path);
}

/// A study in which nothing but this attempt was recorded.
void save_alone(const AttemptRecord& attempt, const std::string& path, bool keeps_steps = true) {
  EnrolledStudy at(path);
  StudyWriter writer(at.study, at.enrolment, facts());
  if (!keeps_steps) {
    writer.keep_no_steps();
  }
  writer.save(attempt);
  writer.end("quit");
}

TEST(StudyWriter, AStepIsKeptBitForBit) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  AttemptRecord attempt = recorded_attempts()[0];
  ASSERT_GT(attempt.steps.size(), 100U);
  attempt.steps[1].state.hash = std::numeric_limits<std::uint64_t>::max();
  attempt.steps[2].state.hash = std::uint64_t{1} << 63;
  attempt.steps[3].state.hash = 0;
  attempt.steps[4].state.bodies[0] = {0x0000, 0xffff, 0x00ff, 0xff00};
  attempt.steps[5].degradations = 0xffffffffU;
  attempt.steps[6].work_granted = std::numeric_limits<std::int64_t>::max();
  attempt.steps[7].cut_work.of(WorkPhase::kEntry) = 1'200;
  attempt.steps[7].cut_work.of(WorkPhase::kVisible) = 0;
  attempt.steps[8].shown_frame = -1;
  attempt.steps[9].shown_frame = 12;
  save_alone(attempt, path);
  StudyFile study = StudyFile::open_for_reading(path);
  const std::vector<StepRecord> steps = load_steps(study.database(), 1);
  ASSERT_EQ(steps.size(), attempt.steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i].step, attempt.steps[i].step);
    EXPECT_EQ(steps[i].work_granted, attempt.steps[i].work_granted);
    EXPECT_EQ(steps[i].work_spent, attempt.steps[i].work_spent);
    EXPECT_EQ(steps[i].degradations, attempt.steps[i].degradations);
    EXPECT_EQ(steps[i].cut_work, attempt.steps[i].cut_work);
    EXPECT_EQ(steps[i].state.hash, attempt.steps[i].state.hash);
    EXPECT_EQ(steps[i].state.bodies, attempt.steps[i].state.bodies);
  }
  const auto shown_in = [&](const char* step) {
    return study.database()
        .execAndGet(std::string("SELECT ifnull(shown_frame, 'none') FROM step WHERE step = ") +
                    step)
        .getString();
  };
  EXPECT_EQ(shown_in("8"), "none");
  EXPECT_EQ(shown_in("9"), "12");
}

TEST(StudyWriter, RowsOfOneAttemptAreAsManyAsWereRecordedAndWithoutStepsAllOthers) {
  const TemporaryFolder folder;
  const AttemptRecord& attempt = recorded_attempts()[0];
  for (const bool keeps_steps : {true, false}) {
    const std::string path = (folder / (keeps_steps ? "a.sqlite" : "b.sqlite")).string();
    save_alone(attempt, path, keeps_steps);
    const auto rows = [&](const std::string& table) {
      return std::stoul(value_of(path, "SELECT count(*) FROM " + table));
    };
    EXPECT_EQ(rows("step"), keeps_steps ? attempt.steps.size() : 0U);
    EXPECT_EQ(rows("collision"), attempt.collisions.size());
    EXPECT_EQ(rows("frame"), attempt.frames.size());
    EXPECT_EQ(value_of(path, "SELECT rating FROM rated_trial"),
              std::to_string(attempt.ratings.front().rating));
    EXPECT_EQ(value_of(path, "SELECT ending FROM session"), "quit");
  }
}

TEST(StudyWriter, ATrialWithABodyThatWasNotFiniteIsMarkedByANoteThatNamesIt) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  AttemptRecord attempt = recorded_attempts()[0];
  attempt.steps[7].not_finite = {{1, StateField::kLinearMomentum}};
  attempt.steps[7].degradations |= kNotFinite;
  {
    EnrolledStudy at(path);
    StudyWriter writer(at.study, at.enrolment, facts());
    writer.save(recorded_attempts()[1]);
    EXPECT_EQ(writer.not_finite_attempts(), 0);
    writer.save(attempt);
    EXPECT_EQ(writer.not_finite_attempts(), 1);
    writer.end("quit");
  }
  EXPECT_EQ(value_of(path, "SELECT group_concat(kind || ': ' || text) FROM note"),
            "not finite: trial " + std::to_string(attempt.slot) + ", attempt " +
                std::to_string(attempt.number) + ", step 7: " + attempt.body_names[1] +
                ", linear momentum");
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM step WHERE degradations & 4"), "1");
}

TEST(StudyWriter, GazeIsKeptAndWhyASampleHasNoPlace) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  AttemptRecord attempt = recorded_attempts()[0];
  attempt.gaze_source = "mouse";
  attempt.gaze = {{5, ScreenPoint{0.1, -0.2}, GazeLoss::kNone, 1},
                  {10, {}, GazeLoss::kBlink, 1},
                  {15, {}, GazeLoss::kOffScreen, 2},
                  {20, {}, GazeLoss::kLost, 2}};
  save_alone(attempt, path);
  StudyFile study = StudyFile::open_for_reading(path);
  const std::vector<GazeSample> gaze = load_gaze(study, 1);
  ASSERT_EQ(gaze.size(), attempt.gaze.size());
  for (std::size_t i = 0; i < gaze.size(); ++i) {
    EXPECT_EQ(gaze[i].taken_ns, attempt.gaze[i].taken_ns);
    EXPECT_EQ(gaze[i].at, attempt.gaze[i].at);
    EXPECT_EQ(gaze[i].interval, attempt.gaze[i].interval);
    EXPECT_EQ(gaze[i].loss, attempt.gaze[i].loss) << "sample " << i;
  }
}

TEST(StudyWriter, CountsLateFramesAndTheAttemptsThatHadAny) {
  const TemporaryFolder folder;
  EnrolledStudy at((folder / "a.sqlite").string());
  StudyWriter writer(at.study, at.enrolment, facts());
  std::int64_t timed = 0;
  for (const std::size_t late : {0, 1, 3}) {
    AttemptRecord attempt = recorded_attempts()[late];  // each of a trial of its own
    ASSERT_GE(attempt.frames.size(), late);
    for (std::size_t frame = 0; frame < attempt.frames.size(); ++frame) {
      attempt.frames[frame].flip.missed_slots = frame < late ? 1 : 0;
    }
    timed += static_cast<std::int64_t>(attempt.frames.size());
    writer.save(attempt);
  }
  writer.end("quit");
  EXPECT_EQ(writer.frames().timed, timed);
  EXPECT_EQ(writer.frames().late, 4);
  EXPECT_EQ(writer.frames().late_attempts, 2);
}

TEST(StudyWriter, CappedCollisionsPopsAndStopsAreKept) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  AttemptRecord attempt = recorded_attempts()[0];
  ASSERT_FALSE(attempt.collisions.empty());
  attempt.collisions[0].report.stop = StopReason::kCapped;
  attempt.collisions[0].report.contact_count = 3;
  StepReport degraded;
  degraded.pops = {{{0, 1}, 3, 2, 0.25}, {{0, 1}, 3, 1, 0.5}};
  degraded.stopped = {{{0, 1}, 0.125}};
  const StepRecord popped = record_step(7, {}, degraded);
  attempt.steps[7].pops = popped.pops;
  attempt.steps[7].largest_pop_deg = popped.largest_pop_deg;
  attempt.steps[7].stopped_short = popped.stopped_short;
  save_alone(attempt, path);
  EXPECT_EQ(value_of(path, "SELECT stopped || ' ' || contacts FROM seen_collision"), "capped 3");
  EXPECT_EQ(value_of(path,
                     "SELECT group_concat(step || ' ' || pops || ' ' || largest_pop_deg || ' ' || "
                     "stopped_short) FROM popped_step"),
            "7 2 0.5 1");
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM step WHERE largest_pop_deg IS NULL"),
            std::to_string(attempt.steps.size() - 1));
  StudyFile study = StudyFile::open_for_reading(path);
  const StepRecord loaded = load_steps(study.database(), 1)[7];
  EXPECT_EQ(loaded.pops, 2);
  EXPECT_EQ(loaded.largest_pop_deg, 0.5);
  EXPECT_EQ(loaded.stopped_short, 1);
}

TEST(StudyWriter, ACollisionIsReadWithThePlacesOfItsBodies) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  AttemptRecord attempt = recorded_attempts()[0];
  ASSERT_EQ(attempt.collisions.size(), 1U);
  attempt.collisions[0].report.bodies = {0, 1};
  attempt.body_names = {"first", "second"};
  attempt.collisions.push_back(attempt.collisions[0]);
  attempt.collisions[1].report.bodies = {1, kEnclosure};
  save_alone(attempt, path);
  StudyFile study = StudyFile::open_for_reading(path);
  const auto found = [&](const std::vector<std::string>& names) {
    std::string text;
    for (const StoredCollision& collision : load_collisions(study, 1, names)) {
      text += std::to_string(collision.bodies.a) + " " + std::to_string(collision.bodies.b) + "; ";
    }
    return text;
  };
  EXPECT_EQ(found({"first", "second"}), "0 1; 1 -1; ");
  EXPECT_EQ(found({"second", "another", "first"}), "2 0; 0 -1; ");
  EXPECT_EQ(found({"second", "another"}), "0 -1; ");
}

TEST(StudyWriter, WhatWasImposedOnACollisionIsKeptEachInItsColumn) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  AttemptRecord attempt = recorded_attempts()[0];
  ASSERT_EQ(attempt.collisions.size(), 1U);
  attempt.collisions[0].report.imposed_hold_s = 0.25;
  attempt.collisions[0].imposed_spin = ImposedSpin{{1.5, 2.5, 3.5}, {-1.5, -2.5, -3.5}};
  save_alone(attempt, path);
  EXPECT_EQ(value_of(path, "SELECT imposed_hold_ms FROM collision"), "250.0");
  EXPECT_EQ(value_of(path,
                     "SELECT imposed_spin_a_x_rad_s || ' ' || imposed_spin_a_y_rad_s || ' ' || "
                     "imposed_spin_a_z_rad_s || ' ' || imposed_spin_b_x_rad_s || ' ' || "
                     "imposed_spin_b_y_rad_s || ' ' || imposed_spin_b_z_rad_s FROM collision"),
            "1.5 2.5 3.5 -1.5 -2.5 -3.5");
}

TEST(StudyWriter, ClicksAreNumberedFromOne) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  AttemptRecord attempt = recorded_attempts()[0];
  attempt.clicks.resize(3);
  for (ClickRecord& click : attempt.clicks) {
    click.device = "mouse";
  }
  save_alone(attempt, path);
  EXPECT_EQ(value_of(path, "SELECT group_concat(number) FROM click"), "1,2,3");
}

TEST(StudyWriter, DetailsOfAResponseAreKeptAsTheyAre) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  AttemptRecord attempt = recorded_attempts()[0];
  ResponseRecord response;
  response.kind = "two_interval";
  response.device = "none";
  response.detail = {{"whole", 2.0},  {"part", 0.5}, {"negative", -1.25},
                     {"large", 1e20}, {"yes", true}, {"text", "2.0"}};
  attempt.responses = {response, response};
  attempt.responses[1].detail = {};
  save_alone(attempt, path);
  EXPECT_EQ(value_of(path, "SELECT detail FROM response WHERE number = 1"),
            R"({"whole":2,"part":0.5,"negative":-1.25,"large":1.0e+20,"yes":true,"text":"2.0"})");
  EXPECT_EQ(value_of(path, "SELECT detail FROM response WHERE number = 2"), "{}");
}

TEST(StudyWriter, SqlAndMarkupStayText) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  const std::string nasty = "Robert'); DROP TABLE trial;-- <b onclick=\"x()\">&amp;</b> %s\n\tü \\";
  {
    EnrolledStudy at(path, nasty);
    EXPECT_TRUE(at.found(nasty));
    StudyWriter writer(at.study, at.enrolment, facts());
    writer.save(QuestionRecord{"question", "strategy", nasty, nasty});
    writer.save(NoteRecord{nasty, nasty});
    writer.end("quit");
  }
  EXPECT_EQ(value_of(path, "SELECT participant FROM questionnaire"), nasty);
  EXPECT_EQ(value_of(path, "SELECT words FROM questionnaire"), nasty);
  EXPECT_EQ(value_of(path, "SELECT answer FROM questionnaire"), nasty);
  EXPECT_EQ(value_of(path, "SELECT kind FROM note"), nasty);
  EXPECT_EQ(value_of(path, "SELECT text FROM note"), nasty);
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM trial"), "6");
}

TEST(StudyWriter, RowsThatContradictEachOtherAreRefused) {
  AttemptRecord impossible_rating = recorded_attempts()[0];
  impossible_rating.ratings.front().rating = 4;
  AttemptRecord completed_again = recorded_attempts()[0];
  completed_again.number = 2;
  const std::vector<std::pair<std::vector<AttemptRecord>, std::string>> cases{
      {{impossible_rating},
       "CHECK constraint failed: minimum < maximum AND rating BETWEEN minimum AND maximum"},
      {{recorded_attempts()[0], completed_again}, "UNIQUE constraint failed: attempt.trial_id"}};
  for (const auto& [attempts, reason] : cases) {
    const TemporaryFolder folder;
    const std::string path = (folder / "a.sqlite").string();
    EnrolledStudy at(path);
    StudyWriter writer(at.study, at.enrolment, facts());
    for (const AttemptRecord& attempt : attempts) {
      writer.save(attempt);
    }
    EXPECT_EQ(sentence_of([&] { writer.await_saved(); }),
              path + ": could not be written (" + reason +
                  "); everything up to the last completed trial is saved");
  }
}

TEST(StudyWriter, RowsWithoutAnOwnerAreRefused) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  EnrolledStudy at(path);
  Enrolment nobody = at.enrolment;
  nobody.id = 99;
  StudyWriter writer(at.study, nobody, facts());
  EXPECT_EQ(sentence_of([&] { writer.await_saved(); }),
            path +
                ": could not be written (FOREIGN KEY constraint failed); everything up to the "
                "last completed trial is saved");
}

TEST(StudyWriter, ADisplayThatClosesInMidTrialLosesNoRow) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  std::int64_t completed = 0;
  {
    EnrolledStudy at(path);
    StudyWriter writer(at.study, at.enrolment, facts());
    TestLab lab;
    constexpr std::int64_t kFrameOfTheThirdTrial = 600;
    lab.input.on_frame = [](std::int64_t frame) {
      return frame == kFrameOfTheThirdTrial ? Interruption::kDisplayClosed : Interruption::kNone;
    };
    const Ports ports{lab.display, lab.input, lab.scenes, writer};
    const SessionResult result =
        run_session(lab.protocol.script, short_plan(lab.protocol, 4), {}, ports);
    EXPECT_EQ(result.ending, SessionEnding::kDisplayClosed);
    completed = result.completed_trials;
    writer.end("display closed");
  }
  EXPECT_GE(completed, 1);
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM attempt WHERE outcome = 'completed'"),
            std::to_string(completed));
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM rating"), std::to_string(completed));
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM attempt WHERE outcome = 'interrupted'"), "1");
  EXPECT_EQ(value_of(path, "SELECT kind FROM note ORDER BY id DESC"), "display closed");
  EXPECT_EQ(value_of(path, "SELECT ending FROM session"), "display closed");
}

}  // namespace impetus::study_writer_test
