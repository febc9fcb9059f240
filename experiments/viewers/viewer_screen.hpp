// The loop of every screen that is a viewer's: the preview, a replay, a tree, the screen's set-up.
//
//   first frame ─> forget what was pressed before ─> events ─> paint ─> draw ─> flip ─┐
//                                                      ^──────────── go on ───────────┘
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/window/canvas.hpp"

namespace impetus::inline viewers {

/// A screen that is shown until it is left.
class ViewerScreen {
 public:
  ViewerScreen(const ViewerScreen&) = delete;
  ViewerScreen& operator=(const ViewerScreen&) = delete;
  virtual ~ViewerScreen() = default;

  /// Shows frames and takes events until it is left or the window is closed.
  void run();

 protected:
  explicit ViewerScreen(Canvas& canvas) : canvas_(canvas) {}

  void leave() { left_ = true; }

  /// An event, of which ImGui has been told.
  virtual void take(const SDL_Event& event) = 0;
  /// Paints on the page's ground, before ImGui's frame.
  virtual void paint() {}
  /// Draws within ImGui's frame.
  virtual void draw() = 0;
  /// The frame is drawn, but not yet flipped.
  virtual void end_frame() {}
  /// A frame has been shown, so long after the one before.
  virtual void go_on(double /*frame_s*/) {}

  Canvas& canvas_;

 private:
  std::int64_t draw_and_flip();

  bool left_{false};
};

}  // namespace impetus::inline viewers
