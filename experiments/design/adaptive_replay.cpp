// SPDX-License-Identifier: MIT
#include "experiments/design/adaptive_replay.hpp"

#include <algorithm>
#include <set>

namespace impetus::inline design {
namespace {

const FactorLevel* find(const std::vector<FactorLevel>& values, const std::string& name) {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const FactorLevel& one) { return one.factor == name; });
  return found == values.end() ? nullptr : &*found;
}

std::string text_at(const std::vector<FactorLevel>& values, const std::string& name) {
  const FactorLevel* value = find(values, name);
  return value == nullptr ? "missing" : to_text(value->value);
}

/// How the recorded choice differs from the derived one; "" when it does not.
std::string difference(const ChosenLevel& recorded, const ChosenLevel& derived,
                       const std::string& factor) {
  const std::string then = text_at(recorded.condition, factor);
  const std::string now = text_at(derived.condition, factor);
  if (then != now) {
    return "the level chosen was " + then + ", derived anew it is " + now;
  }
  for (const FactorLevel& value : derived.state) {
    const std::string stored = text_at(recorded.state, value.factor);
    if (stored != to_text(value.value)) {
      return "the level was chosen with " + value.factor + " " + stored + ", derived anew it is " +
             to_text(value.value);
    }
  }
  return "";
}

}  // namespace

std::vector<LevelDivergence> level_divergences(const Design& design,
                                               const std::vector<RecordedLevel>& recorded) {
  AdaptiveLevels levels(design);
  const auto tracks = static_cast<std::int64_t>(adaptive_tracks(design).size());
  std::set<std::int64_t> diverged;
  std::vector<LevelDivergence> divergences;
  for (const RecordedLevel& trial : recorded) {
    if (trial.track < 0 || trial.track >= tracks) {
      divergences.push_back({trial.trial_id, "its track is " + std::to_string(trial.track) +
                                                 ", but the design has " + std::to_string(tracks)});
      continue;
    }
    PlannedTrial planned;
    planned.slot = trial.chosen.slot;
    planned.condition = trial.chosen.condition;
    planned.track = trial.track;
    const std::string words =
        difference(trial.chosen, levels.choose(planned), design.adaptive->factor);
    if (!words.empty() && diverged.insert(trial.track).second) {
      divergences.push_back({trial.trial_id, words});
    }
    if (trial.completed) {
      levels.take(planned, trial.counted_answer);
    }
  }
  return divergences;
}

}  // namespace impetus::inline design
