// One page, from the flip that first shows it to its answer.
//
//   first flip ─> forget what was pressed before ─> events, frame, flip ─> ... ─> answer
//
// A press counts only when it was taken after the page was on the glass, so an impatient key
// cannot answer a question that has not been seen.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "experiments/record/ports.hpp"
#include "experiments/window/canvas.hpp"
#include "experiments/window/pages/page_view.hpp"

namespace impetus::inline window {

class PageTurn {
 public:
  /// Both must outlive the turn.
  PageTurn(Canvas& canvas, const Page& page);

  Answer ask();

  /// Shows the page for this long; `choice` is drawn as chosen in the last third, if there is one.
  void show_for(double seconds, std::optional<std::size_t> choice);

 private:
  void show_first();
  [[nodiscard]] double elapsed_ms() const;
  bool time_is_up();
  bool take_events();
  bool take_key(const StampedEvent& event);
  void note_mouse(const StampedEvent& event);
  bool take_click(std::optional<std::size_t> clicked);
  bool answer_with(std::size_t choice, const char* device, const StampedEvent& event);
  std::optional<std::size_t> draw_and_flip();

  Canvas& canvas_;
  const Page& page_;
  PageView view_;
  Answer answer_;
  std::int64_t last_flip_ns_{0};
  bool pressed_here_{false};  ///< the mouse button went down on this page
  StampedEvent released_;     ///< the last release of the mouse button
};

}  // namespace impetus::inline window
