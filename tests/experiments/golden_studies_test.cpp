// Every shipped study has a golden recording, made by an earlier version, and each replays for
// ever. (Those of the first studies have tests of their own in replay_test.cpp.)
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/dynamics/motion.hpp"
#include "tests/experiments/golden_study.hpp"

namespace impetus::golden_studies_test {

/// Trials recorded for each that was made after the first six.
struct Recording {
  const char* name;
  std::size_t attempts;
};

constexpr Recording kRecordings[] = {
    {"at-walls", 4U},               // of format 5: bodies that are through a wall within a step
    {"tumbling", 2U},               // of format 6: figures whose motion is cut
    {"rushing", 2U},                // of format 7: many tests along the ways of fast bodies
    {"passing", 2U},                // of format 8: ways of nodes foreseen, as spheres and boxes
    {"hurried", 2U},                // of format 9: pairs that no time is left to look at
    {"behind-the-curtain", 7U},     // a curtain; a launch that nothing follows
    {"causality-thresholds", 20U},  // training, three or more of each delay
    {"causality-thresholds-quest", 21U},
    {"crowd", 7U},                   // trees of medial spheres, 50 and 100 creatures
    {"distorted-rebounds", 22U},     // one of each change, and of none
    {"falling", 8U},                 // of format 3: gravity, and one contact a pair
    {"far-and-fast", 12U},           // turns of 660 degrees in a step, entries, walls
    {"figures", 7U},                 // hinges, limits and folds, at three levels
    {"gaze-contingent-yoked", 23U},  // two participants: one follows the other's gaze
    {"launch-or-pass", 30U},         // launches and slips, and what they are adapted by
    {"launching", 24U},              // one of two spheres rests; delays and gaps
    {"lying", 4U},                   // of format 4: figures under gravity, few steps a second
    {"odd-shapes", 9U},              // prisms launched from afar, that appear late
    {"scheduler-distribution", 7U},  // nobody takes part
    {"stream-or-bounce", 6U},        // bodies that pass through each other, and a sound
    {"two-balls", 4U},               // discs and walls in a plane; a goal ends each trial
    {"what-will-happen", 6U},        // still at first; gravity; hidden before the end
};

TEST(GoldenStudies, EveryTrialReplaysBitForBit) {
  for (const Recording& recording : kRecordings) {
    SCOPED_TRACE(recording.name);
    Golden golden(recording.name);
    EXPECT_EQ(golden.attempts.size(), recording.attempts);
    for (const StoredAttempt& attempt : golden.attempts) {
      const ReplayResult result = replay(golden.stage(attempt), golden.steps(attempt));
      EXPECT_GE(result.steps, 15);
      EXPECT_EQ(words(attempt, result), "");
    }
  }
}

TEST(GoldenStudies, EveryShippedProtocolHasARecording) {
  std::set<std::string> recorded;
  for (const auto& entry : std::filesystem::directory_iterator(source_file("tests/recordings"))) {
    if (entry.path().extension() == ".sqlite") {
      SQLite::Database database(entry.path().string(), SQLite::OPEN_READONLY);
      SQLite::Statement query(database, "SELECT name FROM protocol");
      while (query.executeStep()) {
        recorded.insert(query.getColumn(0).getString());
      }
    }
  }
  for (const auto& entry : std::filesystem::directory_iterator(source_file("protocols"))) {
    if (entry.path().extension() == ".json" && entry.path().stem() != "protocol.schema") {
      EXPECT_TRUE(recorded.contains(entry.path().stem())) << entry.path();
    }
  }
}

/// What a step of the recording left without its full answer, or did out of the ordinary.
std::int64_t steps_where(const char* name, const std::string& condition) {
  Golden golden(name);
  return golden.study.database()
      .execAndGet("SELECT count(*) FROM step WHERE " + condition)
      .getInt64();
}

/// In how many trials of the recording a step ends otherwise by the rules of this format.
std::int64_t divergent_by(const char* name, int recording_format) {
  Golden golden(name);
  std::int64_t count = 0;
  for (const StoredAttempt& attempt : golden.attempts) {
    StagedScene scene = golden.stage(attempt);
    scene.world.set_recording_format(recording_format);
    count += replay(std::move(scene), golden.steps(attempt)).divergence ? 1 : 0;
  }
  return count;
}

TEST(GoldenStudies, BodiesFallByTheRulesOfTheFormatThatTheyWereRecordedIn) {
  EXPECT_EQ(divergent_by("far-and-fast", 2), 0);
  EXPECT_GT(divergent_by("far-and-fast", 3), 0);
  EXPECT_EQ(divergent_by("falling", 3), 0);
  EXPECT_EQ(divergent_by("falling", 4), 0) << "no figures";
  EXPECT_GT(divergent_by("falling", 2), 0);
  EXPECT_EQ(divergent_by("lying", 4), 0);
  EXPECT_GT(divergent_by("lying", 3), 0);
  EXPECT_EQ(divergent_by("at-walls", 5), 0);
  EXPECT_EQ(divergent_by("at-walls", 4), 4) << "each of its trials";
  EXPECT_EQ(divergent_by("tumbling", 6), 0);
  EXPECT_EQ(divergent_by("tumbling", 5), 2) << "each of its trials";
  EXPECT_EQ(divergent_by("rushing", 7), 0);
  EXPECT_EQ(divergent_by("rushing", 6), 2) << "each of its trials";
  EXPECT_EQ(divergent_by("hurried", 9), 0);
  EXPECT_EQ(divergent_by("hurried", 8), 2) << "each of its trials";
  EXPECT_EQ(divergent_by("passing", 8), 0);
  EXPECT_EQ(divergent_by("passing", 7), 2) << "each of its trials";
}

// What would not be noticed by a comparison of builds, if no recording had it.
TEST(GoldenStudies, SomeMoveAndTurnFarInAStep) {
  EXPECT_GT(steps_where("far-and-fast", "stopped_short > 0"), 0);
  Golden golden("far-and-fast");
  const StagedScene scene = golden.stage(golden.attempts.front());
  const BodyState& needle = scene.world.states().front();
  EXPECT_TRUE(turns_far(scene.world.models().front(), needle, 1.0 / scene.step_hz));
  EXPECT_GT(golden.study.database()
                .execAndGet("SELECT count(*) FROM collision WHERE body_b LIKE 'wall%'")
                .getInt(),
            0);
}

}  // namespace impetus::golden_studies_test
