// Dear ImGui for this room: one style, one set of fonts, and who may see which event.
//
// ImGui lays out, draws, edits text and follows the mouse. Keys that move the focus or answer a
// page are ours (page_view), taken from the stamped events, so ImGui never sees them.
// SPDX-License-Identifier: MIT
#pragma once

#include <SDL.h>
#include <imgui.h>
#include <imgui_internal.h>  // the arithmetic of ImVec2, see window.cmake

#include <array>
#include <cstdint>
#include <deque>
#include <set>

#include "experiments/window/gl_window.hpp"

namespace impetus::inline window {

/// Text sizes: reading is tried at full size first, then closer, when a page is long.
inline constexpr int kReadingSizes = 3;

/// The letters of every size.
struct Fonts {
  std::array<ImFont*, kReadingSizes> body{};
  std::array<ImFont*, kReadingSizes> title{};
  ImFont* small{nullptr};
};

/// ImGui in this window.
class Gui {
 public:
  /// One per process at a time. `window` must outlive it. `letters` are those beyond
  /// kShownLetters that will be shown.
  explicit Gui(GlWindow& window, const std::set<std::uint16_t>& letters = {});
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// Hands over an event that text fields or buttons may need.
  void feed(const SDL_Event& event);

  /// Whether handed-over events still wait for the next frame.
  [[nodiscard]] bool input_waits() const { return !waiting_.empty(); }

  /// Forgets keys and letters on their way, and where the pointer rests, so that a new screen
  /// starts clean: nothing is under the pointer until it moves or clicks.
  void forget_input();

  /// Starts a frame: one window without decoration that covers the display.
  void begin();
  /// Draws the frame on what was painted.
  void end();
  /// Ends the frame without drawing it: what it laid out was only measured.
  void discard();

  [[nodiscard]] const Fonts& fonts() const { return fonts_; }
  [[nodiscard]] float width() const { return static_cast<float>(window_.width_px()); }
  [[nodiscard]] float height() const { return static_cast<float>(window_.height_px()); }

 private:
  [[nodiscard]] float body_size() const;
  void load_fonts(const std::set<std::uint16_t>& letters);
  void pass_events();

  GlWindow& window_;
  ImVector<ImWchar> typed_ranges_;  ///< of wide letters; ImGui reads both when it builds the fonts
  ImVector<ImWchar> shown_ranges_;
  Fonts fonts_;
  std::deque<SDL_Event> waiting_;
  bool pointer_used_{false};  ///< moved or clicked since input was forgotten
};

}  // namespace impetus::inline window
