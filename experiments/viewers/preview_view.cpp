// SPDX-License-Identifier: MIT
#include "experiments/viewers/preview_view.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/record/lab_screen.hpp"
#include "experiments/run/preview_run.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/viewers/picture_overlays.hpp"
#include "experiments/viewers/preview_overlays.hpp"
#include "experiments/viewers/preview_panel.hpp"
#include "experiments/viewers/viewer_screen.hpp"
#include "experiments/viewers/volume_levels.hpp"
#include "experiments/window/display.hpp"
#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline viewers {
namespace {

constexpr double kRateAveraged_s = 0.5;

constexpr ImU32 kSpent = palette::kAccent;
constexpr ImU32 kFloor = palette::kHold;
constexpr ImU32 kBudget = palette::kWarning;

/// The next of 1, 2, 5, 10, 20, 50 ... from `value` up.
double round_up(double value) {
  double unit = 10.0;
  while (true) {
    for (const double step : {1.0, 2.0, 5.0}) {
      if (step * unit >= value) {
        return step * unit;
      }
    }
    unit *= 10.0;
  }
}

/// The work of the last few seconds' steps as a strip chart, with its title and key: spent, floor,
/// budget.
class WorkChart {
 public:
  WorkChart(const Gui& gui, const PreviewRun& run, ImVec2 from, ImVec2 to)
      : font_(gui.fonts().small),
        run_(run),
        draw_(*ImGui::GetWindowDrawList()),
        from_(from.x, from.y + 1.5F * font_->FontSize),
        to_(to),
        by_tests_(run.settings().budget == BudgetUnit::kTests) {
    double most = by_tests_ ? run.settings().tests_per_step : 0.0;
    for (const WorkOfStep& step : run.work()) {
      most = std::max(most, static_cast<double>(step.spent));
    }
    top_ = round_up(1.1 * most);
  }

  void draw() {
    draw_.AddRectFilled(from_, to_, palette::kSurface, 3.0F);
    draw_columns();
    if (by_tests_) {
      const float budget = y(run_.settings().tests_per_step);
      draw_.AddLine(ImVec2(from_.x, budget), ImVec2(to_.x, budget), kBudget, 1.5F);
    }
    draw_.AddRect(from_, to_, palette::kLine, 3.0F);
    const std::string text = printed("%.0f", top_);
    write_at(from_ + ImVec2(4, 1), text, font_, palette::kQuietText);
    draw_title();
  }

 private:
  void draw_title() {
    const WorkOfStep last = run_.work().empty() ? WorkOfStep{} : run_.work().back();
    const double span_s = static_cast<double>(run_.work_span()) / run_.scene().step_hz;
    const std::string title = printed("Work per step, last %.0f s", span_s);
    float left = write(title, from_.x, palette::kText) + 1.4F * font_->FontSize;
    left = write_entry(left, kSpent, "spent", last.spent);
    // What is kept for phases to come counts, of which nothing need be spent.
    left = write_entry(left, kFloor, "floor", std::min(last.floor, last.spent));
    if (by_tests_) {
      write_entry(left, kBudget, "budget", last.granted);
    }
  }

  [[nodiscard]] float y(double tests) const {
    const double share = std::min(1.0, tests / top_);
    return to_.y - static_cast<float>(share) * (to_.y - from_.y - 2.0F) - 1.0F;
  }

  /// One column per pixel, the newest step at the right edge; the most of the steps it covers.
  void draw_columns() {
    const auto& work = run_.work();
    const float width = to_.x - from_.x - 2.0F;
    const auto span = static_cast<double>(run_.work_span());
    const double empty = span - static_cast<double>(work.size());
    for (int column = 0; column < static_cast<int>(width); ++column) {
      const auto index_at = [&](int x) {
        const double index = span * x / static_cast<double>(width) - empty;
        return static_cast<std::int64_t>(std::floor(index));
      };
      const std::int64_t end = std::min(std::max(index_at(column + 1), index_at(column) + 1),
                                        static_cast<std::int64_t>(work.size()));
      WorkOfStep most;
      for (std::int64_t i = std::max<std::int64_t>(0, index_at(column)); i < end; ++i) {
        const WorkOfStep& step = work[static_cast<std::size_t>(i)];
        most.spent = std::max(most.spent, step.spent);
        most.floor = std::max(most.floor, std::min(step.floor, step.spent));
      }
      if (end > 0 && most.spent > 0) {
        const float x = from_.x + 1.0F + static_cast<float>(column);
        bar(x, most.spent, kSpent);
        bar(x, most.floor, kFloor);
      }
    }
  }

  void bar(float x, std::int64_t tests, ImU32 colour) {
    draw_.AddRectFilled(ImVec2(x, y(static_cast<double>(tests))), ImVec2(x + 1, to_.y - 1), colour);
  }

  /// Above the chart; returns where it ends.
  float write(const std::string& words, float left, ImU32 colour) {
    write_at(ImVec2(left, from_.y - 1.35F * font_->FontSize), words, font_, colour);
    return left + width_of(words, *font_);
  }

