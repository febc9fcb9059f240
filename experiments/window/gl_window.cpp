// SPDX-License-Identifier: MIT
#include "experiments/window/gl_window.hpp"

#include <epoxy/gl.h>

#include "experiments/tables/number_text.hpp"
#include "experiments/window/display.hpp"

namespace impetus::inline window {
namespace {

constexpr double kAssumedRefreshHz = 60.0;
constexpr int kOpenGl33 = 33;

void ask_for_context() {
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
}

// Of the display's own size from the start: where no window manager runs, nobody would enlarge it.
SDL_Window* create_fullscreen(const WindowOptions& options) {
  SDL_Rect all{0, 0, options.width_px, options.height_px};
  SDL_GetDisplayBounds(0, &all);
  return SDL_CreateWindow(options.title.c_str(), all.x, all.y, all.w, all.h,
                          SDL_WINDOW_OPENGL | SDL_WINDOW_FULLSCREEN_DESKTOP);
}

const char* text_of(GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); }

}  // namespace

GlWindow::GlWindow(const WindowOptions& options) {
  SDL_SetHint(SDL_HINT_VIDEO_MINIMIZE_ON_FOCUS_LOSS, "0");
  SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");
  options.seen ? open_video() : open_unseen_video();
  try {
    open(options);
  } catch (...) {
    close();
    throw;
  }
}

GlWindow::~GlWindow() { close(); }

void GlWindow::open(const WindowOptions& options) {
  ask_for_context();
  const Uint32 flags = SDL_WINDOW_OPENGL | (options.seen ? 0U : Uint32{SDL_WINDOW_HIDDEN});
  window_ = options.fullscreen ? create_fullscreen(options)
                               : SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED,
                                                  SDL_WINDOWPOS_CENTERED, options.width_px,
                                                  options.height_px, flags);
  if (window_ == nullptr) {
    refuse_display(SDL_GetError());
  }
  context_ = SDL_GL_CreateContext(window_);
  if (context_ == nullptr) {
    refuse_display(std::string("OpenGL 3.3 is needed: ") + SDL_GetError());
  }
  if (epoxy_gl_version() < kOpenGl33) {
    refuse_display(std::string("OpenGL 3.3 is needed, this is ") + text_of(GL_VERSION));
  }
  survive_display_loss(window_);
  SDL_GL_GetDrawableSize(window_, &width_px_, &height_px_);
  decide_refresh(options.refresh_hz);
  description_ = described();
}

void GlWindow::close() {
  if (context_ != nullptr) {
    SDL_GL_DeleteContext(context_);
  }
  if (window_ != nullptr) {
    SDL_DestroyWindow(window_);
  }
  SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

void GlWindow::decide_refresh(double asked_hz) {
  SDL_DisplayMode mode{};
  const bool known = SDL_GetCurrentDisplayMode(SDL_GetWindowDisplayIndex(window_), &mode) == 0 &&
                     mode.refresh_rate > 0;
  if (asked_hz > 0.0) {
    refresh_hz_ = asked_hz;
    refresh_source_ = "as given";
  } else if (known) {
    refresh_hz_ = mode.refresh_rate;
    refresh_source_ = "reported by the display";
  } else {
    refresh_hz_ = kAssumedRefreshHz;
    refresh_source_ = "assumed";
  }
}

void GlWindow::swap() {
  SDL_GL_SwapWindow(window_);
  // Drivers queue a swap and return; one pixel drawn behind it makes them wait for it.
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  glFinish();
}

bool GlWindow::wait_for_refresh(bool wait) { return SDL_GL_SetSwapInterval(wait ? 1 : 0) == 0; }

void GlWindow::show_cursor(bool visible) { SDL_ShowCursor(visible ? SDL_ENABLE : SDL_DISABLE); }

std::string GlWindow::described() const {
  return printed("%s, %s, OpenGL %s, %d × %d px, %.2f Hz (%s)", SDL_GetCurrentVideoDriver(),
                 text_of(GL_RENDERER), text_of(GL_VERSION), width_px_, height_px_, refresh_hz_,
                 refresh_source_.c_str());
}

}  // namespace impetus::inline window
