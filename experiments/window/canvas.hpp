// What the window is made of, for the screens of this room alone.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/drawing/patch_painter.hpp"
#include "experiments/drawing/scene_painter.hpp"
#include "experiments/window/event_pump.hpp"
#include "experiments/window/flip_pacer.hpp"
#include "experiments/window/gl_window.hpp"
#include "experiments/window/gui.hpp"
#include "experiments/window/mouse_input.hpp"

namespace impetus::inline window {

struct Canvas {
  Canvas(const WindowOptions& options, const Clock& clock)
      : window(options), events(clock), pacer(window, events, clock), gui(window), mouse(clock) {}

  [[nodiscard]] PixelArea whole() const { return {0, 0, window.width_px(), window.height_px()}; }

  GlWindow window;
  EventPump events;
  FlipPacer pacer;
  Gui gui;
  ScenePainter painter;
  MouseInput mouse;
  PatchPainter patch;
};

}  // namespace impetus::inline window
