// SPDX-License-Identifier: MIT
#include "experiments/viewing/film.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline viewing {
namespace {

/// From a frame's flip to the next one's. A flip's slot is the one that it was due in and those
/// that it missed; what lies between two slots is rounded, for the screen's rate is never quite
/// nominal.
double refreshes_between(const Flip& flip, const Flip& next, double refresh_hz) {
  const double due_s = static_cast<double>(next.scheduled_ns - flip.scheduled_ns) / 1e9;
  return std::max(1.0, std::round(due_s * refresh_hz) +
                           static_cast<double>(next.missed_slots - flip.missed_slots));
}

}  // namespace

double refreshes(const Film& film) {
  double sum = 1.0;
  for (std::size_t i = 0; i + 1 < film.frames.size(); ++i) {
    sum += refreshes_between(film.frames[i].flip, film.frames[i + 1].flip, film.refresh_hz);
  }
  return sum;
}

std::vector<FilmFrame> film_frames(const Film& film) {
  using Kind = FilmFrame::Kind;
  std::vector<FilmFrame> all;
  for (std::size_t i = 0; i < film.frames.size(); ++i) {
    all.push_back({Kind::kShown, i});
    if (i + 1 < film.frames.size()) {
      const FrameRecord& next = film.frames[i + 1];
      const bool stays = next.interval == film.frames[i].interval;
      const double until_next = refreshes_between(film.frames[i].flip, next.flip, film.refresh_hz);
      all.insert(all.end(), static_cast<std::size_t>(until_next) - 1,
                 {stays ? Kind::kHeld : Kind::kBetween, i});
    }
  }
  return all;
}

}  // namespace impetus::inline viewing
