// One field of a form: a number, a choice in a row, or a text that wraps.
// SPDX-License-Identifier: MIT
#pragma once

#include <SDL.h>

#include <optional>
#include <string>

#include "experiments/record/page.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline window {

/// How the mouse moved the focus while a field was drawn.
enum class FocusChange { kNone, kGained, kLost };

/// The field, what is entered in it, and what is wrong with that.
class FormField {
 public:
  /// `language`: of what is said when an answer is not acceptable.
  explicit FormField(Field field, Language language = {})
      : field_(std::move(field)), language_(std::move(language)) {}

  /// Draws label, entry and message at the cursor. `take_keyboard` puts the text cursor into it.
  FocusChange draw(int id, const Gui& gui, std::size_t reading_size, float width_px, bool focused,
                   bool take_keyboard);

  /// Arrows and space move through the options of a choice. Returns whether the key was used.
  bool press(SDL_Keycode key);

  /// Whether letters and digits go into it while it has the focus.
  [[nodiscard]] bool takes_text() const { return field_.kind != Field::Kind::kChoice; }

  /// Whether the answer is acceptable; empty always is. If not, a message appears with the field.
  bool check();

  [[nodiscard]] std::string answer() const;
  void set_answer(const std::string& text) { text_ = text; }

 private:
  void draw_message(ImFont* font) const;
  FocusChange draw_entry(float width_px, bool focused, bool take_keyboard);
  FocusChange draw_options(float width_px, bool focused);

  Field field_;
  Language language_;
  std::string text_;
  std::optional<std::size_t> option_;
  std::string message_;
  bool was_active_{false};
};

}  // namespace impetus::inline window
