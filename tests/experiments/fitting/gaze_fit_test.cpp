// The fit of one who clicks at collisions that look bad: thresholds, misses and the habit of
// clicking are found again from clicks and ratings.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "engine/numerics/random_stream.hpp"
#include "experiments/fitting/fit.hpp"
#include "tests/experiments/fitting/answering_group.hpp"

namespace impetus::gaze_fit_test {

constexpr std::int64_t kOnset_ns = 1'000'000'000;
constexpr double kStimulus_s = 10.0;

/// Collisions about .7 s apart, of gaps from 3 to 60 minutes of arc, up to 8° from the gaze.
AttemptRecord seconds_of_collisions(RandomStream& stream) {
  AttemptRecord shown;
  shown.onset_ns = kOnset_ns;
  for (double at_s = 0.3 + stream.uniform(); at_s < kStimulus_s; at_s += 0.2 + stream.uniform()) {
    const double gap_arcmin = 3.0 * std::pow(20.0, stream.uniform());
    AttemptRecord one = gap_between_balls(gap_arcmin, 0.0, 5.0 * stream.uniform());
    one.collisions[0].time_s = at_s;
    one.collisions[0].first_frame_shown = 1;
    one.collisions[0].gaze_eccentricity_deg = 8.0 * stream.uniform();
    shown.collisions.push_back(one.collisions[0]);
  }
  shown.frames.resize(1);
  shown.frames[0].flip.flipped_ns = kOnset_ns + std::llround(kStimulus_s * 1e9);
  return shown;
}

std::vector<AnsweringPerson> clicking_group(const ObserverFile& file, int people, int trials,
                                            std::uint64_t seed) {
  const StagedScene scene = two_balls();
  RandomStream stream(seed, "collisions");
  std::vector<AnsweringPerson> group;
  for (int i = 1; i <= people; ++i) {
    const std::string code = "S" + std::to_string(i);
    VirtualClock clock;
    const auto observer = make_observer(file, {seed, code, clock, clock});
    AnsweringPerson& person = group.emplace_back(AnsweringPerson{code, {}});
    for (int number = 0; number < trials; ++number) {
      const AttemptRecord shown = seconds_of_collisions(stream);
      AnsweredTrial& trial = person.trials.emplace_back();
      observer->witnessed(shown, scene);
      trial.percepts = {file.kind->answers.percept(*file.parameters, shown, scene)};
      trial.clicks_s.emplace();
      for (const ClickRecord& click : observer->take_clicks()) {
        trial.clicks_s->push_back(static_cast<double>(click.arrived_ns - kOnset_ns) / 1e9);
      }
      trial.rating_steps = observer->ask(question_page("rating", 5)).choice;
      trial.rating_points = 5;
    }
  }
  return group;
}

// Intervals of 95 %, of nine parameters that clicks and ratings tell: at least seven hold what was
// planted, and those that matter to a schedule are narrow.
TEST(GazeFit, FindsThresholdsMissesAndTheHabitOfClicking) {
  const ObserverFile file = shipped_observer("gaze-contingent");
  const auto group = clicking_group(file, 8, 12, /*seed=*/1);
  const ObserverFit fit = fit_observer(*file.kind, *file.parameters, group, {.starts = 1});
  const std::vector<std::string> told{"threshold_arcmin",   "width_log10",     "miss_rate",
                                      "false_clicks_per_s", "click_median_ms", "click_sigma_log",
                                      "events_per_s",       "effect",          "intercept_sd"};
  int within = 0;
  for (const std::string& name : told) {
    const FittedParameter* one = fit.find(name);
    ASSERT_NE(one, nullptr) << name;
    EXPECT_TRUE(one->is_fitted() || name == "events_per_s" || name == "effect")
        << name << ": " << one->held_because;
    const double planted = number_in(file.document, name);
    within += one->low <= planted && planted <= one->high ? 1 : 0;
  }
  EXPECT_GE(within, 7);
  EXPECT_LT(fit.find("threshold_arcmin")->high / fit.find("threshold_arcmin")->low, 1.5);
}

}  // namespace impetus::gaze_fit_test
