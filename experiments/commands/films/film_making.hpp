// From what was shown to a film: each frame painted, written, and told of in the file beside it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/commands/films/film_file.hpp"
#include "experiments/viewers/replays/film_painter.hpp"
#include "experiments/viewing/film.hpp"

namespace impetus::inline commands {

/// How a film is made, whatever it is of.
struct FilmLook {
  PictureSize size;
  FilmOverlays overlays;
};

/// What somebody who has many films wants to know of each.
struct FilmSums {
  std::size_t frames{0};
  double seconds{0.0};
  std::optional<std::size_t> contact_frame{};  ///< the first that shows bodies touch
  std::optional<double> contact_s{};           ///< of the film
  std::size_t collisions{0};                   ///< contacts that begin
  std::optional<int> level{};                  ///< of the first
  std::optional<double> gap_arcmin{};          ///< the same
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
