// SPDX-License-Identifier: MIT
#include "experiments/window/pages/asked_page.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "experiments/window/pages/form_field.hpp"
#include "experiments/window/pages/page_layout.hpp"
#include "experiments/window/pages/widgets.hpp"
#include "experiments/window/typed_input.hpp"

namespace impetus::inline window {
namespace {

constexpr float kMarginShare = 0.05F;    // of the window's height, above and below
constexpr float kOpticalCentre = 0.44F;  // a block looks centred a little above the middle
constexpr float kScrollStep = 0.8F;      // of what is visible

/// A page on show: what has been filled in, where the focus is, and what a key does.
class PageView {
 public:
  /// Both must outlive the view.
  PageView(const Page& page, Gui& gui) : page_(page), gui_(gui) {
    for (const Field& field : page.fields) {
      fields_.emplace_back(field, page.progress.language);
    }
    gui_.forget_input();
    while (measure() > visible_height() && reading_size_ + 1 < kReadingSizes) {
      ++reading_size_;
    }
    if (!fields_.empty()) {
      focus_on(0);
    }
  }

  /// Lays out and draws the page within the present frame. Returns the choice that was clicked.
  std::optional<std::size_t> draw() {
    const float margin = std::round(kMarginShare * gui_.height());
    const float spare = std::max(0.0F, visible_height() - content_px_);
    const float top = std::round(margin + kOpticalCentre * spare - scroll_px_);
    const Column column = reading_column(gui_);
    ImGui::PushFont(gui_.fonts().body[reading_size_]);
    ImGui::SetCursorScreenPos(ImVec2(column.left, top));
    draw_words(gui_, page_, reading_size_);
    draw_point_map(gui_, page_.point_map, page_.progress.language);
    draw_fields(column);
    const auto clicked = draw_choices(gui_, page_, {focused_choice(), chosen_});
    draw_time_left(column);
    content_px_ = ImGui::GetCursorScreenPos().y - top;
    ImGui::PopFont();
    draw_reading_hint();
    draw_progress(gui_, page_.progress, Ground::kPage);
    return clicked;
  }

  /// What a key press does; returns the choice that it makes.
  std::optional<std::size_t> press(const SDL_Keysym& key) {
    if (is_key(key, "enter") && (key.mod & KMOD_CTRL) == 0) {
      if (focused_choice()) {
        return focused_choice();
      }
      if (focus_ && *focus_ + 1 < fields_.size()) {
        leave_field();
        return std::nullopt;
      }
    }
    if (focused_field() != nullptr && focused_field()->press(key.sym)) {
      return std::nullopt;
    }
    if (const auto choice = choice_with_key(key)) {
      return choice;
    }
    if (key.sym == SDLK_TAB) {
      move_focus((key.mod & KMOD_SHIFT) != 0);
    } else if (key.sym == SDLK_PAGEDOWN || key.sym == SDLK_PAGEUP) {
      scroll(key.sym == SDLK_PAGEDOWN ? 1.0F : -1.0F);
    } else if (key.sym == SDLK_SPACE && focused_choice()) {
      return focused_choice();
    } else if (!text_is_entered() && (key.sym == SDLK_LEFT || key.sym == SDLK_RIGHT)) {
      move_focus(key.sym == SDLK_LEFT);
    }
    return std::nullopt;
  }

  /// Moves a page that is longer than the window; `pages` > 0 goes down.
  void scroll(float pages) {
    const float wanted = scroll_px_ + pages * kScrollStep * visible_height();
    scroll_px_ = std::round(std::clamp(wanted, 0.0F, longest_scroll()));
  }

  /// Whether the page may be left by this choice; otherwise the fields say what they expect, or the
  /// hint that the page is to be read first.
  bool may_leave_by(std::size_t choice) {
    if (page_.choice_at_end == choice && !end_was_seen_) {
      was_hasty_ = true;
      return false;
    }
    take_what_was_typed();
    if (page_.choices[choice].key == "escape") {
      return true;
    }
    std::optional<std::size_t> first_refused;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      if (!fields_[i].check() && !first_refused) {
        first_refused = i;
      }
    }
    if (first_refused) {
      focus_on(first_refused);
    }
    return !first_refused;
  }

  /// One answer per field.
  [[nodiscard]] std::vector<std::string> answers() const {
    std::vector<std::string> answers;
    for (const FormField& field : fields_) {
      answers.push_back(field.answer());
    }
    return answers;
  }

  /// What was drawn last is on the screen.
  void note_shown() { end_was_seen_ = end_was_seen_ || scroll_px_ + 1.0F >= longest_scroll(); }

  /// Draws a choice as chosen.
  void mark_chosen(std::size_t choice) { chosen_ = choice; }

  /// Of a page with a time limit: the share that is left, drawn as a thin bar.
  void tell_time_left(double share) { time_left_ = share; }

