// SPDX-License-Identifier: MIT
#include "engine/world/level_pops.hpp"

#include <algorithm>
#include <utility>

#include "engine/scheduling/gap_metrics.hpp"

namespace impetus::inline world {
namespace {

double fit_error_m(const BodyPair& bodies, int level, const std::vector<BodyModel>& models) {
  double sum_m = 0.0;
  for (const std::int32_t body : {bodies.a, bodies.b}) {
    sum_m += is_wall(body) ? 0.0 : models[static_cast<std::size_t>(body)].tree->fit_error_m(level);
  }
  return sum_m;
}

bool comes_before(const TouchingLevel& x, const TouchingLevel& y) {
  return std::pair(x.bodies.a, x.bodies.b) < std::pair(y.bodies.a, y.bodies.b);
}

}  // namespace

void LevelMemory::note(const std::vector<TouchingLevel>& touching,
                       const std::vector<BodyModel>& models, const Viewer& viewer,
                       std::vector<LevelPop>& pops) {
  for (const TouchingLevel& now : touching) {
    const auto then = std::lower_bound(before_.begin(), before_.end(), now, comes_before);
    if (then == before_.end() || !(then->bodies == now.bodies) || now.level >= then->level) {
      continue;
    }
    const double grown_m =
        fit_error_m(now.bodies, now.level, models) - fit_error_m(now.bodies, then->level, models);
    pops.push_back({now.bodies, then->level, now.level,
                    spanned_by_length_deg(std::max(0.0, grown_m), now.place, viewer)});
  }
  before_ = touching;
}

}  // namespace impetus::inline world
