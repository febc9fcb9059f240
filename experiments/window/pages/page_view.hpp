// A page on show, without its frames: what has been filled in, where the focus is, how far it is
// scrolled, and what a key does. PageTurn in window.cpp puts it before somebody.
//
//   stops   field 0, field 1, ..., choice 0, choice 1, ...      Tab goes on, Shift-Tab back
//
// Keys, in this order: Enter on a focused button, or in a field that others follow, to which it
// goes on; arrows and space in a focused row of options; a choice's own key (letters, digits and
// space only while no text is being entered); Tab.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/record/page.hpp"
#include "experiments/window/gui.hpp"
#include "experiments/window/pages/form_field.hpp"
#include "experiments/window/pages/page_layout.hpp"
#include "experiments/window/typed_input.hpp"

namespace impetus::inline window {

/// A page on show: what has been filled in, where the focus is, and what a key does.
class PageView {
 public:
  /// Both must outlive the view.
  PageView(const Page& page, Gui& gui);

  /// Lays out and draws the page within the present frame. Returns the choice that was clicked.
  std::optional<std::size_t> draw();

  /// Takes what was typed and clicked since the page was drawn, without showing it. Returns the
  /// choice that was clicked.
  std::optional<std::size_t> take_input();

  /// What a key press does; returns the choice that it makes.
  std::optional<std::size_t> press(const SDL_Keysym& key);

  /// Moves a page that is longer than the window; `pages` > 0 goes down.
  void scroll(float pages);

  /// Whether the page may be left by this choice; otherwise the fields say what they expect, or the
  /// hint that the page is to be read first.
  bool may_leave_by(std::size_t choice);

  /// One answer per field.
  [[nodiscard]] std::vector<std::string> answers() const;

  /// What was drawn last is on the screen.
  void note_shown() { end_was_seen_ = end_was_seen_ || scroll_px_ + 1.0F >= longest_scroll(); }

  /// Draws a choice as chosen.
  void mark_chosen(std::size_t choice) { chosen_ = choice; }

  /// Of a page with a time limit: the share that is left, drawn as a thin bar.
  void tell_time_left(double share) { time_left_ = share; }

 private:
  /// Lays the page out without showing it; its height.
  float measure();

  /// To the next field, once this one is filled in as it expects.
  void leave_field();

  void draw_fields(const Column& column);

  /// Scrolls, before the next drawing, to what lies between these heights of this one.
  void scroll_to(float top, float bottom);

  /// Shrinks towards the middle, where the eyes are.
  void draw_time_left(const Column& column) const;

  /// How to read on, where a page is longer than the window; until its end was seen, why it cannot
  /// be agreed to yet.
  void draw_reading_hint() const;

  [[nodiscard]] float visible_height() const;
  [[nodiscard]] float longest_scroll() const;
  [[nodiscard]] std::optional<std::size_t> choice_with_key(const SDL_Keysym& key);
  [[nodiscard]] FormField* focused_field();
  [[nodiscard]] bool text_is_entered();
  [[nodiscard]] std::optional<std::size_t> focused_choice() const;
  void move_focus(bool back);
  /// Puts the focus there, and scrolls to it.
  void focus_on(std::optional<std::size_t> stop);

  const Page& page_;
  Gui& gui_;
  std::vector<FormField> fields_;
  std::optional<std::size_t> focus_;
  bool focus_moved_{false};
  bool seeks_focus_{false};  ///< it may be out of sight
  std::optional<std::size_t> chosen_;
  double time_left_{1.0};
  std::size_t reading_size_{0};
  float content_px_{0.0F};
  float scroll_px_{0.0F};
  bool end_was_seen_{false};
  bool was_hasty_{false};  ///< a choice that needs the end was tried before
};

}  // namespace impetus::inline window
