// What the study file keeps, and that it says in one sentence when it cannot.
// SPDX-License-Identifier: MIT
#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <functional>
#include <limits>

#include "experiments/session/input_error.hpp"
#include "experiments/store/attempt_rows.hpp"
#include "experiments/store/study_reader.hpp"
#include "experiments/store/study_writer.hpp"
#include "tests/experiments/fakes.hpp"
#include "tests/experiments/temporary_folder.hpp"

namespace impetus {
namespace {

constexpr const char* kTestBuild = "test build";

std::string sentence_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

/// Runs `act` in a child process and returns what it returned there.
std::string in_child(const std::function<std::string()>& act) {
  std::array<int, 2> pipe_ends{};
  EXPECT_EQ(pipe(pipe_ends.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    const std::string words = act();
    const ssize_t written = write(pipe_ends[1], words.data(), words.size());
    _exit(written == static_cast<ssize_t>(words.size()) ? 0 : 1);
  }
  close(pipe_ends[1]);
  std::string words;
  std::array<char, 4096> part{};
  for (ssize_t size = 0; (size = read(pipe_ends[0], part.data(), part.size())) > 0;) {
    words.append(part.data(), static_cast<std::size_t>(size));
  }
  close(pipe_ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  return words;
}

/// Root may write anywhere; nobody may not.
void become_nobody() {
  constexpr uid_t kNobody = 65534;
  if (geteuid() == 0 && setresuid(kNobody, kNobody, kNobody) != 0) {
    _exit(2);
  }
}

/// A folder that nobody may enter, too.
struct OpenFolder : TemporaryFolder {
  OpenFolder() { std::filesystem::permissions(path(), std::filesystem::perms(0755)); }
};

StudyFile opened(const std::filesystem::path& path) {
  return StudyFile::open_for_writing(path, kTestBuild);
}

std::string open_refusal(const std::filesystem::path& path) {
  return sentence_of([&] { opened(path); });
}

std::string read_refusal(const std::filesystem::path& path) {
  return sentence_of([&] { StudyFile::open_for_reading(path); });
}

/// A database made with plain SQLite, by these statements.
std::filesystem::path plain_database(const std::filesystem::path& path, const std::string& sql) {
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec(sql);
  return path;
}

std::string value_of(const std::filesystem::path& path, const std::string& sql) {
  SQLite::Database database(path.string(), SQLite::OPEN_READONLY);
  return database.execAndGet(sql).getString();
}

ProtocolTexts texts_of(const Protocol& protocol) {
  return {protocol.name, protocol.hash, protocol.document.text, protocol.scene.text};
}

std::vector<StoredTrial> stored(const Plan& plan) {
  std::vector<StoredTrial> trials;
  for (const PlannedTrial& trial : plan) {
    trials.push_back({0, trial.slot, trial.phase, trial.repetition, to_json(trial.condition).dump(),
                      trial.seed});
  }
  return trials;
}

SessionFacts facts() {
  SessionFacts result;
  result.build = kTestBuild;
  result.machine = "test";
  result.display = "headless";
  result.screen = assumed_screen();
  result.refresh_hz = 60.0;
  result.sync.passed = true;
  return result;
}

/// The attempts of a short headless session: real steps, collisions, frames and ratings.
const std::vector<AttemptRecord>& recorded_attempts() {
  static const std::vector<AttemptRecord> attempts = [] {
    TestLab lab;
    run_session(lab.protocol.script, short_plan(lab.protocol, 4), {}, lab.ports());
    return lab.recorder.attempts;
  }();
  return attempts;
}

/// A study with one participant, P01, enrolled for two practice and four main trials.
struct EnrolledStudy {
  explicit EnrolledStudy(const std::filesystem::path& path, const std::string& pseudonym = "P01")
      : study(opened(path)),
        enrolment(enrol(study, pseudonym, false, texts_of(protocol), 1,
                        stored(short_plan(protocol, 4)))) {}

  std::optional<Enrolment> found(const std::string& pseudonym = "P01", bool simulated = false) {
    return find_enrolment(study, pseudonym, simulated, texts_of(protocol));
  }

  Protocol protocol{causality()};
  StudyFile study;
  Enrolment enrolment;
};

// ---------------------------------------------------------------- enrolment and resume

TEST(Enrolment, IsFoundAgainWithItsPlanInOrder) {
  const TemporaryFolder folder;
  EnrolledStudy at(folder / "a.sqlite");
  const auto found = at.found();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id, at.enrolment.id);
  EXPECT_EQ(found->seed, 1U);
  EXPECT_FALSE(found->history.resumed);
  const std::vector<StoredTrial> planned = stored(short_plan(at.protocol, 4));
  ASSERT_EQ(found->trials.size(), planned.size());
  for (std::size_t i = 0; i < planned.size(); ++i) {
    EXPECT_EQ(found->trials[i].id, at.enrolment.trials[i].id);
    EXPECT_EQ(found->trials[i].slot, static_cast<std::int64_t>(i) + 1);
    EXPECT_EQ(found->trials[i].phase, planned[i].phase);
    EXPECT_EQ(found->trials[i].repetition, planned[i].repetition);
    EXPECT_EQ(found->trials[i].condition, planned[i].condition);
    EXPECT_EQ(found->trials[i].seed, planned[i].seed);
  }
}

TEST(Enrolment, KeepsSeedsOfAll64Bits) {
  const TemporaryFolder folder;
  const Protocol protocol = causality();
  StudyFile study = opened(folder / "a.sqlite");
  const std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
  std::vector<StoredTrial> trials = stored(short_plan(protocol, 1));
  trials[0].seed = largest - 1;
  enrol(study, "P01", false, texts_of(protocol), largest, trials);
  const auto found = find_enrolment(study, "P01", false, texts_of(protocol));
  EXPECT_EQ(found->seed, largest);
  EXPECT_EQ(found->trials[0].seed, largest - 1);
}

TEST(Enrolment, NobodyIsFoundInAStudyWithoutThem) {
  const TemporaryFolder folder;
  EnrolledStudy at(folder / "a.sqlite");
  EXPECT_FALSE(at.found("P02"));
}

TEST(Enrolment, HistoryTellsWhatIsDoneAndWhatWasInterrupted) {
  const TemporaryFolder folder;
  EnrolledStudy at(folder / "a.sqlite");
  AttemptRecord interrupted = recorded_attempts()[1];
  interrupted.outcome = AttemptOutcome::kInterrupted;
  interrupted.ratings.clear();
  {
    StudyWriter writer(at.study, at.enrolment, facts());
    writer.save(QuestionRecord{"consent", "consent", "I agree", "agreed"});
    writer.save(QuestionRecord{"demographic", "age", "Your age", ""});
    writer.save(recorded_attempts()[0]);
    writer.save(interrupted);
    writer.end("quit");
  }
  const auto found = at.found();
  EXPECT_TRUE(found->history.resumed);
  EXPECT_EQ(found->history.completed_slots, (std::set<std::int64_t>{1}));
  EXPECT_EQ(found->history.attempts, (std::map<std::int64_t, std::int64_t>{{1, 1}, {2, 1}}));
  EXPECT_EQ(found->history.answered, (std::set<std::string>{"age", "consent"}));
}

TEST(Enrolment, WhoDeclinedIsAskedForConsentAgain) {
  const TemporaryFolder folder;
  EnrolledStudy at(folder / "a.sqlite");
  {
    StudyWriter writer(at.study, at.enrolment, facts());
    writer.save(QuestionRecord{"consent", "consent", "I agree", "declined"});
    writer.end("quit");
  }
  EXPECT_TRUE(at.found()->history.answered.empty());
}

TEST(Enrolment, AFinishedParticipantIsRefused) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  EnrolledStudy at(path);
  {
    StudyWriter writer(at.study, at.enrolment, facts());
    writer.mark_finished();
    writer.end("finished");
  }
  const std::string when = value_of(path, "SELECT finished_utc FROM enrolment");
  EXPECT_EQ(when.size(), std::string("2026-01-31T12:00:00.000Z").size());
  EXPECT_EQ(sentence_of([&] { at.found(); }),
            path + ": participant P01 has finished causality already, at " + when);
}

TEST(Enrolment, AnotherVersionOfTheProtocolIsRefused) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  EnrolledStudy at(path);
  ProtocolTexts other = texts_of(at.protocol);
  other.hash = "0123";
  EXPECT_EQ(sentence_of([&] { find_enrolment(at.study, "P01", false, other); }),
            path +
                ": participant P01 began with another version of causality; resume with the "
                "file it was, or use another name");
  EXPECT_EQ(other_versions(at.study, other), std::vector<std::string>{at.protocol.hash});
  EXPECT_TRUE(other_versions(at.study, texts_of(at.protocol)).empty());
}

TEST(Enrolment, APersonAndASimulatedParticipantNeverShareAName) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  EnrolledStudy at(path);
  EXPECT_EQ(sentence_of([&] { at.found("P01", true); }),
            path +
                ": participant P01 is a person in this study; a simulated one needs another "
                "name");
  enrol(at.study, "S01", true, texts_of(at.protocol), 1, stored(short_plan(at.protocol, 1)));
  EXPECT_EQ(sentence_of([&] { at.found("S01", false); }),
            path + ": participant S01 is simulated in this study; a person needs another name");
}