 private:
  /// Lays the page out without showing it; its height.
  float measure() {
    gui_.begin();
    draw();
    gui_.discard();
    return content_px_;
  }

  /// What was typed just before has reached the fields.
  void take_what_was_typed() {
    do {
      measure();
    } while (gui_.input_waits());
  }

  /// To the next field, once this one is filled in as it expects.
  void leave_field() {
    take_what_was_typed();
    focus_on(*focus_ + (fields_[*focus_].check() ? 1 : 0));
  }

  void draw_fields(const Column& column) {
    if (focus_moved_) {
      ImGui::ClearActiveID();
    }
    const auto focus = focus_;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImGui::SetCursorScreenPos(ImVec2(column.left, at.y + std::round(0.5F * part_gap())));
      const bool focused = focus == i;
      const int id = static_cast<int>(page_.choices.size() + i);
      const FocusChange change =
          fields_[i].draw(id, gui_, reading_size_, column.width, focused, focused && focus_moved_);
      if (change == FocusChange::kGained) {
        focus_ = i;
      } else if (change == FocusChange::kLost && focus_ == i) {
        focus_.reset();
      }
    }
    focus_moved_ = false;
  }

  /// Shrinks towards the middle, where the eyes are.
  void draw_time_left(const Column& column) const {
    if (page_.timeout_ms <= 0.0) {
      return;
    }
    const float height = std::max(3.0F, std::round(0.12F * ImGui::GetFontSize()));
    const float top = ImGui::GetCursorScreenPos().y + std::round(1.5F * part_gap());
    const float left_px = column.width * static_cast<float>(std::clamp(time_left_, 0.0, 1.0));
    const float middle = column.left + 0.5F * column.width;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(ImVec2(column.left, top), ImVec2(column.left + column.width, top + height),
                       palette::kSurface);
    draw.AddRectFilled(ImVec2(middle - 0.5F * left_px, top),
                       ImVec2(middle + 0.5F * left_px, top + height), palette::kLine);
    ImGui::SetCursorScreenPos(ImVec2(column.left, top + height));
  }

  /// How to read on, where a page is longer than the window; until its end was seen, why it cannot
  /// be agreed to yet.
  void draw_reading_hint() const {
    if (longest_scroll() <= 0.0F) {
      return;
    }
    const float bottom = gui_.height() - progress_height(gui_);
    const float height = 2.0F * gui_.fonts().small->FontSize;
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(0, bottom - height),
                                              ImVec2(gui_.width(), gui_.height()), palette::kPage);
    ImGui::SetCursorScreenPos(ImVec2(0, bottom - 0.7F * height));
    const Language& language = page_.progress.language;
    const bool waits = page_.choice_at_end && !end_was_seen_;
    draw_text(waits ? language.text("read_to_end") : language.text("scroll_hint"),
              gui_.fonts().small, waits && was_hasty_ ? palette::kWarning : palette::kQuietText,
              gui_.width(), Align::kCentre);
  }

  [[nodiscard]] float visible_height() const {
    return gui_.height() - 2.0F * std::round(kMarginShare * gui_.height()) - progress_height(gui_);
  }

  [[nodiscard]] float longest_scroll() const {
    return std::max(0.0F, content_px_ - visible_height());
  }

  [[nodiscard]] std::optional<std::size_t> choice_with_key(const SDL_Keysym& key) {
    for (std::size_t choice = 0; choice < page_.choices.size(); ++choice) {
      const std::string& name = page_.choices[choice].key;
      const bool typed = name.size() == 1 || name == "space";
      if (is_key(key, name) && !(typed && text_is_entered())) {
        return choice;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] FormField* focused_field() {
    return focus_ && *focus_ < fields_.size() ? &fields_[*focus_] : nullptr;
  }

  [[nodiscard]] bool text_is_entered() {
    return focused_field() != nullptr && focused_field()->takes_text();
  }

  [[nodiscard]] std::optional<std::size_t> focused_choice() const {
    return focus_ && *focus_ >= fields_.size() ? std::optional(*focus_ - fields_.size())
                                               : std::nullopt;
  }

  void move_focus(bool back) {
    const std::size_t stops = fields_.size() + page_.choices.size();
    if (stops > 0) {
      const std::size_t from = focus_.value_or(back ? 0 : stops - 1);
      focus_on((from + (back ? stops - 1 : 1)) % stops);
    }
  }

  void focus_on(std::optional<std::size_t> stop) {
    focus_ = stop;
    focus_moved_ = true;
  }

  const Page& page_;
  Gui& gui_;
  std::vector<FormField> fields_;
  std::optional<std::size_t> focus_;
  bool focus_moved_{false};
  std::optional<std::size_t> chosen_;
  double time_left_{1.0};
  std::size_t reading_size_{0};
  float content_px_{0.0F};
  float scroll_px_{0.0F};
  bool end_was_seen_{false};
  bool was_hasty_{false};  ///< a choice that needs the end was tried before
};

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
    canvas_.fill_page();
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
