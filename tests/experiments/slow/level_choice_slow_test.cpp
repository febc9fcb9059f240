// 100 simulated studies of bodies of odd shape: how often a comparison chooses the tree level whose
// bounds the participants see.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>

#include "experiments/fitting/comparison.hpp"
#include "experiments/observers/side_by_side.hpp"
#include "tests/experiments/fitting/answering_group.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::level_choice_slow_test {

constexpr int kLevels = 4;

/// The launches of the study: each shape at each gap.
std::vector<StagedScene> launches() {
  const json design = json::parse(shipped("protocols/odd-shapes.json"))["design"];
  std::vector<StagedScene> scenes;
  for (const auto& [shape, values] : design["factors"][0]["sets"].items()) {
    for (const json& gap_px : design["factors"][1]["levels"]) {
      json scene = json::parse(shipped("stimuli/odd-shapes.json"));
      for (const auto& [pointer, value] : values.items()) {
        scene[json::json_pointer(pointer)] = value;
      }
      scene["launch"]["gap_px"] = gap_px;
      scenes.push_back(built(scene));
    }
  }
  return scenes;
}

ObserverFile who_sees_level(int level) {
  ObserverFile file = observer_with("odd-shapes", {{"level", 1.0 * level}});
  file.document.name = "level " + std::to_string(level);
  return file;
}

/// What each launch is at each level: the same for all studies.
class LaunchesByLevel {
 public:
  LaunchesByLevel() {
    for (int level = 0; level < kLevels; ++level) {
      files_.push_back(who_sees_level(level));
      for (const StagedScene& scene : scenes_) {
        percepts_[level].push_back(
            files_[level].kind->answers.percept(*files_[level].parameters, {}, scene));
      }
    }
  }

  /// What a comparison makes of the marks of people who see bounds at `level`.
  ObserverComparison compared(int level, std::uint64_t seed) const {
    constexpr int kPeople = 16;  // between levels 2 and 3 no gap differs by more than 1.5 arcmin
    std::vector<ComparedObserver> all;
    for (const ObserverFile& file : files_) {
      all.push_back({file.document.name, file.kind, file.parameters, {}});
    }
    for (int i = 0; i < kPeople; ++i) {
      const std::string code = "S" + std::to_string(i);
      VirtualClock clock;
      const auto observer = make_observer(files_[level], {seed, code, clock, clock});
      for (ComparedObserver& one : all) {
        one.people.push_back({code, {}});
      }
      AttemptRecord shown;
      shown.frames.resize(1);
      shown.frames[0].interval = 1;
      for (std::size_t at = 0; at < scenes_.size(); ++at) {
        observer->witnessed(shown, scenes_[at]);
        const Mark mark = rounded_mark(observer->mark());
        for (int by = 0; by < kLevels; ++by) {
          AnsweredTrial& trial = all[by].people.back().trials.emplace_back();
          trial.percepts = {percepts_[by][at]};
          trial.mark = mark;
        }
      }
    }
    return compare_observers(all, 3);
  }

 private:
  std::vector<StagedScene> scenes_{launches()};
  std::vector<ObserverFile> files_;
  std::vector<Percept> percepts_[kLevels];
};

TEST(LevelChoice, ThePlantedLevelIsChosenInNineOfTenStudies) {
  constexpr int kStudies = 100;
  const LaunchesByLevel launches;
  std::atomic<int> right = 0;
  std::atomic<int> done = 0;
  do_side_by_side(kStudies, [&](std::size_t study) {
    const std::size_t planted = study % kLevels;
    const ObserverComparison comparison =
        launches.compared(static_cast<int>(planted), /*seed=*/500 + study);
    right += comparison.chosen == planted ? 1 : 0;
    std::printf("the planted level was chosen in %d of %d studies\n", right.load(), ++done);
    std::fflush(stdout);  // a study takes half a minute
  });
  RecordProperty("right", right.load());
  EXPECT_GE(right, 90);
}

}  // namespace impetus::level_choice_slow_test