TEST(Enrolment, APlanIsStoredWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  {
    const Protocol protocol = causality();
    StudyFile study = opened(path);
    std::vector<StoredTrial> trials = stored(short_plan(protocol, 4));
    trials.back().condition = "{";  // Not JSON: the last row breaks a CHECK.
    EXPECT_EQ(
        sentence_of([&] { enrol(study, "P01", false, texts_of(protocol), 1, trials); }),
        path + ": the plan could not be saved: CHECK constraint failed: json_valid(condition)");
  }
  EXPECT_EQ(value_of(path,
                     "SELECT (SELECT count(*) FROM participant) || (SELECT count(*) FROM protocol) "
                     "|| (SELECT count(*) FROM enrolment) || (SELECT count(*) FROM trial)"),
            "0000");
}

// ---------------------------------------------------------------- what is no study

TEST(StudyFile, WhatIsNoStudyIsRefusedAndLeftAlone) {
  const TemporaryFolder folder;
  const std::string text =
      folder.write("a.txt", "a text that is long enough to be looked at").string();
  const std::string other =
      plain_database(folder / "other.sqlite", "CREATE TABLE t (x); INSERT INTO t VALUES (1)");
  const std::string marked = plain_database(
      folder / "marked.sqlite", "PRAGMA application_id = 252006675; CREATE TABLE t (x)");
  const std::vector<std::pair<std::string, std::string>> cases{
      {text, text + ": expected an Impetus study, got a file that is no SQLite database"},
      {other, other + ": expected an Impetus study, got a database of another program"},
      {marked, marked + ": expected an Impetus study, got a database of another program"}};
  for (const auto& [path, sentence] : cases) {
    const std::string before = text_of(path);
    EXPECT_EQ(open_refusal(path), sentence);
    EXPECT_EQ(read_refusal(path), sentence);
    EXPECT_EQ(text_of(path), before);
  }
}

