// SPDX-License-Identifier: MIT
#include "experiments/stage/replay_viewer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "experiments/stage/canvas.hpp"
#include "experiments/stage/colour_legend.hpp"
#include "experiments/stage/display_loss.hpp"
#include "experiments/stage/gaze_overlay.hpp"
#include "experiments/stage/palette.hpp"
#include "experiments/stage/replay_playback.hpp"
#include "experiments/stage/replay_timeline.hpp"
#include "experiments/stage/widgets.hpp"

namespace impetus {
namespace {

constexpr const char* kKeys =
    "Space play, pause  ·  ← → one step  ·  ↑ ↓ speed  ·  G gaze  ·  C colours  ·  "
    "Page Up, Page Down trial  ·  Esc close";

std::string facts_of(const ReplayView& replay) {
  std::string line;
  for (const std::string& fact : replay.facts) {
    line += (line.empty() ? "" : "  ·  ") + fact;
  }
  return line;
}

class ReplayScreen {
 public:
  ReplayScreen(Canvas& canvas, const ReplayView& replay)
      : canvas_(canvas), replay_(replay), playback_(replay) {}

  ViewerExit run() {
    canvas_.window.show_cursor(true);
    canvas_.gui.forget_input();
    canvas_.gui.begin();
    draw_header();
    canvas_.gui.discard();
    canvas_.pacer.restart();
    std::int64_t flipped_ns = draw_and_flip();
    canvas_.events.discard();
    while (!canvas_.events.closed()) {
      if (const auto exit = take_events()) {
        static_cast<void>(canvas_.events.take_pause_request());
        return *exit;
      }
      const std::int64_t now_ns = draw_and_flip();
      playback_.advance(static_cast<double>(now_ns - flipped_ns) / 1e9);
      flipped_ns = now_ns;
    }
    return ViewerExit::kClosed;
  }

 private:
  std::optional<ViewerExit> take_events() {
    for (const StampedEvent& event : canvas_.events.take()) {
      canvas_.gui.feed(event.event);
      if (event.event.type != SDL_KEYDOWN) {
        continue;
      }
      if (const auto exit = press(event.event.key.keysym.sym)) {
        return exit;
      }
    }
    return std::nullopt;
  }

  std::optional<ViewerExit> press(SDL_Keycode key) {
    switch (key) {
      case SDLK_ESCAPE:
        return ViewerExit::kClosed;
      case SDLK_PAGEUP:
        return ViewerExit::kPreviousTrial;
      case SDLK_PAGEDOWN:
        return ViewerExit::kNextTrial;
      case SDLK_SPACE:
        playback_.toggle();
        break;
      case SDLK_LEFT:
      case SDLK_RIGHT:
        playback_.step(key == SDLK_RIGHT ? 1 : -1);
        break;
      case SDLK_UP:
      case SDLK_DOWN:
        playback_.change_speed(key == SDLK_UP ? 1 : -1);
        break;
      case SDLK_g:
        gaze_shown_ = !gaze_shown_;
        break;
      case SDLK_c:
        colours_ = next_colours(colours_);
        break;
      default:
        break;
    }
    return std::nullopt;
  }

  std::int64_t draw_and_flip() {
    canvas_.painter.fill(canvas_.whole(), palette::kPageGrey);
    Picture picture;
    picture.bodies = playback_.bodies();
    colour_bodies(picture.bodies, playback_.details(), colours_, replay_.finest_level);
    picture.enclosure = replay_.enclosure;
    picture.viewer = viewer_now();
    canvas_.painter.paint(picture, picture_area());
    canvas_.gui.begin();
    if (gaze_shown_) {
      draw_gaze_over(picture_area());
    }
    draw_colour_legend(canvas_.gui, picture_area(), meanings_of(colours_, replay_.finest_level));
    draw_header();
    draw_footer();
    canvas_.gui.end();
    return canvas_.pacer.flip().flipped_ns;
  }

  [[nodiscard]] Viewer viewer_now() const {
    return turned_viewer(replay_.viewer, replay_.turn, playback_.time_s());
  }

