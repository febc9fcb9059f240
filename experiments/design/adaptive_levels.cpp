// SPDX-License-Identifier: MIT
#include "experiments/design/adaptive_levels.hpp"

#include <algorithm>

namespace impetus::inline design {
namespace {

std::size_t place_of(const std::vector<Factor>& factors, const std::string& name) {
  const auto found = std::find_if(factors.begin(), factors.end(),
                                  [&](const Factor& factor) { return factor.name == name; });
  return static_cast<std::size_t>(found - factors.begin());
}

std::size_t index_of(const std::vector<LevelValue>& levels, const LevelValue& level) {
  const auto found = std::find(levels.begin(), levels.end(), level);
  return static_cast<std::size_t>(found - levels.begin());
}

std::vector<double> numbers(const std::vector<LevelValue>& levels) {
  std::vector<double> numbers;
  numbers.reserve(levels.size());
  for (const LevelValue& level : levels) {
    numbers.push_back(std::get<double>(level));
  }
  return numbers;
}

}  // namespace

std::vector<TrackPlan> adaptive_tracks(const Design& design) {
  Design others = design;
  const std::size_t place = place_of(design.factors, design.adaptive->factor);
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
  factor_ = place_of(design.factors, design.adaptive->factor);
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

ChosenLevel AdaptiveLevels::choose(const PlannedTrial& trial) const {
  const AdaptiveTrack& track = tracks_.at(static_cast<std::size_t>(trial.track.value()));
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
    tracks_.at(static_cast<std::size_t>(*shown.track))
        .answer(level, known ? positive : std::nullopt);
  }
}

bool has_its_level(const PlannedTrial& trial, const Design& design) {
  return trial.condition.size() == design.factors.size();
}

}  // namespace impetus::inline design