TEST(StudyFile, AStudyOfAnotherSchemaVersionIsRefused) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  opened(path);
  plain_database(path, "PRAGMA user_version = 2");
  const std::string sentence = path + ": expected a study of schema version 1, got version 2";
  EXPECT_EQ(open_refusal(path), sentence);
  EXPECT_EQ(read_refusal(path), sentence);
}

TEST(StudyFile, AMissingFileIsRefusedForReadingAndNotMade) {
  const TemporaryFolder folder;
  const std::string path = (folder / "none.sqlite").string();
  EXPECT_EQ(read_refusal(path), path + ": expected an Impetus study, but there is no such file");
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(open_refusal(folder / "no/folder.sqlite"),
            (folder / "no/folder.sqlite").string() +
                ": expected a file that can be written, but it cannot be: No such file or "
                "directory");
}

TEST(StudyFile, AProcessKilledBeforeTheSchemaWasWrittenLeavesAFileThatCanBeUsed) {
  const TemporaryFolder folder;
  const std::filesystem::path empty = folder.write("empty.sqlite", "");
  const std::filesystem::path begun =
      plain_database(folder / "begun.sqlite", "PRAGMA journal_mode = WAL");
  ASSERT_GT(std::filesystem::file_size(begun), 0U);
  for (const std::filesystem::path& path : {empty, begun}) {
    EXPECT_EQ(read_refusal(path), path.string() + ": expected an Impetus study, got an empty file");
    EXPECT_EQ(open_refusal(path), "accepted");
    EXPECT_EQ(value_of(path, "SELECT build FROM study"), kTestBuild);
  }
}

