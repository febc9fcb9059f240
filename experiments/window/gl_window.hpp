// One SDL window with an OpenGL 3.3 core context, opened and closed.
// SPDX-License-Identifier: MIT
#pragma once

#include <SDL.h>

#include <string>

#include "experiments/window/window.hpp"

namespace impetus::inline window {

/// The window and its context.
class GlWindow {
 public:
  /// Throws std::runtime_error with one sentence when no display or no OpenGL 3.3 can be had.
  explicit GlWindow(const WindowOptions& options);
  ~GlWindow();
  GlWindow(const GlWindow&) = delete;
  GlWindow& operator=(const GlWindow&) = delete;

  /// Hands the frame to the display and waits until the driver says that it is done.
  void swap();

  /// Whether swap() is asked to wait for the refresh; false when the driver refuses.
  bool wait_for_refresh(bool wait);

  void show_cursor(bool visible);

  [[nodiscard]] SDL_Window* handle() const { return window_; }
  [[nodiscard]] SDL_GLContext context() const { return context_; }
  [[nodiscard]] int width_px() const { return width_px_; }
  [[nodiscard]] int height_px() const { return height_px_; }
  [[nodiscard]] double refresh_hz() const { return refresh_hz_; }

  /// "x11, llvmpipe ..., 1280 × 1024 px, 60.00 Hz (reported by the display)".
  [[nodiscard]] const std::string& description() const { return description_; }

 private:
  void open(const WindowOptions& options);
  void close();
  void decide_refresh(double asked_hz);
  [[nodiscard]] std::string described() const;

  SDL_Window* window_{nullptr};
  SDL_GLContext context_{nullptr};
  int width_px_{0};
  int height_px_{0};
  double refresh_hz_{60.0};
  std::string refresh_source_;
  std::string description_;
};

}  // namespace impetus::inline window
