// Attempts simulated again: whatever was changed of what their inputs lead to is named.
// SPDX-License-Identifier: MIT
#include "experiments/study/replay_comparison.hpp"

#include <gtest/gtest.h>

#include "tests/experiments/asked_study.hpp"
#include "tests/experiments/small_study.hpp"

namespace impetus::replay_comparison_test {

/// The first problem of a study's attempts; "none" when there is none.
std::string first_problem(const std::filesystem::path& path) {
  StudyFile study = StudyFile::open_for_reading(path);
  ReplayLibrary library(study);
  ReplayComparison comparison(study, library);
  for (const StoredAttempt& attempt : load_attempts(study)) {
    if (std::string problem = comparison.problem_of(attempt); !problem.empty()) {
      return problem;
    }
  }
  return "none";
}

TEST(ReplayComparison, EveryValueIsTheOneThatItsInputsLeadTo) {
  const TemporaryFolder folder;
  const std::filesystem::path whole = small_study(folder / "whole.sqlite");
  const std::filesystem::path path = folder / "a.sqlite";
  const std::string meeting = "the collision of left and right at step 240";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "none"},
      {"UPDATE step SET hash = hash + 1 WHERE step = 100",
       "diverges at step 100, in the hash alone"},
      {"UPDATE step SET work_spent = work_spent + 1 WHERE step = 9",
       "step 9: work_spent is 1, simulated again 0"},
      {"UPDATE step SET degradations = 16 WHERE step = 9",
       "step 9: degradations is 16, simulated again 0"},
      {"UPDATE step SET pops = 2 WHERE step = 9", "step 9: pops is 2, simulated again 0"},
      {"UPDATE step SET largest_pop_deg = 1.5 WHERE step = 9",
       "step 9: largest_pop_deg is 1.5, simulated again nothing"},
      {"UPDATE collision SET depth_m = 0.5", meeting + ": depth_m is 0.5, simulated again "},
      {"UPDATE collision SET impulse_Ns = impulse_Ns * 1.000001", meeting + ": impulse_Ns is "},
      {"UPDATE collision SET level = level + 1", meeting + ": level is "},
      {"UPDATE collision SET stopped = 'budget'",
       meeting + ": stopped is budget, simulated again "},
      {"UPDATE collision SET body_b = 'wall +x'",
       "the collision of left and wall +x at step 240: body_b is wall +x, simulated again right"},
      {"UPDATE collision SET eccentricity_deg = eccentricity_deg + 0.01",
       meeting + ": eccentricity_deg is "},
      {"DELETE FROM collision", meeting + " is not recorded"},
      {"DELETE FROM collision; INSERT INTO collision SELECT * FROM gone; "
       "INSERT INTO collision (attempt_id, step, body_a, body_b, level, stopped, point_x_m, "
       "point_y_m, point_z_m, normal_x, normal_y, normal_z, depth_m, approach_m_s, impulse_Ns, "
       "imposed_hold_ms, imposed_no_spin, eccentricity_deg) SELECT attempt_id, 300, body_a, "
       "body_b, level, stopped, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0 FROM gone",
       "the collision of left and right at step 300 is recorded, but does not come again"},
      {"DELETE FROM step WHERE step = 0", "step 0 is missing"},
      {"DELETE FROM step WHERE step = 300", "step 300 is missing"},
      {"DELETE FROM step WHERE step > 300", "expected steps up to "},
      {"DELETE FROM step", "expected steps up to "},
      {"UPDATE attempt SET onset_ns = 0; DELETE FROM step WHERE step > 300",
       "expected steps up to 480, the last one there is 300"},
      {"UPDATE attempt SET outcome = 'interrupted'; DELETE FROM step WHERE step > 300", "none"},
  };
  for (const auto& [sql, sentence] : cases) {
    std::filesystem::copy_file(whole, path, std::filesystem::copy_options::overwrite_existing);
    tamper(path, "CREATE TEMP TABLE gone AS SELECT * FROM collision; " + sql);
    const std::string found = first_problem(path);
    EXPECT_EQ(found.substr(0, sentence.size()), sentence) << sql << "\n" << found;
  }
}

TEST(ReplayComparison, OfTwoIntervalsTheOneIsNamed) {
  const TemporaryFolder folder;
  const std::filesystem::path path =
      small_study(folder / "a.sqlite", {"P01"}, asked({kAskTwoInterval}));
  EXPECT_EQ(first_problem(path), "none");
  tamper(path, "DELETE FROM step WHERE interval = 2 AND step = 7");
  EXPECT_EQ(first_problem(path), "step 7 of interval 2 is missing");
  tamper(path, "DELETE FROM step WHERE interval = 2");
  EXPECT_NE(first_problem(path).find(" of interval 2, the last one there is -1"),
            std::string::npos);
}

}  // namespace impetus::replay_comparison_test
