// SPDX-License-Identifier: MIT
#include "experiments/design/adaptive_track.hpp"

namespace impetus::inline design {

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

}  // namespace impetus::inline design
