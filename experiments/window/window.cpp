// SPDX-License-Identifier: MIT
#include "experiments/window/window.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/window/canvas.hpp"
#include "experiments/window/display.hpp"
#include "experiments/window/pages/page_layout.hpp"
#include "experiments/window/pages/page_view.hpp"
#include "experiments/window/shown_patch.hpp"

namespace impetus::inline window {
namespace {

/// A point that is easy to look at: a dark disc, a light cross through it, a dark dot in its
/// middle. Of seven shapes this one let the eye rest most. (Thaler et al. 2013)
void draw_fixation_target(const Gui& gui, const ScreenGeometry& screen, const ScreenPoint& at) {
  constexpr double kDisc_deg = 0.6;  // across
  constexpr double kDot_deg = 0.2;   // as is the cross's thickness
  constexpr ImU32 kDark = IM_COL32(24, 24, 26, 255);
  constexpr ImU32 kLight = IM_COL32(128, 128, 128, 255);  // the picture's own grey
  const double px_per_deg =
      gui.width() / screen.width_m * metres_per_degree(screen.viewing_distance_m);
  const auto radius = std::max(7.0F, static_cast<float>(px_per_deg * kDisc_deg / 2.0));
  const auto dot = std::max(2.5F, static_cast<float>(px_per_deg * kDot_deg / 2.0));
  const ImVec2 centre(static_cast<float>((at.x_m / screen.width_m + 0.5) * gui.width()),
                      static_cast<float>((0.5 - at.y_m / screen.height_m) * gui.height()));
  const ImVec2 across(radius + 1.0F, dot);
  const ImVec2 down(dot, radius + 1.0F);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddCircleFilled(centre, radius, kDark);
  draw.AddRectFilled(centre - across, centre + across, kLight);
  draw.AddRectFilled(centre - down, centre + down, kLight);
  draw.AddCircleFilled(centre, dot, kDark);
}

std::shared_ptr<const TriangleMesh> tiny_triangle() {
  TriangleMesh mesh;
  mesh.vertices = {Vector3(0.0, 0.0, 0.0), Vector3(0.01, 0.0, 0.0), Vector3(0.0, 0.01, 0.0)};
  mesh.triangles = {{0, 1, 2}};
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

/// An appearance for which every shader is needed.
std::shared_ptr<const Appearance> all_looks() {
  auto looks = std::make_shared<Appearance>();
  looks->ground = GroundPattern::kChecks;
  looks->check_m = 0.01;
  looks->floor_m = -0.01;
  looks->lights.emplace_back();
  looks->cast_shadows = 1.0;
  looks->contact_shadows = 1.0;
  looks->contact_reach_m = 0.01;
  looks->shadow_reach_m = 0.1;
  return looks;
}

/// One page, from the flip that first shows it to its answer.
///
///   first flip ─> forget what was pressed before ─> events, frame, flip ─> ... ─> answer
///
/// A press counts only when it was taken after the page was on the glass, so an impatient key
/// cannot answer a question that has not been seen.
class PageTurn {
 public:
  PageTurn(Canvas& canvas, const Page& page)
      : canvas_(canvas), page_(page), view_(page, canvas.gui) {}

  /// Shows it in the largest reading size at which it fits, until it is answered, paused, out of
  /// time, or the window is closed; what does not fit even at the smallest size is scrolled.
  Answer ask() {
    show_first();
    if (page_.can_pause && canvas_.events.take_pause_request()) {
      answer_.interruption = Interruption::kPauseRequested;
      return answer_;
    }
    while (!canvas_.events.closed()) {
      if (take_events() || take_click(draw_and_flip()) || time_is_up()) {
        static_cast<void>(canvas_.events.take_pause_request());
        answer_.fields = view_.answers();
        return answer_;
      }
    }
    answer_.interruption = Interruption::kDisplayClosed;
    return answer_;
  }

  /// Shows it for this long; `choice` is drawn as chosen in the last third, if there is one.
  void show_for(double seconds, std::optional<std::size_t> choice) {
    constexpr double kSeenUnanswered = 0.66;
    show_first();
    const double shown_ms = seconds * 1e3;
    while (elapsed_ms() < shown_ms && !canvas_.events.closed() &&
           !canvas_.events.pause_requested()) {
      if (choice && elapsed_ms() >= kSeenUnanswered * shown_ms) {
        view_.mark_chosen(*choice);
      }
      static_cast<void>(draw_and_flip());
      canvas_.events.discard();
    }
  }

 private:
  void show_first() {
    canvas_.window.show_cursor(true);
    canvas_.deadlines.restart();
    static_cast<void>(draw_and_flip());
    answer_.shown_ns = last_flip_ns_;
    canvas_.events.discard();
  }

  [[nodiscard]] double elapsed_ms() const {
    return static_cast<double>(last_flip_ns_ - answer_.shown_ns) / 1e6;
  }

  /// What was pressed or clicked while the last frame was waited for still counts.
  bool time_is_up() {
    if (page_.timeout_ms <= 0.0 || elapsed_ms() < page_.timeout_ms) {
      return false;
    }
    if (!take_events() && !take_click(view_.take_input())) {
      answer_.timed_out = true;
      answer_.device = "none";
      answer_.arrived_ns = last_flip_ns_;
    }
    return true;
  }

  /// Returns true when an event has answered or interrupted the page.
  bool take_events() {
    for (const StampedEvent& event : canvas_.events.take()) {
      if (event.event.type == SDL_KEYDOWN && event.event.key.repeat == 0 && take_key(event)) {
        return true;
      }
      if (event.event.type == SDL_MOUSEWHEEL) {
        view_.scroll(-0.15F * static_cast<float>(event.event.wheel.y));
      }
      note_mouse(event);
      canvas_.gui.feed(event.event);
    }
    return false;
  }

  bool take_key(const StampedEvent& event) {
    const SDL_Keysym& key = event.event.key.keysym;
    if (const auto choice = view_.press(key)) {
      return answer_with(*choice, "key", event);
    }
    if (key.sym == SDLK_ESCAPE && page_.can_pause) {
      static_cast<void>(view_.take_input());  // for when the page is shown again
      answer_.interruption = Interruption::kPauseRequested;
      note_arrival("key", event);
      return true;
    }
    return false;
  }

  void note_mouse(const StampedEvent& event) {
    if (event.event.button.button != SDL_BUTTON_LEFT) {
      return;
    }
    if (event.event.type == SDL_MOUSEBUTTONDOWN) {
      pressed_here_ = true;
    } else if (event.event.type == SDL_MOUSEBUTTONUP) {
      released_ = event;
    }
  }

  bool take_click(std::optional<std::size_t> clicked) {
    return clicked && pressed_here_ && answer_with(*clicked, "mouse", released_);
  }

  bool answer_with(std::size_t choice, const char* device, const StampedEvent& event) {
    if (!view_.may_leave_by(choice)) {
      return false;
    }
    answer_.choice = choice;
    note_arrival(device, event);
    return true;
  }

  void note_arrival(const char* device, const StampedEvent& event) {
    answer_.device = device;
    answer_.arrived_ns = event.arrived_ns;
    answer_.arrival_uncertainty_ns = event.uncertainty_ns;
  }

  std::optional<std::size_t> draw_and_flip() {
    canvas_.fill_page(page_.progress.light_ground);
    canvas_.gui.begin();
    if (page_.timeout_ms > 0.0 && answer_.shown_ns > 0) {
      view_.tell_time_left(1.0 - elapsed_ms() / page_.timeout_ms);
    }
    const auto clicked = view_.draw();
    canvas_.gui.end();
    canvas_.paint_patch(kDarkPatch);
    const Flip flip = canvas_.deadlines.flip();
    view_.note_shown();
    last_flip_ns_ = flip.flipped_ns;
    answer_.late_frames += flip.late() ? 1 : 0;
    return clicked;
  }

  Canvas& canvas_;
  const Page& page_;
  PageView view_;
  Answer answer_;
  std::int64_t last_flip_ns_{0};
  bool pressed_here_{false};  ///< the mouse button went down on this page
  StampedEvent released_;     ///< the last release of the mouse button
};

}  // namespace

void paint_picture(Canvas& canvas, const Picture& picture, const ScreenGeometry& screen) {
  canvas.painter.paint(picture, canvas.whole());
  canvas.gui.begin();
  if (picture.target) {
    draw_fixation_target(canvas.gui, screen, *picture.target);
  }
  draw_progress(canvas.gui, picture.progress, BarPlace::kPicture);
  canvas.gui.end();
  canvas.paint_patch(picture.patch_code);
}

Window::Window(const WindowOptions& options, const Clock& clock)
    : canvas_(std::make_unique<Canvas>(options, clock)) {
  set_geometry({});
  while_display_lasts([this] { warm_up(); });
}

Window::~Window() {
  if (display_lost()) {
    // Closing would call into libraries whose locks the loss left held.
    static_cast<void>(canvas_.release());
  }
}

double Window::refresh_hz() const { return canvas_->window.refresh_hz(); }
const ScreenGeometry& Window::geometry() const { return geometry_; }
int Window::width_px() const { return canvas_->window.width_px(); }
int Window::height_px() const { return canvas_->window.height_px(); }
void Window::restart_grid() { canvas_->deadlines.restart(); }
bool Window::has_patch() const { return canvas_->patch.has_value(); }

void Window::close_when_resized() { canvas_->events.close_when_resized(width_px(), height_px()); }

void Window::show_patch(ScreenCorner corner) {
  canvas_->patch = patch_area(corner, geometry_, width_px(), height_px());
}

void Window::set_geometry(const ScreenGeometry& geometry) {
  geometry_ = geometry;
  if (geometry_.width_px == 0) {
    geometry_.width_px = width_px();
  }
  if (geometry_.height_px == 0) {
    geometry_.height_px = height_px();
  }
  ScreenGeometry shown = geometry_;
  shown.width_px = width_px();
  shown.height_px = height_px();
  canvas_->mouse.set_geometry(shown);
}

// Drivers finish compiling shaders when they are first used: not in front of a participant.
void Window::warm_up() {
  Picture picture;
  picture.fixation_cross = true;
  picture.viewer = viewer_at({0.4, 0.3, width_px(), height_px(), 0.6}, 0.0);
  picture.bodies.push_back({{}, {"", 0.01, {0.5F, 0.5F, 0.5F}}});
  picture.progress = {1, 2, "0123456789"};
  canvas_->window.show_cursor(false);
  Picture with_mesh = picture;
  with_mesh.bodies.push_back({{}, {"", 0.01, {0.5F, 0.5F, 0.5F}, tiny_triangle()}});
  with_mesh.enclosure = ClosedCube{0.1};
  Picture with_lights = with_mesh;
  with_lights.appearance = all_looks();
  Picture crowd = with_mesh;
  crowd.bodies.resize(kFewBodies + 1, with_mesh.bodies.back());
  constexpr PixelArea kCorner{0, 0, 64, 64};  // shaders are compiled for any size
  canvas_->painter.paint(with_lights, kCorner);
  constexpr int kFrames = 3;
  for (int frame = 0; frame < kFrames; ++frame) {
    canvas_->painter.paint(with_mesh, canvas_->whole());
    canvas_->painter.paint(crowd, canvas_->whole());
    canvas_->painter.paint(picture, canvas_->whole());
    canvas_->fill_page(/*light=*/false);
    canvas_->gui.begin();
    draw_progress(canvas_->gui, picture.progress, BarPlace::kPage);
    canvas_->gui.end();
    canvas_->fill_page(/*light=*/false);
    static_cast<void>(canvas_->deadlines.flip());
  }
  canvas_->events.discard();
}

Flip Window::show(const Picture& picture) {
  Flip flip;
  while_display_lasts([&] {
    canvas_->window.show_cursor(picture.pointer);
    paint_picture(*canvas_, picture, geometry_);
    flip = canvas_->deadlines.flip();
    canvas_->mouse.take(canvas_->events.take());
  });
  return flip;
}

std::vector<ClickRecord> Window::take_clicks() { return canvas_->mouse.take_clicks(); }
Gaze& Window::mouse_gaze() { return canvas_->mouse; }

Answer Window::ask(const Page& page) {
  Answer answer;
  answer.interruption = Interruption::kDisplayClosed;
  while_display_lasts([&] { answer = PageTurn(*canvas_, page).ask(); });
  return answer;
}

void Window::show_page_for(const Page& page, double seconds,
                           std::optional<std::size_t> highlighted_choice) {
  while_display_lasts([&] { PageTurn(*canvas_, page).show_for(seconds, highlighted_choice); });
}

Interruption Window::interruption() {
  if (canvas_->events.closed()) {
    return Interruption::kDisplayClosed;
  }
  return canvas_->events.take_pause_request() ? Interruption::kPauseRequested : Interruption::kNone;
}

SyncTest Window::sync_test() {
  SyncTest test;
  while_display_lasts([&] {
    canvas_->window.show_cursor(false);
    test = canvas_->deadlines.sync_test(
        [this] { canvas_->painter.fill(canvas_->whole(), palette::kPictureGrey); });
  });
  return test;
}

std::string Window::description() const {
  return canvas_->window.description() + "; flip stamp: " + canvas_->deadlines.anchor();
}

}  // namespace impetus::inline window