// ---------------------------------------------------------------- what cannot be written

TEST(StudyFile, AReadOnlyFileIsRefusedForWritingAndCanBeRead) {
  const OpenFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  opened(path);
  std::filesystem::permissions(path, std::filesystem::perms(0444));
  EXPECT_EQ(in_child([&] {
              become_nobody();
              return open_refusal(path) + "\n" + read_refusal(path);
            }),
            path + ": expected a file that can be written, but it cannot be: Permission denied\n" +
                "accepted");
}

TEST(StudyFile, AReadOnlyFolderIsRefusedForWriting) {
  const OpenFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  const std::string fresh = (folder / "b.sqlite").string();
  opened(path);
  std::filesystem::permissions(path, std::filesystem::perms(0666));
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  EXPECT_EQ(in_child([&] {
              become_nobody();
              return open_refusal(path) + "\n" + open_refusal(fresh);
            }),
            path +
                ": expected a folder that can be written, for the study's log beside it, but "
                "it cannot be: Permission denied\n" +
                fresh +
                ": expected a file that can be written, but it cannot be: Permission denied");
}

TEST(StudyFile, ASecondProcessIsRefusedWhileTheFirstHasTheFile) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  {
    const StudyFile study = opened(path);
    EXPECT_EQ(in_child([&] { return open_refusal(path); }),
              path + ": in use by another Impetus process; end that session first");
  }
  EXPECT_EQ(in_child([&] { return open_refusal(path); }), "accepted");
}

// ---------------------------------------------------------------- the full disk

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

// ---------------------------------------------------------------- what is kept, and how

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
  {
    EnrolledStudy at(path);
    StudyWriter writer(at.study, at.enrolment, facts());
    writer.save(attempt);
    writer.end("quit");
  }
  StudyFile study = StudyFile::open_for_reading(path);
  const std::vector<StepRecord> steps = load_steps(study.database(), 1);
  ASSERT_EQ(steps.size(), attempt.steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i].step, attempt.steps[i].step);
    EXPECT_EQ(steps[i].work_granted, attempt.steps[i].work_granted);
    EXPECT_EQ(steps[i].work_spent, attempt.steps[i].work_spent);
    EXPECT_EQ(steps[i].degradations, attempt.steps[i].degradations);
    EXPECT_EQ(steps[i].state.hash, attempt.steps[i].state.hash);
    EXPECT_EQ(steps[i].state.bodies, attempt.steps[i].state.bodies);
  }
}

TEST(StudyWriter, RowsOfOneAttemptAreAsManyAsWereRecorded) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  const AttemptRecord& attempt = recorded_attempts()[0];
  {
    EnrolledStudy at(path);
    StudyWriter writer(at.study, at.enrolment, facts());
    writer.save(attempt);
    writer.end("quit");
  }
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM collision"),
            std::to_string(attempt.collisions.size()));
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM frame"), std::to_string(attempt.frames.size()));
  EXPECT_EQ(value_of(path, "SELECT rating FROM rated_trial"),
            std::to_string(attempt.ratings.front().rating));
  EXPECT_EQ(value_of(path, "SELECT ending FROM session"), "quit");
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

TEST(StudyFile, IsOneFileOnceClosed) {
  const TemporaryFolder folder;
  {
    EnrolledStudy at(folder / "a.sqlite");
    StudyWriter writer(at.study, at.enrolment, facts());
    writer.save(recorded_attempts()[0]);
    writer.end("quit");
    EXPECT_TRUE(std::filesystem::exists(folder / "a.sqlite-wal"));
  }
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    names.push_back(entry.path().filename());
  }
  EXPECT_EQ(names, std::vector<std::string>{"a.sqlite"});
  // Bytes 18 and 19 of SQLite's header: 2 would ask every reader for a folder it may write in.
  EXPECT_EQ(text_of(folder / "a.sqlite").substr(18, 2), "\x01\x01");
}

// ---------------------------------------------------------------- a display that closes

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

}  // namespace
}  // namespace impetus
