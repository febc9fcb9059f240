// The lab's window: shows pictures at flips and asks pages, and stamps both with one clock.
//
//   show(picture)   paint ─> wait for the slot, pumping events ─> swap, finish, stamp ─> Flip
//   ask(page)       the same, with the page on top, until a key or a click answers it ─> Answer
//
// What keeps the stamps honest: events are taken from the system about every half millisecond
// while a slot is waited for, and each keeps the time since the look before as its uncertainty;
// description() says what a flip's stamp is anchored to. SDL, OpenGL and ImGui stay behind this.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "experiments/record/ports.hpp"
#include "experiments/session/timing_check.hpp"

namespace impetus::inline window {

struct Canvas;

/// How the window is opened.
struct WindowOptions {
  bool fullscreen{true};
  int width_px{1280};  ///< of a window that is not fullscreen
  int height_px{1024};
  double refresh_hz{0.0};  ///< 0: ask the display, 60 when it does not know
  std::string title{"Impetus"};
  bool seen{true};  ///< false: for pictures that go elsewhere; then no display is needed
  std::set<std::uint16_t> letters{};  ///< that are shown beside kShownLetters, of kWideLetters
};

/// The first of the letters, of kWideLetters, that no font on this machine has; none: all can be
/// shown. Needs no display.
std::optional<std::uint16_t> first_letter_without_font(const std::set<std::uint16_t>& letters);

/// One at a time. All calls come from the thread that made it.
class Window final : public Display, public Input {
 public:
  /// Throws std::runtime_error with one sentence when no window or no OpenGL 3.3 can be had.
  /// `clock` must outlive the window.
  Window(const WindowOptions& options, const Clock& clock);
  ~Window() override;

  [[nodiscard]] double refresh_hz() const override;
  [[nodiscard]] const ScreenGeometry& geometry() const override;
  void restart_grid() override;
  /// All zero when the display is lost: nothing was flipped.
  Flip show(const Picture& picture) override;
  [[nodiscard]] bool has_patch() const override;

  Answer ask(const Page& page) override;
  Interruption interruption() override;
  std::vector<ClickRecord> take_clicks() override;

  /// The mouse, in place of an eye-tracker, while pictures are shown.
  [[nodiscard]] Gaze& mouse_gaze();

  /// The lab's measures in metres. Pixels are the window's own when they are 0.
  void set_geometry(const ScreenGeometry& geometry);
  /// From now on a window of another size counts as closed: see EventPump.
  void close_when_resized();
  /// From now on a photodiode patch is drawn over all that is shown, dark where nothing is timed.
  /// Call it after set_geometry(), which says how large the screen is.
  void show_patch(ScreenCorner corner);

  [[nodiscard]] int width_px() const;
  [[nodiscard]] int height_px() const;

  /// Whether flips follow the refresh. From then on show() is paced by the blocking swap when they
  /// do (on a grid of the measured rate), otherwise by a timer on the grid of the nominal rate.
  SyncTest sync_test();

  /// Driver, renderer, size, refresh, and what a flip's stamp is anchored to.
  [[nodiscard]] std::string description() const;

  /// Shows a page without asking it, for a simulated participant that is watched; the choice, if
  /// there is one, is drawn as chosen at the end. Ends early when interrupted.
  void show_page_for(const Page& page, double seconds,
                     std::optional<std::size_t> highlighted_choice);

  /// For this room's own screens.
  [[nodiscard]] Canvas& canvas() { return *canvas_; }

 private:
  void warm_up();

  std::unique_ptr<Canvas> canvas_;
  ScreenGeometry geometry_;
};

}  // namespace impetus::inline window
