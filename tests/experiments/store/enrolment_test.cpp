// Who does which protocol: the plan, its resumption, and who is refused.
// SPDX-License-Identifier: MIT
#include "experiments/store/exclusion.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/store/yoke_rows.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::enrolment_test {

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
    writer.end("declined");
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

TEST(Enrolment, PeopleFollowPeopleAndSimulatedParticipantsTheSimulated) {
  const TemporaryFolder folder;
  EnrolledStudy at(folder / "a.sqlite");
  const ProtocolTexts texts = texts_of(at.protocol);
  const auto finish = [&](const std::string& name, bool simulated) {
    const Enrolment enrolled =
        enrol(at.study, name, simulated, texts, 1, stored(short_plan(at.protocol, 1)));
    StudyWriter writer(at.study, enrolled, facts());
    writer.mark_finished();
    writer.end("finished");
  };
  finish("P02", false);
  finish("S01", true);
  const std::string shown = to_json(short_plan(at.protocol, 1).back().condition).dump();
  for (const auto& partner : {last_partner, least_followed_partner}) {
    EXPECT_EQ(partner(at.study, "causality", "P01", false, shown).value().pseudonym, "P02");
    EXPECT_EQ(partner(at.study, "causality", "P01", true, shown).value().pseudonym, "S01");
    EXPECT_FALSE(partner(at.study, "causality", "P01", true, "{}")) << "nobody was shown that";
    exclude(at.study, {"P02", std::nullopt, true, "asleep"});
    EXPECT_FALSE(partner(at.study, "causality", "P01", false, shown)) << "P02 is left out";
    exclude(at.study, {"P02", std::nullopt, false, "awake"});
  }
  EXPECT_TRUE(has_finished(at.study, "P02", false, texts));
  EXPECT_TRUE(has_finished(at.study, "S01", true, texts));
  EXPECT_FALSE(has_finished(at.study, "P01", false, texts));
  EXPECT_FALSE(has_finished(at.study, "P02", true, texts));
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

TEST(Enrolment, WithASessionOfWhoWasEnrolledMeanwhileFailsButTheSessionIsNotToBlame) {
  const TemporaryFolder folder;
  EnrolledStudy at(folder / "a.sqlite");
  SessionFacts session = facts();
  session.page = SessionPage{"P01_2026"};
  StudyWriter late(at.study,
                   {"P01", false, texts_of(at.protocol), 1, stored(short_plan(at.protocol, 4))},
                   session);
  late.save_whole([&] { late.count_part(); });
  try {
    late.await_saved();
    ADD_FAILURE() << "enrolled twice";
  } catch (const StoreError& failed) {
    EXPECT_EQ(dynamic_cast<const ForbiddenRecord*>(&failed), nullptr) << failed.what();
  }
  EXPECT_EQ(count_rows(at.study.database(), "enrolment"), 1);
  EXPECT_EQ(count_rows(at.study.database(), "session"), 0);
}

}  // namespace impetus::enrolment_test
