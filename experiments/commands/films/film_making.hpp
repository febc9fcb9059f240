// From what was shown to a film: each frame painted, written, and told of in the file beside it.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "experiments/commands/films/film_file.hpp"
#include "experiments/commands/films/film_record.hpp"
#include "experiments/viewers/replays/film_painter.hpp"
#include "experiments/viewing/film.hpp"

namespace impetus::inline commands {

/// How a film is made, whatever it is of.
struct FilmLook {
  PictureSize size;
  FilmOverlays overlays;
};

/// ["gaze", "contacts"]: the overlays by their names, as --show has them.
nlohmann::ordered_json overlay_names(const FilmOverlays& overlays);

/// Makes a film of the target that require_filmable() let pass, and beside it what is in it, of
/// which `head` is the begin. `tell` is told the share that is done. Throws std::runtime_error with
/// one sentence when it cannot be written; then nothing of it is left.
FilmSums make_film(const Film& film, const FilmTarget& target, const FilmLook& look,
                   nlohmann::ordered_json head, FilmPainter& painter,
                   const std::function<void(double)>& tell);

}  // namespace impetus::inline commands
