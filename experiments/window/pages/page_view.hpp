// A page on show: what has been filled in, where the focus is, and what a key does.
//
//   stops   field 0, field 1, ..., choice 0, choice 1, ...      Tab goes on, Shift-Tab back
//
// Keys, in this order: Enter on a focused button; arrows and space in a focused row of options; a
// choice's own key (letters, digits and space only while no text is being entered); Tab.
// SPDX-License-Identifier: MIT
#pragma once

#include <SDL.h>

#include <optional>
#include <string>
#include <vector>

#include "experiments/record/page.hpp"
#include "experiments/window/gui.hpp"
#include "experiments/window/pages/form_field.hpp"

namespace impetus::inline window {

class PageView {
 public:
  /// Both must outlive the view. Chooses the largest reading size at which the page fits; what
  /// does not fit even at the smallest is scrolled.
  PageView(const Page& page, Gui& gui);

  /// Lays out and draws the page within the present frame. Returns the choice that was clicked.
  std::optional<std::size_t> draw();

  /// What a key press does; returns the choice that it makes.
  std::optional<std::size_t> press(const SDL_Keysym& key);

  /// Moves a page that is longer than the window; `pages` > 0 goes down.
  void scroll(float pages);

  /// Whether the page may be left by this choice; otherwise the fields say what they expect. What
  /// was typed just before has reached the fields.
  bool may_leave_by(std::size_t choice);

  /// One answer per field.
  [[nodiscard]] std::vector<std::string> answers() const;

  /// Draws a choice as chosen.
  void mark_chosen(std::size_t choice) { chosen_ = choice; }

  /// Of a page with a time limit: the share that is left, drawn as a thin bar.
  void tell_time_left(double share) { time_left_ = share; }

 private:
  float measure();
  void settle();
  void draw_fields();
  void draw_time_left() const;
  void draw_scroll_hint() const;
  void move_focus(bool back);
  void focus_on(std::optional<std::size_t> stop);
  [[nodiscard]] std::optional<std::size_t> focused_choice() const;
  [[nodiscard]] std::optional<std::size_t> choice_with_key(const SDL_Keysym& key) const;
  [[nodiscard]] bool text_is_entered() const;
  [[nodiscard]] float visible_height() const;
  [[nodiscard]] float longest_scroll() const;

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
};

}  // namespace impetus::inline window
