// SPDX-License-Identifier: MIT
#include "experiments/window/shown_patch.hpp"

#include "experiments/window/canvas.hpp"
#include "experiments/window/display_loss.hpp"

#ifdef IMPETUS_HAS_X11
#include <SDL_syswm.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <bit>
#include <memory>
#endif

namespace impetus::inline window {

#ifdef IMPETUS_HAS_X11
namespace {

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

/// While it lives, a refused request is none of our business: the window may lie off the screen.
class RefusalsForgiven {
 public:
  RefusalsForgiven()
      : before_(
            XSetErrorHandler([](::Display* /*connection*/, XErrorEvent* /*error*/) { return 0; })) {
  }
  ~RefusalsForgiven() { XSetErrorHandler(before_); }
  RefusalsForgiven(const RefusalsForgiven&) = delete;
  RefusalsForgiven& operator=(const RefusalsForgiven&) = delete;

 private:
  XErrorHandler before_;
};

struct DestroyImage {
  void operator()(XImage* image) const { XDestroyImage(image); }
};
using Image = std::unique_ptr<XImage, DestroyImage>;

/// The row of pixels through the middle of the area; null when it was refused.
Image middle_row(const XWindow& window, const PixelArea& area, int height_px) {
  const RefusalsForgiven forgiven;
  const int from_top = height_px - 1 - (area.bottom + area.height / 2);
  return Image(XGetImage(window.connection, window.id, area.left, from_top,
                         static_cast<unsigned>(area.width), 1, AllPlanes, ZPixmap));
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
    const PixelArea area = window.canvas().patch.area().value();
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
