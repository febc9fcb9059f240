// SPDX-License-Identifier: MIT
#include "experiments/window/window.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/window/canvas.hpp"
#include "experiments/window/display.hpp"
#include "experiments/window/pages/asked_page.hpp"
#include "experiments/window/pages/page_layout.hpp"
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
  while_display_lasts([&] { answer = ask_page(*canvas_, page); });
  return answer;
}

void Window::show_page_for(const Page& page, double seconds,
                           std::optional<std::size_t> highlighted_choice) {
  while_display_lasts([&] { impetus::show_page_for(*canvas_, page, seconds, highlighted_choice); });
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
