// SPDX-License-Identifier: MIT
#include "experiments/viewers/preview_view.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/drawing/palette.hpp"
#include "experiments/record/lab_screen.hpp"
#include "experiments/run/preview_run.hpp"
#include "experiments/viewers/colour_legend.hpp"
#include "experiments/viewers/preview_overlays.hpp"
#include "experiments/viewers/preview_panel.hpp"
#include "experiments/viewers/volume_levels.hpp"
#include "experiments/viewers/work_chart.hpp"
#include "experiments/window/canvas.hpp"
#include "experiments/window/display_loss.hpp"
#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline viewers {
namespace {

constexpr double kRateAveraged_s = 0.5;

class PreviewScreen {
 public:
  PreviewScreen(Canvas& canvas, StagedScene scene, const Clock& clock)
      : canvas_(canvas), run_(std::move(scene), clock), overlays_(overlays_for(run_.scene())) {}

  PreviewFrames run() {
    canvas_.window.show_cursor(true);
    canvas_.gui.forget_input();
    canvas_.pacer.restart();
    std::int64_t flipped_ns = draw_and_flip();
    canvas_.events.discard();
    while (!canvas_.events.closed() && !left_) {
      take_events();
      const std::int64_t now_ns = draw_and_flip();
      const double frame_s = static_cast<double>(now_ns - flipped_ns) / 1e9;
      count(frame_s);
      run_.advance(frame_s);
      flipped_ns = now_ns;
    }
    static_cast<void>(canvas_.events.take_pause_request());
    return frames_;
  }

 private:
  /// A frame that took so long.
  void count(double frame_s) {
    ++frames_.shown;
    frames_.taken_s += frame_s;
    const double weight = std::min(1.0, frame_s / kRateAveraged_s);
    mean_frame_s_ =
        frames_.shown == 1 ? frame_s : mean_frame_s_ + weight * (frame_s - mean_frame_s_);
  }

  [[nodiscard]] double frames_per_s() const {
    return mean_frame_s_ > 0.0 ? 1.0 / mean_frame_s_ : 0.0;
  }

  void take_events() {
    for (const StampedEvent& event : canvas_.events.take()) {
      canvas_.gui.feed(event.event);
      if (event.event.type == SDL_MOUSEMOTION) {
        mouse_ = {static_cast<float>(event.event.motion.x),
                  static_cast<float>(event.event.motion.y)};
      } else if (event.event.type == SDL_KEYDOWN) {
        press(event.event.key.keysym.sym, event.event.key.repeat != 0);
      }
    }
  }

  /// Letters that are typed into a number are no commands; Enter and Esc end the typing.
  void press(SDL_Keycode key, bool repeats) {
    const bool ends = key == SDLK_ESCAPE || key == SDLK_RETURN || key == SDLK_KP_ENTER;
    if (ImGui::GetIO().WantTextInput) {
      if (ends) {
        canvas_.gui.forget_input();
      }
    } else if (key == SDLK_s) {
      run_.step();
    } else if (!repeats) {
      command(key);
    }
  }

  void command(SDL_Keycode key) {
    switch (key) {
      case SDLK_ESCAPE:
        left_ = true;
        break;
      case SDLK_SPACE:
        run_.toggle();
        break;
      case SDLK_r:
        run_.restart();
        break;
      case SDLK_o:
        overlays_.shown = !overlays_.shown;
        break;
      case SDLK_c:
        overlays_.colours = next_colours(overlays_.colours);
        break;
      case SDLK_h:
        panel_shown_ = !panel_shown_;
        break;
      default:
        break;
    }
  }

  std::int64_t draw_and_flip() {
    const PixelArea area = panel_shown_ ? area_beside_panel() : canvas_.whole();
    const PictureMap map(run_.viewer(), area, canvas_.window.height_px());
    follow_mouse(map);
    run_.watch_node_contacts(overlays_.shown && overlays_.contacts);
    Picture picture;
    picture.bodies = shown_bodies(run_, overlays_);
    picture.enclosure = run_.scene().world.settings().enclosure;
    picture.viewer = run_.viewer();
    canvas_.painter.fill(canvas_.whole(), palette::kPageGrey);
    canvas_.painter.paint(picture, area, volumes_.of(run_, overlays_, picture.bodies));
    canvas_.gui.begin();
    draw_over(area, map, picture.bodies);
    if (panel_shown_) {
      draw_beside(area);
    }
    canvas_.gui.end();
    return canvas_.pacer.flip().flipped_ns;
  }

  /// Beside the picture the mouse works the panel: the gaze stays where it was.
  void follow_mouse(const PictureMap& map) {
    const auto point = mouse_ ? map.glass_under(*mouse_) : std::nullopt;
    if (point) {
      run_.look_at(*point);
    }
  }

  void draw_over(const PixelArea& area, const PictureMap& map,
                 const std::vector<PosedBody>& bodies) {
    push_clip_rect(area, canvas_.gui.height());
    draw_overlays(run_, overlays_, map, bodies);
    draw_colour_legend(canvas_.gui, area,
                       meanings_of(overlays_.colours, run_.settings().finest_level));
    ImGui::PopClipRect();
  }

  void draw_beside(const PixelArea& area) {
    const Gui& gui = canvas_.gui;
    const float right = gui.width() - panel_width(gui);
    draw_work_chart(gui, run_, ImVec2(margin(), gui.height() - chart_height()),
                    ImVec2(right - margin(), gui.height() - margin()));
    const double life_px = canvas_.window.width_px();
    draw_preview_panel(gui, run_, overlays_, {right, area.width / life_px, frames_per_s()});
  }

  /// The largest area above the chart and beside the panel with the shape of the screen.
  [[nodiscard]] PixelArea area_beside_panel() const {
    const ScreenGeometry& screen = run_.scene().viewer.screen;
    const double wide_px = canvas_.gui.width() - panel_width(canvas_.gui) - 2.0F * margin();
    const double high_px = canvas_.gui.height() - chart_height() - 2.0F * margin();
    const PicturePixels largest = largest_picture(screen, wide_px, high_px);
    PixelArea area;
    area.width = largest.width;
    area.height = largest.height;
    area.left = static_cast<int>(margin() + (wide_px - area.width) / 2);
    area.bottom = static_cast<int>(chart_height() + margin() + (high_px - area.height) / 2);
    return area;
  }

  [[nodiscard]] float margin() const { return std::round(0.012F * canvas_.gui.height()); }
  [[nodiscard]] float chart_height() const { return std::round(0.17F * canvas_.gui.height()); }

  Canvas& canvas_;
  PreviewRun run_;
  PreviewOverlays overlays_;
  VolumeLevels volumes_;
  std::optional<WindowPoint> mouse_;  ///< none: it has not moved yet
  bool panel_shown_{true};
  bool left_{false};
  PreviewFrames frames_;
  double mean_frame_s_{0.0};
};

}  // namespace

PreviewFrames view_preview(Window& window, StagedScene scene, const Clock& clock) {
  PreviewFrames frames;
  while_display_lasts(
      [&] { frames = PreviewScreen(window.canvas(), std::move(scene), clock).run(); });
  return frames;
}

}  // namespace impetus::inline viewers
