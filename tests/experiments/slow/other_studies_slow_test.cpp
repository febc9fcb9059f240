// Whole studies: ten minutes of eighty bodies by seven schedulers, and all of response.
// SPDX-License-Identifier: MIT
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/experiments/program.hpp"
#include "tests/places/places.hpp"

namespace impetus::other_studies_slow_test {

const std::string kSource = source_folder();

/// The whole distribution study, run once, and its shares.
class Distributions {
 public:
  Distributions() {
    ran_ = run_program(
        folder_, {"run", kSource + "/protocols/scheduler-distribution.json", "--db", "d.sqlite"});
    replayed_ = run_program(folder_, {"replay", "d.sqlite"});
  }

  static const Distributions& once() {
    static const Distributions all;
    return all;
  }

  [[nodiscard]] const ProgramResult& ran() const { return ran_; }
  [[nodiscard]] const ProgramResult& replayed() const { return replayed_; }
  [[nodiscard]] double megabytes() const {
    return static_cast<double>(std::filesystem::file_size(folder_ / "d.sqlite")) / 1e6;
  }

  /// Of a scheduler's collisions of two bodies, sorted by `column` into parts of equal count, the
  /// share of high priority in each.
  [[nodiscard]] std::vector<double> shares(const std::string& scheduler, const std::string& column,
                                           int parts = 10) const {
    SQLite::Database database((folder_ / "d.sqlite").string(), SQLite::OPEN_READONLY);
    SQLite::Statement query(
        database, "SELECT avg(list = 0) FROM (SELECT list, ntile(" + std::to_string(parts) +
                      ") OVER (ORDER BY " + column +
                      ") AS part FROM collision JOIN attempt ON attempt.id = attempt_id "
                      "JOIN trial ON trial.id = trial_id WHERE body_b NOT LIKE 'wall %' "
                      "AND json_extract(condition, '$.scheduler') = ?) GROUP BY part");
    query.bind(1, scheduler);
    std::vector<double> shares;
    while (query.executeStep()) {
      shares.push_back(query.getColumn(0).getDouble());
    }
    return shares;
  }

 private:
  TemporaryFolder folder_;
  ProgramResult ran_;
  ProgramResult replayed_;
};

std::vector<double> shares(const std::string& scheduler, const std::string& column) {
  return Distributions::once().shares(scheduler, column);
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

/// Nearly all on one side of the middle, nearly none on the other.
void expect_step(const std::vector<double>& shares, bool falls) {
  ASSERT_EQ(shares.size(), 10U);
  const double first = falls ? shares.front() : shares.back();
  const double last = falls ? shares.back() : shares.front();
  EXPECT_GT(first, 0.98);
  EXPECT_LT(last, 0.02);
  EXPECT_GT(falls ? shares[2] : shares[7], 0.9);
  EXPECT_LT(falls ? shares[7] : shares[2], 0.1);
}

/// The least and the greatest share differ by no more than chance of some thousand collisions in
/// ten parts, five standard errors on either side, and a little of a real slope.
void expect_flat(const std::vector<double>& shares, const std::string& what, double most = 0.2) {
  const auto [least, greatest] = std::minmax_element(shares.begin(), shares.end());
  EXPECT_LT(*greatest - *least, most) << what;
}

TEST(SchedulerShapes, EveryListHasHalfOfTheCollisionsAndTheStudyReplays) {
  const Distributions& all = Distributions::once();
  ASSERT_EQ(all.ran().status, 0) << all.ran().errors;
  EXPECT_EQ(all.replayed().status, 0) << all.replayed().output;
  EXPECT_NE(all.replayed().output.find("252000 steps"), std::string::npos);
  EXPECT_LT(all.megabytes(), 60.0);
  for (const char* scheduler : {"distance", "size", "velocity", "eccentricity", "gap",
                                "projected-centres", "collision-speed"}) {
    EXPECT_NEAR(mean_of(shares(scheduler, "distance_m")), 0.5, 0.05) << scheduler;
  }
}

TEST(SchedulerShapes, DistanceAndSizeAreStepsInDepth) {
  expect_step(shares("distance", "distance_m"), true);
  expect_step(shares("size", "distance_m"), true);
}

TEST(SchedulerShapes, SpeedIsAStepInSpeedAndItsShareRisesWithDepth) {
  expect_step(shares("velocity", "speed_deg_s"), true);
  const std::vector<double> by_depth = shares("velocity", "distance_m");
  EXPECT_GT(by_depth.back() - by_depth.front(), 0.3);
}

TEST(SchedulerShapes, EccentricityIsAStepInEccentricityAndFlatInDepth) {
  expect_step(shares("eccentricity", "eccentricity_deg"), true);
  // But for the nearest and the farthest tenth: bodies keep a radius from the walls that meet in
  // the eye, which takes more from the eccentricities they can have the nearer they are.
  std::vector<double> by_depth = shares("eccentricity", "distance_m");
  EXPECT_GT(by_depth.front(), by_depth.back());
  by_depth.erase(by_depth.begin());
  by_depth.pop_back();
  expect_flat(by_depth, "eccentricity by depth");
}

TEST(SchedulerShapes, GapIsFlatInDepthAndEccentricity) {
  expect_flat(shares("gap", "distance_m"), "gap by depth");
  expect_flat(shares("gap", "eccentricity_deg"), "gap by eccentricity");
}

TEST(SchedulerShapes, ProjectedGapFallsWithDepth) {
  const std::vector<double> by_depth = shares("projected-centres", "distance_m");
  EXPECT_GT(by_depth.front() - by_depth.back(), 0.3);
}

TEST(SchedulerShapes, CollisionSpeedIsWeak) {
  const std::vector<double> by_depth = shares("collision-speed", "distance_m");
  const std::vector<double> velocity_by_depth = shares("velocity", "distance_m");
  EXPECT_LT(by_depth.back() - by_depth.front(),
            velocity_by_depth.back() - velocity_by_depth.front());
}

TEST(ResponseStudyWhole, RunsFromConsentToThanksAndReplays) {
  const TemporaryFolder folder;
  const ProgramResult ran =
      run_program(folder, {"run", kSource + "/protocols/response.json", "--db", "r.sqlite",
                           "--observer", "response", "--participant", "S01"});
  ASSERT_EQ(ran.status, 0) << ran.errors;
  SQLite::Database database((folder / "r.sqlite").string(), SQLite::OPEN_READONLY);
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM rated_trial WHERE phase = 'main'").getInt(),
            81);
  const ProgramResult replayed = run_program(folder, {"replay", "r.sqlite"});
  EXPECT_EQ(replayed.status, 0) << replayed.output;
}

}  // namespace impetus::other_studies_slow_test