  float write_entry(float left, ImU32 colour, const char* name, std::int64_t tests) {
    const float side = std::round(0.7F * font_->FontSize);
    const ImVec2 corner(left, from_.y - 1.15F * font_->FontSize);
    draw_.AddRectFilled(corner, corner + ImVec2(side, side), colour, 2.0F);
    const std::string words = std::string(name) + " " + std::to_string(tests);
    return write(words, left + 1.5F * side, palette::kQuietText) + 1.2F * font_->FontSize;
  }

  ImFont* font_;
  const PreviewRun& run_;
  ImDrawList& draw_;
  ImVec2 from_;
  ImVec2 to_;
  bool by_tests_;
  double top_{1.0};
};

/// A scene that runs, with its panel.
class PreviewScreen final : public ViewerScreen {
 public:
  PreviewScreen(Canvas& canvas, StagedScene scene, const Clock& clock)
      : ViewerScreen(canvas),
        run_(std::move(scene), clock),
        overlays_(overlays_for(run_.scene())) {}

  [[nodiscard]] const PreviewFrames& frames() const { return frames_; }

 private:
  void go_on(double frame_s) override {
    ++frames_.shown;
    frames_.taken_s += frame_s;
    const double weight = std::min(1.0, frame_s / kRateAveraged_s);
    mean_frame_s_ =
        frames_.shown == 1 ? frame_s : mean_frame_s_ + weight * (frame_s - mean_frame_s_);
    run_.advance(frame_s);
  }

  [[nodiscard]] double frames_per_s() const {
    return mean_frame_s_ > 0.0 ? 1.0 / mean_frame_s_ : 0.0;
  }

  void take(const SDL_Event& event) override {
    if (event.type == SDL_MOUSEMOTION) {
      mouse_ = {static_cast<float>(event.motion.x), static_cast<float>(event.motion.y)};
    } else if (event.type == SDL_KEYDOWN) {
      press(event.key.keysym.sym, event.key.repeat != 0);
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

  void close_list_or_leave() {
    constexpr ImGuiPopupFlags kAny = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
    if (ImGui::IsPopupOpen(nullptr, kAny)) {
      ImGui::ClosePopupToLevel(0, /*restore_focus_to_window_under_popup=*/true);
    } else {
      leave();
    }
  }

  void command(SDL_Keycode key) {
    switch (key) {
      case SDLK_ESCAPE:
        close_list_or_leave();
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

  void paint() override {
    area_ = panel_shown_ ? area_beside_panel() : canvas_.whole();
    const PictureMap map = picture_map();
    follow_mouse(map);
    run_.watch_node_contacts(overlays_.shown && overlays_.contacts);
    Picture picture = run_.picture();
    colour_bodies(picture.bodies, run_.details(), overlays_.colours, run_.settings().finest_level);
    canvas_.painter.paint(picture, area_, volumes_.of(run_, overlays_, picture.bodies));
    bodies_ = std::move(picture.bodies);
  }

  void draw() override {
    push_clip_rect(area_, canvas_.gui.height());
    draw_overlays(run_, overlays_, picture_map(), bodies_);
    draw_colour_legend(canvas_.gui, area_,
                       meanings_of(overlays_.colours, run_.settings().finest_level));
    ImGui::PopClipRect();
    if (panel_shown_) {
      draw_beside();
    }
  }

  [[nodiscard]] PictureMap picture_map() const {
    return {run_.viewer(), area_, canvas_.window.height_px()};
  }

  /// Beside the picture the mouse works the panel: the gaze stays where it was.
  void follow_mouse(const PictureMap& map) {
    const auto point = mouse_ ? map.glass_under(*mouse_) : std::nullopt;
    if (point) {
      run_.look_at(*point);
    }
  }

  void draw_beside() {
    const Gui& gui = canvas_.gui;
    const float right = gui.width() - panel_width(gui);
    WorkChart(gui, run_, ImVec2(margin(), gui.height() - chart_height()),
              ImVec2(right - margin(), gui.height() - margin()))
        .draw();
    const double life_px = canvas_.window.width_px();
    draw_preview_panel(gui, run_, overlays_, {right, area_.width / life_px, frames_per_s()});
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

  PreviewRun run_;
  PreviewOverlays overlays_;
  VolumeLevels volumes_;
  std::optional<WindowPoint> mouse_;  ///< none: it has not moved yet
  bool panel_shown_{true};
  PixelArea area_;                 ///< of the picture
  std::vector<PosedBody> bodies_;  ///< as painted
  PreviewFrames frames_;
  double mean_frame_s_{0.0};
};

}  // namespace

PreviewFrames view_preview(Window& window, StagedScene scene, const Clock& clock) {
  PreviewFrames frames;
  while_display_lasts([&] {
    PreviewScreen screen(window.canvas(), std::move(scene), clock);
    screen.run();
    frames = screen.frames();
  });
  return frames;
}

}  // namespace impetus::inline viewers
