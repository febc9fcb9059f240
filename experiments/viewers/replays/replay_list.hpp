// The list of a study's stimuli, over everything else: to go to one by its number or by a click.
//
//   digits    the number that is sought: `trial` of the study's views
//   ↑ ↓       one line up, down; Page Up, Page Down ten
//   Enter     to the line that stands out
//
// SPDX-License-Identifier: MIT
#pragma once

#include <SDL.h>

#include <optional>
#include <string>
#include <vector>

#include "experiments/viewing/viewed_stimuli.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

/// The list, what is typed, and the line that stands out.
class ReplayList {
 public:
  /// `current` stands out when it opens.
  ReplayList(ViewedStimuli& stimuli, std::size_t current);

  void open();
  void close() { open_ = false; }
  [[nodiscard]] bool is_open() const { return open_; }

  /// A key while it is open, or a digit that opens it. Whether it was taken.
  bool press(const SDL_Keysym& key);

  /// Draws into the current ImGui window. Returns the line that was chosen since the last call.
  std::optional<std::size_t> draw(const Gui& gui);

 private:
  void move(int lines);
  void seek();

  std::vector<StimulusLine> lines_;
  std::size_t current_;
  std::size_t marked_;
  std::string number_;  ///< as typed so far
  bool known_{true};    ///< there is such a trial
  bool open_{false};
  bool scrolls_{false};
  std::optional<std::size_t> chosen_;
};

}  // namespace impetus::inline viewers
