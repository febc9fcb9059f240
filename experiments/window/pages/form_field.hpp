// One field of a form: a number, a choice in a row, a text that wraps, or a mark on a line.
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
  explicit FormField(Field field, Language language = {});

  /// Draws label, entry and message at the cursor. `take_keyboard` puts the text cursor into it.
  FocusChange draw(int id, const Gui& gui, std::size_t reading_size, float width_px, bool focused,
                   bool take_keyboard);

  /// Arrows and space move through the options of a choice; arrows move a mark, up and down by a
  /// tenth of the line. Returns whether the key was used.
  bool press(SDL_Keycode key);

  /// Whether letters and digits go into it while it has the focus.
  [[nodiscard]] bool takes_text() const {
    return field_.kind == Field::Kind::kNumber || field_.kind == Field::Kind::kText;
  }

  /// Whether the answer is acceptable; empty always is but of a line. If not, a message appears
  /// with the field.
  bool check();

  /// The same where a message appeared, which goes once the answer is acceptable.
  void check_again() {
    if (!message_.empty()) {
      static_cast<void>(check());
    }
  }

  [[nodiscard]] std::string answer() const;

 private:
  void draw_message(ImFont* font) const;
  FocusChange draw_entry(float width_px, bool focused, bool take_keyboard);
  FocusChange draw_options(float width_px, bool focused);
  FocusChange draw_slider(ImFont* font, float width_px, bool focused);
  bool press_option(SDL_Keycode key);
  bool press_mark(SDL_Keycode key);

  Field field_;
  Language language_;
  std::string text_;
  std::optional<std::size_t> option_;
  std::optional<double> mark_;  ///< a whole number of the line
  std::string message_;
  bool was_active_{false};
};

}  // namespace impetus::inline window
