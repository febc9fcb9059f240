// The film of a stimulus that nobody was shown yet: what it would look like, on a screen that
// misses no refresh, to somebody who looks nowhere.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/design/plan.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/viewing/film.hpp"

namespace impetus::inline commands {

/// What a session would draw with the trial's seed is drawn with this one.
inline constexpr std::uint64_t kFilmSeed = 1;

/// Simulates the scene to its end. `clock` times budgets in milliseconds.
Film simulated_film(StagedScene scene, double refresh_hz, const Clock& clock);

/// A planned stimulus that differs from those before it.
struct PlannedFilm {
  std::string part;  ///< "main", "practice", "catch", "adaptation" or "standard"
  PlannedTrial trial;
};

/// All that a protocol shows, each once: practice, main trials, catch trials and adaptation, in
/// each group, with standards; of stimuli that start at random each repetition. `scenes` are the
/// protocol's. Throws InputError.
std::vector<PlannedFilm> planned_films(const Protocol& protocol, const ProtocolScenes& scenes,
                                       const ScreenGeometry& screen);

}  // namespace impetus::inline commands
