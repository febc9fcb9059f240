// The designs of the shipped protocols: they enumerate as the studies state, and are balanced.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "experiments/design/adaptive_levels.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "tests/experiments/fakes.hpp"

namespace impetus::shipped_designs_test {

/// All of them, loaded once.
const std::vector<Protocol>& shipped_protocols() {
  static const std::vector<Protocol> protocols = [] {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(source_file("protocols"))) {
      if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema") {
        paths.push_back(entry.path());
      }
    }
    std::sort(paths.begin(), paths.end());
    std::vector<Protocol> loaded;
    for (const std::filesystem::path& path : paths) {
      loaded.push_back(load_protocol(path));
    }
    return loaded;
  }();
  return protocols;
}

/// Main trials, catch trials apart, of the studies whose number of trials is stated.
const std::map<std::string, std::size_t> kStated{{"causality", 81},
                                                 {"gap", 81},
                                                 {"response", 81},
                                                 {"gaze-contingent", 36},
                                                 {"causality-thresholds", 140},
                                                 {"causality-thresholds-quest", 120}};

TEST(ShippedDesigns, EnumerateAsStated) {
  std::size_t stated = 0;
  for (const Protocol& protocol : shipped_protocols()) {
    const Plan plan = plan_for(protocol, "P01", 1);
    const auto main = std::count_if(plan.begin(), plan.end(), [](const PlannedTrial& trial) {
      return trial.phase == TrialPhase::kMain && !trial.catch_trial;
    });
    const auto expected = kStated.find(protocol.name);
    if (expected != kStated.end()) {
      EXPECT_EQ(static_cast<std::size_t>(main), expected->second) << protocol.name;
      ++stated;
    }
    EXPECT_GT(main, 0) << protocol.name;
  }
  EXPECT_GE(stated, 5U);  // nothing is counted where nothing was found
}

TEST(ShippedDesigns, AreBalancedForEveryParticipant) {
  for (const Protocol& protocol : shipped_protocols()) {
    for (const char* participant : {"P01", "P02", "S17"}) {
      std::map<std::string, std::int64_t> shown;
      for (const PlannedTrial& trial : plan_for(protocol, participant, 1)) {
        if (trial.phase == TrialPhase::kMain && !trial.catch_trial) {
          const std::string track = trial.track ? "track " + std::to_string(*trial.track) : "";
          ++shown[to_json(trial.condition).dump() + track];
        }
      }
      const Design& design = protocol.design;
      std::size_t kinds = design.adaptive ? adaptive_tracks(design).size() : cells(design).size();
      for (const Factor& factor : design.factors) {
        kinds /= factor.between ? factor.levels.size() : 1;
      }
      const std::int64_t each =
          design.adaptive ? design.adaptive->trials_per_track : design.repetitions;
      EXPECT_EQ(shown.size(), kinds) << protocol.name;
      for (const auto& [condition, times] : shown) {
        EXPECT_EQ(times, each) << protocol.name << " " << condition;
      }
    }
  }
}

// 0, 2, 4, 6, 9, 12 and 18 frames at 60 Hz are asked for, and are what the freeze really lasts.
TEST(ShippedDesigns, TheDelaysOfCausalityThresholdsAreShownForTheirFrames) {
  const Protocol protocol = load_protocol(source_file("protocols/causality-thresholds.json"));
  check_frames(protocol, 60.0, false);
  const ProtocolScenes scenes(protocol, 0.0);
  std::vector<double> frames;
  for (const Condition& cell : cells(protocol.design)) {
    StagedScene scene = scenes.stage(cell, assumed_screen());
    frames.push_back(scene.realised_hold_s * 60.0);
    // The bodies stand still for as many frames: four steps each.
    std::int64_t still = 0;
    FixedWork work(kUnlimitedTests);
    std::vector<BodyState> before = scene.world.states();
    const auto steps = static_cast<std::int64_t>(scene.duration_s * scene.step_hz);
    for (std::int64_t step = 1; step <= steps; ++step) {
      static_cast<void>(scene.world.step({1.0 / scene.step_hz, scene.viewer, {}, {}}, work));
      const std::vector<BodyState>& after = scene.world.states();
      still += after[0].pose.position == before[0].pose.position ? 1 : 0;
      before = after;
    }
    EXPECT_NEAR(static_cast<double>(still), 4.0 * frames.back(), 1.0 + 1e-3) << frames.back();
  }
  const std::vector<double> expected{0, 2, 4, 6, 9, 12, 18};
  ASSERT_EQ(frames.size(), expected.size());
  for (std::size_t level = 0; level < expected.size(); ++level) {
    EXPECT_NEAR(frames[level], expected[level], 1e-3);
  }
}

}  // namespace impetus::shipped_designs_test
