// The film of a stimulus that nobody was shown yet: what it would look like, on a screen that
// misses no refresh, to somebody who looks nowhere.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
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

/// Says of a film whose scene goes by the gaze that nobody looked.
void tell_of_gaze(const Film& film, nlohmann::ordered_json& head);

/// A stimulus of a protocol under one of its conditions.
struct PlannedFilm {
  std::string part;  ///< "main", "catch", "adaptation", "practice" or "standard"
  PlannedTrial trial;
  std::size_t film{0};  ///< conditions that look alike have one film
};

/// All that a protocol shows: main trials, catch trials, adaptation and practice, in each group,
/// with standards; of stimuli that start at random each repetition. Films are numbered from 0 as
/// they come. `scenes` are the protocol's. Throws InputError.
std::vector<PlannedFilm> planned_films(const Protocol& protocol, const ProtocolScenes& scenes,
                                       const ScreenGeometry& screen);

}  // namespace impetus::inline commands
