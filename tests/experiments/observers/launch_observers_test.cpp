// The simulated participants of launches that are imposed: what they answer of stimuli of their
// own.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "experiments/protocol/observer_file.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::launch_observers_test {

StagedScene launch_with_gap(double gap_px, const char* stimulus = "stimuli/launch-or-pass.json") {
  return built(changed(json::parse(shipped(stimulus)), "/launch/gap_px", gap_px));
}

/// Of the shipped numbers, with some of them changed.
struct Someone {
  Someone(const char* file, const json& numbers) {
    json observer = json::parse(shipped(std::string("experiments/observers/") + file));
    for (const auto& [parameter, number] : numbers.items()) {
      observer["parameters"][parameter]["value"] = number;
    }
    const std::string path = folder.write("o.json", observer.dump()).string();
    file_ = load_observer(path, "protocols/causality.json");
    self = make_observer(*file_, {1, name, clock, clock});
  }

  double sees(const StagedScene& scene) {
    AttemptRecord shown;
    shown.onset_ns = 1'000'000'000;
    shown.frames.emplace_back();
    shown.frames.back().flip.flipped_ns = 9'000'000'000;
    self->witnessed(shown, scene);
    return self->seen_in_intervals().back();
  }

  TemporaryFolder folder;
  std::string name{"S01"};
  VirtualClock clock;
  std::optional<ObserverFile> file_;
  std::unique_ptr<RatingObserver> self;
};

TEST(AdaptingObserver, SeesALaunchTheRatherTheLessTheyOverlap) {
  Someone one("launch-or-pass.json", {{"overlap_threshold_sd", 0.0}, {"shift", 0.0}});
  EXPECT_GT(one.sees(launch_with_gap(0)), 0.99);
  EXPECT_NEAR(one.sees(launch_with_gap(-30)), 0.5, 1e-3);
  EXPECT_LT(one.sees(launch_with_gap(-60)), 0.01);
  EXPECT_LT(one.sees(launch_with_gap(-120)), 1e-6) << "a slip";
}

TEST(AdaptingObserver, LaunchesWearOffAndSlipsDoNot) {
  const json numbers{{"overlap_threshold_sd", 0.0}, {"shift", 0.2}};
  Someone adapted("launch-or-pass.json", numbers);
  Someone slipped("launch-or-pass.json", numbers);
  const StagedScene launch = launch_with_gap(0);
  const StagedScene slip = launch_with_gap(-120);
  for (int adaptor = 0; adaptor < 320; ++adaptor) {
    adapted.sees(launch);
    slipped.sees(slip);
  }
  const StagedScene test = launch_with_gap(-30);
  EXPECT_LT(adapted.sees(test), 0.15);
  EXPECT_NEAR(slipped.sees(test), 0.5, 1e-3);
}

TEST(AwaitingObserver, ClicksWhenTheBoundsTouchThatItImagines) {
  const json sets =
      json::parse(shipped("protocols/behind-the-curtain.json"))["design"]["factors"][0]["sets"];
  const json exact{
      {"bias_ms", 0.0}, {"bias_sd_ms", 0.0}, {"timing_sd_ms", 0.0}, {"lapse_rate", 0.0}};
  const auto clicks_at_s = [&](double level, const std::string& shape) {
    json scene = json::parse(shipped("stimuli/behind-the-curtain.json"));
    for (const auto& [pointer, value] : sets[shape].items()) {
      scene[json::json_pointer(pointer)] = value;
    }
    json numbers = exact;
    numbers["level"] = level;
    Someone one("behind-the-curtain.json", numbers);
    one.sees(built(scene));
    const std::vector<ClickRecord> clicks = one.self->take_clicks();
    return clicks.empty() ? -1.0 : 1e-9 * static_cast<double>(clicks[0].arrived_ns) - 1.0;
  };
  EXPECT_NEAR(clicks_at_s(-1, "H concave"), sets["H concave"]["/launch/lead_s"], 1e-6);
  EXPECT_LT(clicks_at_s(0, "H concave"), clicks_at_s(-1, "H concave") - 0.3);
  EXPECT_NEAR(clicks_at_s(0, "H concave"), clicks_at_s(0, "H convex"), 0.25) << "much alike";
}

}  // namespace impetus::launch_observers_test
