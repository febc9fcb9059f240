// SPDX-License-Identifier: MIT
#include "experiments/design/adaptive_levels.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

namespace impetus::inline design {
namespace {

std::size_t index_of(const std::vector<LevelValue>& levels, const LevelValue& level) {
  const auto found = std::find(levels.begin(), levels.end(), level);
  return static_cast<std::size_t>(found - levels.begin());
}

std::string text_at(const std::vector<FactorLevel>& values, const std::string& name) {
  const FactorLevel* value = find_level(values, name);
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

std::size_t AdaptiveTrack::level() const {
  return std::visit([](const auto& method) { return method.level(); }, method_);
}

void AdaptiveTrack::answer(std::size_t level, std::optional<bool> positive) {
  ++trials_;
  if (!positive) {
    return;
  }
  if (auto* staircase = std::get_if<StaircaseTrack>(&method_)) {
    staircase->answer(*positive);
  } else {
    std::get<QuestPlusTrack>(method_).answer(level, *positive);
  }
}

std::vector<FactorLevel> AdaptiveTrack::state() const {
  std::vector<FactorLevel> state{{"trials", static_cast<double>(trials_)}};
  for (FactorLevel& known :
       std::visit([](const auto& method) { return method.state(); }, method_)) {
    state.push_back(std::move(known));
  }
  return state;
}

std::vector<TrackPlan> adaptive_tracks(const Design& design) {
  if (!design.adaptive) {
    return {};
  }
  Design others = design;
  const std::size_t place = factor_place(design, design.adaptive->factor);
  others.factors.erase(others.factors.begin() + static_cast<std::ptrdiff_t>(place));
  std::vector<TrackPlan> tracks;
  for (const Condition& cell : cells(others)) {
    if (const auto* staircase = std::get_if<Staircase>(&design.adaptive->method)) {
      for (const LevelValue& start : staircase->starts) {
        tracks.push_back({cell, index_of(design.factors[place].levels, start)});
      }
    } else {
      tracks.push_back({cell, 0});
    }
  }
  return tracks;
}

AdaptiveLevels::AdaptiveLevels(const Design& design) : design_(design) {
  if (!design.adaptive) {
    return;
  }
  factor_ = factor_place(design, design.adaptive->factor);
  const std::vector<LevelValue>& levels = design.factors[factor_].levels;
  std::shared_ptr<const PsychometricTable> table;
  if (const auto* quest_plus = std::get_if<QuestPlus>(&design.adaptive->method)) {
    table = table_of(*quest_plus, numbers(levels));
  }
  for (const TrackPlan& track : adaptive_tracks(design)) {
    if (const auto* staircase = std::get_if<Staircase>(&design.adaptive->method)) {
      tracks_.emplace_back(StaircaseTrack(*staircase, levels.size(), track.start));
    } else {
      tracks_.emplace_back(QuestPlusTrack(table));
    }
  }
}

std::size_t AdaptiveLevels::place_of_track(const PlannedTrial& trial) const {
  const std::int64_t track = trial.track.value();
  if (track < 0 || static_cast<std::size_t>(track) >= tracks_.size()) {
    throw std::runtime_error("trial " + std::to_string(trial.slot) +
                             " of the plan: expected one of " + std::to_string(tracks_.size()) +
                             " tracks, got track " + std::to_string(track));
  }
  return static_cast<std::size_t>(track);
}

ChosenLevel AdaptiveLevels::choose(const PlannedTrial& trial) const {
  const AdaptiveTrack& track = tracks_[place_of_track(trial)];
  const Factor& factor = design_.factors[factor_];
  ChosenLevel chosen{trial.slot, trial.condition, track.state()};
  std::erase_if(chosen.condition,
                [&](const FactorLevel& level) { return level.factor == factor.name; });
  chosen.condition.insert(chosen.condition.begin() + static_cast<std::ptrdiff_t>(factor_),
                          {factor.name, factor.levels[track.level()]});
  return chosen;
}

void AdaptiveLevels::take(const PlannedTrial& shown, std::optional<bool> positive) {
  if (shown.track) {
    const std::vector<LevelValue>& levels = design_.factors[factor_].levels;
    const std::size_t level = index_of(levels, shown.condition.at(factor_).value);
    const bool known = level < levels.size();
    tracks_[place_of_track(shown)].answer(level, known ? positive : std::nullopt);
  }
}

bool has_its_level(const PlannedTrial& trial, const Design& design) {
  return trial.condition.size() == design.factors.size();
}

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
