// The other studies as the program runs them: solved, simulated, stored, replayed.
// SPDX-License-Identifier: MIT
#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/experiments/program.hpp"
#include "tests/experiments/refusals.hpp"
#include "tests/places/places.hpp"

namespace impetus::unattended_run_test {

/// A folder with copies of a protocol and its scene, to be cut short.
struct Copied {
  Copied(const std::string& protocol_file, const std::string& scene_file)
      : protocol(json::parse(shipped("protocols/" + protocol_file))),
        scene(json::parse(shipped("stimuli/" + scene_file))) {}

  ProgramResult run(const std::vector<std::string>& more) const {
    json beside = protocol;
    beside["scene"] = "scene.json";
    folder.write("protocol.json", beside.dump());
    folder.write("scene.json", scene.dump());
    std::vector<std::string> words{"run", "protocol.json", "--db", "a.sqlite"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(folder, words);
  }

  [[nodiscard]] std::string asked(const std::string& sql) const {
    SQLite::Database database((folder / "a.sqlite").string(), SQLite::OPEN_READONLY);
    return database.execAndGet(sql).getString();
  }

  TemporaryFolder folder;
  json protocol;
  json scene;
};

/// Ten seconds of the distribution study, by two schedulers.
struct ShortDistribution : Copied {
  ShortDistribution() : Copied("scheduler-distribution.json", "spheres-in-view.json") {
    protocol["design"]["factors"][0]["levels"] = {"distance", "gap"};
    protocol["solve"][0]["pilot_s"] = 20;
    protocol["solve"][0]["within"] = 0.05;
    scene["duration_s"] = 10;
  }
};

TEST(UnattendedRun, StoresNobodysTrialsWithTheirThresholdsAndReplays) {
  const ShortDistribution study;
  const ProgramResult ran = study.run({});
  ASSERT_EQ(ran.status, 0) << ran.errors;
  EXPECT_EQ(ran.output, "Saved in a.sqlite: participant nobody, session 1\n");
  EXPECT_EQ(study.asked("SELECT group_concat(pseudonym || simulated) FROM participant"), "nobody1");
  EXPECT_EQ(study.asked("SELECT count(*) FROM enrolment WHERE finished_utc IS NOT NULL"), "1");
  EXPECT_EQ(study.asked("SELECT count(*) FROM trial WHERE solved LIKE "
                        "'{\"/engine/schedule/thresholds/0\":%}'"),
            "2");
  EXPECT_EQ(study.asked("SELECT sum(length(digests)) || ',' || count(*) FROM step"), "1280,1202")
      << "of the starts alone: 80 bodies, four fields of 16 bits";
  EXPECT_EQ(study.asked("SELECT count(*) FROM collision WHERE priority IS NULL OR distance_m IS "
                        "NULL OR speed_deg_s IS NULL OR collision_speed_deg_s IS NULL"),
            "0");
  EXPECT_EQ(study.asked("SELECT count(*) > 100 FROM seen_collision"), "1");
  const ProgramResult replayed = run_program(study.folder, {"replay", "a.sqlite"});
  EXPECT_EQ(replayed.status, 0) << replayed.output;
  EXPECT_TRUE(replayed.output.starts_with("2 trials, 1200 steps, ")) << replayed.output;
}

TEST(UnattendedRun, IsBeforeTheScreenOfTheFileThatIsGiven) {
  const ShortDistribution study;
  study.folder.write(
      "s.json",
      R"({"schema_version": 1, "width_cm": 60, "height_cm": 34, "viewing_distance_cm": 80})");
  const ProgramResult ran = study.run({"--screen", "s.json"});
  ASSERT_EQ(ran.status, 0) << ran.errors;
  EXPECT_EQ(study.asked("SELECT screen_width_m || ' ' || screen_width_px || ' ' || screen_measured "
                        "FROM session"),
            "0.6 1807 1");
}

TEST(UnattendedRun, ASecondSessionSaysThatItGoesOnAndTheStudyMerges) {
  const ShortDistribution study;
  ASSERT_EQ(study.run({}).status, 0);
  SQLite::Database((study.folder / "a.sqlite").string(), SQLite::OPEN_READWRITE)
      .exec(
          "DELETE FROM step WHERE attempt_id = 2; DELETE FROM collision WHERE attempt_id = 2; "
          "DELETE FROM attempt WHERE id = 2; UPDATE enrolment SET finished_utc = NULL");
  ASSERT_EQ(study.run({}).status, 0);
  EXPECT_EQ(study.asked("SELECT count(first_slot) || resumed_at || first_slot FROM session WHERE "
                        "id = 2"),
            "1trial2");
  const ProgramResult merged =
      run_program(study.folder, {"merge", "a.sqlite", "--into", "all.sqlite"});
  EXPECT_EQ(merged.status, 0) << merged.errors;
  EXPECT_EQ(run_program(study.folder, {"replay", "all.sqlite"}).status, 0);
}

TEST(UnattendedRun, RefusesParticipantsAndWritesNothing) {
  const ShortDistribution study;
  for (const std::string option : {"--participant", "--observer"}) {
    const ProgramResult ran = study.run({option, "P01"});
    EXPECT_EQ(ran.status, 2);
    EXPECT_EQ(ran.errors,
              "impetus: " + option + ": expected none, for nobody takes part in protocol.json\n");
  }
  EXPECT_FALSE(std::filesystem::exists(study.folder / "a.sqlite"));
}

TEST(UnattendedRun, AThresholdThatCannotReachItsShareIsRefusedBeforeARowIsWritten) {
  ShortDistribution study;
  study.protocol["design"]["factors"][0]["levels"] = {"gap-bound", "gap"};
  const ProgramResult ran = study.run({});
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.errors.find("protocol.json:/solve/0: expected a threshold that parts"),
            std::string::npos)
      << ran.errors;
  EXPECT_FALSE(std::filesystem::exists(study.folder / "a.sqlite"));
}

TEST(ResponseRun, FromConsentToThanksWithItsObserverAndReplays) {
  Copied study("response.json", "two-l-blocks-off-centre.json");
  study.protocol["design"]["repetitions"] = 1;
  study.protocol["solve"][0]["runs"] = 20;
  const std::string observer = source_folder() + "/experiments/observers/response.json";
  const ProgramResult ran = study.run({"--observer", observer, "--participant", "S01"});
  ASSERT_EQ(ran.status, 0) << ran.errors;
  EXPECT_EQ(study.asked("SELECT count(*) FROM rated_trial WHERE phase = 'main'"), "27");
  EXPECT_EQ(study.asked("SELECT count(*) FROM answer WHERE question = 'strategy'"), "1");
  EXPECT_EQ(study.asked("SELECT count(*) FROM trial WHERE solved IS NULL"), "0");
  EXPECT_EQ(study.asked("SELECT group_concat(DISTINCT level) FROM collision "
                        "WHERE imposed_spin_a_x_rad_s IS NOT NULL"),
            "0");
  EXPECT_EQ(study.asked("SELECT count(*) FROM collision "
                        "WHERE imposed_spin_b_z_rad_s IS NOT NULL"),
            "11")
      << "nine main trials and two of practice at the root, each once";
  const ProgramResult replayed = run_program(study.folder, {"replay", "a.sqlite"});
  EXPECT_EQ(replayed.status, 0) << replayed.output;
  EXPECT_NE(replayed.output.find(" 0 divergent"), std::string::npos);
}

TEST(GapThresholdsRun, FromConsentToThanksWithItsObserverAndTheTruthIsWhatWasSet) {
  Copied study("gap-thresholds.json", "shells.json");
  study.protocol["design"]["adaptive"]["trials_per_track"] = 3;
  const std::string observer = source_folder() + "/experiments/observers/gap-thresholds.json";
  const ProgramResult ran = study.run({"--observer", observer, "--participant", "S01"});
  ASSERT_EQ(ran.status, 0) << ran.errors;
  EXPECT_EQ(study.asked("SELECT count(*) FROM trial_response WHERE phase = 'main'"), "12");
  const ProgramResult replayed = run_program(study.folder, {"replay", "a.sqlite"});
  EXPECT_EQ(replayed.status, 0) << replayed.output;
  expect_refused(study.folder, {"replay", "none.sqlite", "--truth"},
                 "none.sqlite: expected an Impetus study, but there is no such file");
  EXPECT_FALSE(std::filesystem::exists(study.folder / "none.sqlite"));
  ASSERT_EQ(run_program(study.folder, {"replay", "a.sqlite", "--truth"}).status, 0);
  // Half a pixel of this screen is .9 minutes of arc.
  EXPECT_EQ(study.asked("SELECT count(*) FROM collision_truth "
                        "JOIN collision ON collision.id = collision_id "
                        "JOIN attempt ON attempt.id = attempt_id JOIN trial ON trial.id = trial_id "
                        "WHERE abs(gap_arcmin - json_extract(condition, '$.gap_arcmin')) < 0.001"),
            "18");
}

TEST(GapThresholdsRun, QuestFindsThePlantedThresholdsWithinTwoOfItsStandardDeviations) {
  const Copied study("gap-thresholds.json", "shells.json");
  json observer = json::parse(shipped("experiments/observers/gap-thresholds.json"));
  observer["parameters"]["threshold_sd_log10"]["value"] = 0;
  study.folder.write("observer.json", observer.dump());
  ASSERT_EQ(study.run({"--observer", "observer.json", "--participant", "S01"}).status, 0);
  for (const double above_deg : {0.0, 8.0}) {
    for (const double distractors : {0.0, 8.0}) {
      const std::string track =
          " FROM trial WHERE track IS NOT NULL AND json_extract(condition, "
          "'$.eccentricity_deg') = " +
          std::to_string(above_deg) +
          " AND json_extract(condition, '$.distractors') = " + std::to_string(distractors) +
          " ORDER BY slot DESC LIMIT 1";
      const auto known = [&](const std::string& name) {
        return std::stod(
            study.asked("SELECT json_extract(adaptive_state, '$." + name + "')" + track));
      };
      // 10′ (1 + e/2.3)(60 / G(8°/s))(1 + .05 (N − 2)), G(8) = 57.69 − 27.78 log₁₀ 8 = 32.60
      const double planted =
          std::log10(10.0 * (1.0 + above_deg / 2.3) * 60.0 / 32.602 * (1.0 + 0.05 * distractors));
      EXPECT_NEAR(known("threshold"), planted, 2.0 * known("threshold_sd"))
          << above_deg << "°, " << distractors << " distractors";
      EXPECT_LT(known("threshold_sd"), 0.12);
    }
  }
}

}  // namespace impetus::unattended_run_test
