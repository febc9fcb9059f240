// A whole protocol as films, for a lab that shows them by another program: one of each stimulus,
// and a table of what is in each.
//
//   folder/films.csv
//   folder/main-001-delay_ms-0-speed_deg_s-5.mp4, .json
//   folder/main-002-...
//
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "experiments/commands/films/film_making.hpp"
#include "experiments/commands/films/simulated_film.hpp"

namespace impetus::inline commands {

/// What a protocol's films are to be like.
struct ProtocolFilms {
  std::filesystem::path folder;
  const FilmFormat* format{nullptr};  ///< null: each is a folder of PNG files
  FilmLook look;
  ScreenGeometry screen;
  double refresh_hz{60.0};
  bool allow_rounding{false};
};

/// Makes them; returns how many. Throws InputError, or std::runtime_error when they cannot be
/// written, each in one sentence; then nothing is left of them.
std::size_t make_protocol_films(const Protocol& protocol, const ProtocolFilms& asked);

}  // namespace impetus::inline commands