  /// The present step's: what it was told of the gaze, and its region.
  void draw_gaze_over(const PixelArea& area) const {
    const PictureMap map(viewer_now(), area, canvas_.window.height_px());
    const GazeInput gaze = playback_.gaze();
    push_clip_rect(area, canvas_.gui.height());
    if (gaze.fixation) {
      draw_gaze(map, *gaze.fixation);
    }
    if (gaze.region) {
      draw_region(map, *gaze.region);
    }
    ImGui::PopClipRect();
  }

  void draw_header() {
    const Fonts& fonts = canvas_.gui.fonts();
    ImGui::SetCursorScreenPos(ImVec2(margin(), margin()));
    draw_text(replay_.title, fonts.title[2], palette::kText, text_width(), Align::kLeft);
    draw_text(facts_of(replay_), fonts.small, palette::kQuietText, text_width(), Align::kLeft);
    header_px_ = ImGui::GetCursorScreenPos().y + 0.5F * margin();
  }

  void draw_footer() {
    const Gui& gui = canvas_.gui;
    ImGui::SetCursorScreenPos(ImVec2(margin(), gui.height() - footer_height()));
    draw_state();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 origin(margin(), at.y + 0.5F * gui.fonts().small->FontSize);
    const auto sought = draw_timeline(
        gui, replay_.marks, {origin, text_width(), playback_.span_s(), playback_.time_s()});
    if (sought) {
      playback_.seek(*sought);
    }
    const float keys_top = gui.height() - margin() - gui.fonts().small->FontSize;
    ImGui::SetCursorScreenPos(ImVec2(margin(), keys_top));
    draw_text(kKeys, gui.fonts().small, palette::kQuietText, text_width(), Align::kLeft);
  }

  void draw_state() const {
    char text[200];
    std::snprintf(text, sizeof text, "%s  ·  %.1f ms  ·  step %lld of %lld  ·  speed %s",
                  playback_.playing() ? "playing" : "paused", 1e3 * playback_.time_s(),
                  static_cast<long long>(playback_.step_number()),
                  static_cast<long long>(playback_.last_step()), playback_.speed().c_str());
    ImFont* font = canvas_.gui.fonts().body[2];
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text(text, font, palette::kText, text_width(), Align::kLeft);
    const ImVec2 below = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos(at);
    draw_text(
        replay_.agrees ? "every step agrees with the recording" : "differs from the recording",
        font, replay_.agrees ? palette::kResponse : palette::kWarning, text_width(), Align::kRight);
    ImGui::SetCursorScreenPos(below);
  }

  /// The largest area between header and footer with the shape of the recorded screen.
  [[nodiscard]] PixelArea picture_area() const {
    const double room_px = canvas_.gui.height() - header_px_ - footer_height() - 0.5F * margin();
    const ScreenGeometry& screen = replay_.viewer.screen;
    const double scale = std::min(text_width() / screen.width_m, room_px / screen.height_m);
    PixelArea area;
    area.width = static_cast<int>(scale * screen.width_m);
    area.height = static_cast<int>(scale * screen.height_m);
    area.left = (canvas_.window.width_px() - area.width) / 2;
    area.bottom = static_cast<int>(footer_height() + 0.5F * margin() + (room_px - area.height) / 2);
    return area;
  }

  [[nodiscard]] float margin() const { return std::round(0.024F * canvas_.gui.height()); }
  [[nodiscard]] float text_width() const { return canvas_.gui.width() - 2.0F * margin(); }
  [[nodiscard]] float footer_height() const {
    const Fonts& fonts = canvas_.gui.fonts();
    return std::round(margin() + 1.9F * fonts.small->FontSize + timeline_height(canvas_.gui) +
                      1.35F * fonts.body[2]->FontSize);
  }

  Canvas& canvas_;
  const ReplayView& replay_;
  ReplayPlayback playback_;
  float header_px_{0.0F};
  bool gaze_shown_{true};
  BodyColours colours_{BodyColours::kOwn};
};

}  // namespace

ViewerExit view_replay(Window& window, const ReplayView& replay) {
  ViewerExit exit = ViewerExit::kClosed;
  while_display_lasts([&] { exit = ReplayScreen(window.canvas(), replay).run(); });
  return exit;
}

}  // namespace impetus
