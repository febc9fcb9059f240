// SPDX-License-Identifier: MIT
#include "experiments/window/shown_patch.hpp"

#ifdef IMPETUS_HAS_X11
#include <SDL_syswm.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#endif

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "experiments/window/canvas.hpp"
#include "experiments/window/display.hpp"

namespace impetus::inline window {

PixelArea patch_area(ScreenCorner corner, const ScreenGeometry& screen, int width_px,
                     int height_px) {
  const auto pixels = [](double side_m, int all_px) {
    return std::clamp(static_cast<int>(std::lround(kPatchSide_m / side_m * all_px)), 1, all_px);
  };
  PixelArea area{0, 0, pixels(screen.width_m, width_px), pixels(screen.height_m, height_px)};
  if (corner == ScreenCorner::kTopRight || corner == ScreenCorner::kBottomRight) {
    area.left = width_px - area.width;
  }
  if (corner == ScreenCorner::kTopLeft || corner == ScreenCorner::kTopRight) {
    area.bottom = height_px - area.height;
  }
  return area;
}

std::optional<std::int64_t> code_of_pixel(int red, int green, int blue) {
  constexpr int kTolerance = 8;  // dithering and colour depths of 5 or 6 bits change a grey by less
  for (std::int64_t code = 0; code < kPatchCodes; ++code) {
    const int grey = static_cast<int>(std::lround(255.0F * patch_grey(code)));
    if (std::max({std::abs(red - grey), std::abs(green - grey), std::abs(blue - grey)}) <=
        kTolerance) {
      return code;
    }
  }
  return std::nullopt;
}

#ifdef IMPETUS_HAS_X11
namespace {

/// The window in X11's names.
struct XWindow {
  ::Display* connection{nullptr};
  ::Window id{0};
};

/// None: the window is not X11's.
std::optional<XWindow> x_window(Window& window) {
  SDL_SysWMinfo system;
  SDL_VERSION(&system.version);
  const bool known = SDL_GetWindowWMInfo(window.canvas().window.handle(), &system) == SDL_TRUE;
  if (!known || system.subsystem != SDL_SYSWM_X11 || display_lost()) {
    return std::nullopt;
  }
  return XWindow{system.info.x11.display, system.info.x11.window};
}

using Image = std::unique_ptr<XImage, decltype([](XImage* image) { XDestroyImage(image); })>;

/// The row of pixels through the middle of the area; null when it was refused, which is none of our
/// business here: the window may lie off the screen.
Image middle_row(const XWindow& window, const PixelArea& area, int height_px) {
  const auto handler_before =
      XSetErrorHandler([](::Display* /*connection*/, XErrorEvent* /*error*/) { return 0; });
  const int from_top = height_px - 1 - (area.bottom + area.height / 2);
  Image row(XGetImage(window.connection, window.id, area.left, from_top,
                      static_cast<unsigned>(area.width), 1, AllPlanes, ZPixmap));
  XSetErrorHandler(handler_before);
  return row;
}

/// One colour of a pixel, 0–255.
int channel(unsigned long pixel, unsigned long mask) {
  const unsigned long most = mask >> std::countr_zero(mask);
  return most == 0 ? 0
                   : static_cast<int>(((pixel & mask) >> std::countr_zero(mask)) * 255UL / most);
}

std::optional<std::int64_t> code_at(XImage& row, int x) {
  const unsigned long pixel = XGetPixel(&row, x, 0);
  return code_of_pixel(channel(pixel, row.red_mask), channel(pixel, row.green_mask),
                       channel(pixel, row.blue_mask));
}

}  // namespace

bool can_read_shown_patch(Window& window) { return x_window(window).has_value(); }

std::optional<std::int64_t> shown_patch(Window& window) {
  std::optional<std::int64_t> code;
  while_display_lasts([&] {
    const auto at = x_window(window);
    const PixelArea area = window.canvas().patch.value();
    const Image row = at ? middle_row(*at, area, window.height_px()) : nullptr;
    if (row) {
      code = code_at(*row, area.width / 4);
      for (const int x : {area.width / 2, 3 * area.width / 4}) {
        code = code_at(*row, x) == code ? code : std::nullopt;
      }
    }
  });
  return code;
}

std::string compositor_of(Window& window) {
  std::string answer = "not known";
  while_display_lasts([&] {
    if (const auto at = x_window(window)) {
      const std::string name = "_NET_WM_CM_S" + std::to_string(DefaultScreen(at->connection));
      const Atom atom = XInternAtom(at->connection, name.c_str(), False);
      answer = XGetSelectionOwner(at->connection, atom) == 0 ? "none" : "running";
    }
  });
  return answer;
}

#else

bool can_read_shown_patch(Window& /*window*/) { return false; }
std::optional<std::int64_t> shown_patch(Window& /*window*/) { return std::nullopt; }
std::string compositor_of(Window& /*window*/) { return "not known"; }

#endif

}  // namespace impetus::inline window
