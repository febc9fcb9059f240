// SPDX-License-Identifier: MIT
#include "experiments/window/pages/asked_page.hpp"

#include "experiments/window/pages/page_view.hpp"

namespace impetus::inline window {
namespace {

/// The page before somebody: its frames, and the events that answer it.
class PageTurn {
 public:
  PageTurn(Canvas& canvas, const Page& page)
      : canvas_(canvas), page_(page), view_(page, canvas.gui) {}

  Answer ask() {
    show_first();
    if (page_.can_pause && canvas_.events.take_pause_request()) {
      answer_.interruption = Interruption::kPauseRequested;
      return answer_;
    }
    while (!canvas_.events.closed()) {
      if (take_events() || take_click(draw_and_flip()) || time_is_up()) {
        static_cast<void>(canvas_.events.take_pause_request());
        answer_.fields = view_.answers();
        return answer_;
      }
    }
    answer_.interruption = Interruption::kDisplayClosed;
    return answer_;
  }

  void show_for(double seconds, std::optional<std::size_t> choice) {
    constexpr double kSeenUnanswered = 0.66;
    show_first();
    const double shown_ms = seconds * 1e3;
    while (elapsed_ms() < shown_ms && !canvas_.events.closed() &&
           !canvas_.events.pause_requested()) {
      if (choice && elapsed_ms() >= kSeenUnanswered * shown_ms) {
        view_.mark_chosen(*choice);
      }
      static_cast<void>(draw_and_flip());
      canvas_.events.discard();
    }
  }

 private:
  void show_first() {
    canvas_.window.show_cursor(true);
    canvas_.deadlines.restart();
    static_cast<void>(draw_and_flip());
    answer_.shown_ns = last_flip_ns_;
    canvas_.events.discard();
  }

  [[nodiscard]] double elapsed_ms() const {
    return static_cast<double>(last_flip_ns_ - answer_.shown_ns) / 1e6;
  }

  /// What was pressed while the last frame was waited for still counts.
  bool time_is_up() {
    if (page_.timeout_ms <= 0.0 || elapsed_ms() < page_.timeout_ms) {
      return false;
    }
    if (!take_events()) {
      answer_.timed_out = true;
      answer_.device = "none";
      answer_.arrived_ns = last_flip_ns_;
    }
    return true;
  }

  /// Returns true when an event has answered or interrupted the page.
  bool take_events() {
    for (const StampedEvent& event : canvas_.events.take()) {
      if (event.event.type == SDL_KEYDOWN && event.event.key.repeat == 0 && take_key(event)) {
        return true;
      }
      if (event.event.type == SDL_MOUSEWHEEL) {
        view_.scroll(-0.15F * static_cast<float>(event.event.wheel.y));
      }
      note_mouse(event);
      canvas_.gui.feed(event.event);
    }
    return false;
  }

  bool take_key(const StampedEvent& event) {
    const SDL_Keysym& key = event.event.key.keysym;
    if (const auto choice = view_.press(key)) {
      return answer_with(*choice, "key", event);
    }
    if (key.sym == SDLK_ESCAPE && page_.can_pause) {
      answer_.interruption = Interruption::kPauseRequested;
      note_arrival("key", event);
      return true;
    }
    return false;
  }

  void note_mouse(const StampedEvent& event) {
    if (event.event.button.button != SDL_BUTTON_LEFT) {
      return;
    }
    if (event.event.type == SDL_MOUSEBUTTONDOWN) {
      pressed_here_ = true;
    } else if (event.event.type == SDL_MOUSEBUTTONUP) {
      released_ = event;
    }
  }

  bool take_click(std::optional<std::size_t> clicked) {
    return clicked && pressed_here_ && answer_with(*clicked, "mouse", released_);
  }

  bool answer_with(std::size_t choice, const char* device, const StampedEvent& event) {
    if (!view_.may_leave_by(choice)) {
      return false;
    }
    answer_.choice = choice;
    note_arrival(device, event);
    return true;
  }

  void note_arrival(const char* device, const StampedEvent& event) {
    answer_.device = device;
    answer_.arrived_ns = event.arrived_ns;
    answer_.arrival_uncertainty_ns = event.uncertainty_ns;
  }

  std::optional<std::size_t> draw_and_flip() {
    canvas_.fill_page(page_.progress.light_ground);
    canvas_.gui.begin();
    if (page_.timeout_ms > 0.0 && answer_.shown_ns > 0) {
      view_.tell_time_left(1.0 - elapsed_ms() / page_.timeout_ms);
    }
    const auto clicked = view_.draw();
    canvas_.gui.end();
    canvas_.paint_patch(kDarkPatch);
    const Flip flip = canvas_.deadlines.flip();
    view_.note_shown();
    last_flip_ns_ = flip.flipped_ns;
    answer_.late_frames += flip.late() ? 1 : 0;
    return clicked;
  }

  Canvas& canvas_;
  const Page& page_;
  PageView view_;
  Answer answer_;
  std::int64_t last_flip_ns_{0};
  bool pressed_here_{false};  ///< the mouse button went down on this page
  StampedEvent released_;     ///< the last release of the mouse button
};

}  // namespace

Answer ask_page(Canvas& canvas, const Page& page) { return PageTurn(canvas, page).ask(); }

void show_page_for(Canvas& canvas, const Page& page, double seconds,
                   std::optional<std::size_t> choice) {
  PageTurn(canvas, page).show_for(seconds, choice);
}

}  // namespace impetus::inline window
