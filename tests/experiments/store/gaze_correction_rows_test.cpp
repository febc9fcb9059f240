// The correction that a study file gives for an attempt's raw gaze, against what its steps used.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>

#include "experiments/gaze/gaze_trail.hpp"
#include "experiments/store/step_rows.hpp"
#include "experiments/store/study_reader.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::gaze_correction_rows_test {

/// A simulated participant's session of the shipped gaze-contingent study, with short stimuli.
std::string recorded_session(const TemporaryFolder& folder) {
  json protocol = json::parse(shipped("protocols/gaze-contingent.json"));
  json scene = json::parse(shipped("stimuli/l-blocks-in-a-cube.json"));
  scene["duration_s"] = 0.3;
  protocol["design"]["repetitions"] = 1;
  protocol["design"]["factors"][1]["levels"] = {5};
  protocol["design"].erase("practice");
  protocol["design"].erase("practice_until");
  protocol["session"].erase("demonstrations");
  folder.write("protocols/short.json", protocol.dump());
  folder.write("stimuli/l-blocks-in-a-cube.json", scene.dump());
  folder.write("experiments/observers/gaze-contingent.json",
               shipped("experiments/observers/gaze-contingent.json"));
  const ProgramResult result =
      run_program(folder, {"run", "protocols/short.json", "--db", "a.sqlite", "--observer",
                           "gaze-contingent", "--participants", "1"});
  EXPECT_EQ(result.status, 0) << result.errors;
  return (folder / "a.sqlite").string();
}

TEST(GazeCorrectionRows, MakeOfRawSamplesWhatTheStepsUsed) {
  const TemporaryFolder folder;
  StudyFile study = StudyFile::open_for_reading(recorded_session(folder));
  std::int64_t compared = 0;
  double most_corrected_m = 0.0;
  for (const StoredAttempt& attempt : load_attempts(study)) {
    const GazeCorrection correction = load_gaze_correction(study, attempt.id);
    std::map<std::int64_t, ScreenPoint> raw;
    for (const GazeSample& sample : load_gaze(study, attempt.id)) {
      if (sample.at) {
        raw[sample.taken_ns] = *sample.at;
      }
    }
    for (const StepRecord& step : load_steps(study.database(), attempt.id)) {
      const auto sample = raw.find(step.gaze.taken_ns);
      if (step.gaze.fixation && sample != raw.end()) {
        EXPECT_EQ(correction.corrected(sample->second), *step.gaze.fixation);
        most_corrected_m =
            std::max(most_corrected_m, std::abs(step.gaze.fixation->x_m - sample->second.x_m));
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 100);
  EXPECT_GT(most_corrected_m, 1e-4);  // the simulated eye has an offset: there was something to do
}

}  // namespace impetus::gaze_correction_rows_test
