// The film of a recorded trial: every frame that the participant was shown, at its flip.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/store/study_reader.hpp"
#include "experiments/viewing/film.hpp"

namespace impetus::inline commands {

/// The attempt of a trial that is asked for: of this number, or else the completed one, or else the
/// last. Throws InputError when there is none.
StoredAttempt filmed_attempt(StudyFile& study, std::int64_t trial,
                             std::optional<std::int64_t> number);

/// A film, and what the JSON beside it begins with.
struct RecordedFilm {
  Film film;
  nlohmann::ordered_json head;
};

/// Simulates the attempt again and takes what was shown. Throws InputError, in one sentence, when
/// nothing was shown, this build does not replay it, or the simulation diverges: then the film
/// would not be what the participant saw.
RecordedFilm recorded_film(StudyFile& study, const StoredAttempt& attempt);

}  // namespace impetus::inline commands
