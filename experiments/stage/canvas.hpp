// What the window is made of, for the screens of this room alone.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/stage/event_pump.hpp"
#include "experiments/stage/flip_pacer.hpp"
#include "experiments/stage/gl_window.hpp"
#include "experiments/stage/gui.hpp"
#include "experiments/stage/mouse_input.hpp"
#include "experiments/stage/patch_painter.hpp"
#include "experiments/stage/scene_painter.hpp"

namespace impetus {

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

}  // namespace impetus
