// SPDX-License-Identifier: MIT
#include "experiments/viewers/screen_setup.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "experiments/drawing/palette.hpp"
#include "experiments/viewers/screen_measures.hpp"
#include "experiments/viewers/size_check.hpp"
#include "experiments/window/canvas.hpp"
#include "experiments/window/display_loss.hpp"
#include "experiments/window/key_names.hpp"
#include "experiments/window/pages/form_field.hpp"
#include "experiments/window/pages/page_layout.hpp"
#include "experiments/window/pages/widgets.hpp"
#include "experiments/window/typed_number.hpp"

namespace impetus::inline viewers {
namespace {

constexpr std::size_t kReadingSize = 1;  // the drawings need the room

Page instructions() {
  Page page;
  page.title = "The size of this screen";
  page.paragraphs = {
      "Measure the visible picture with a ruler, and the distance from the participant's eyes to "
      "the screen. Then hold a bank card and a ruler against the drawings: they must have the same "
      "size."};
  return page;
}

class SetupScreen {
 public:
  SetupScreen(Canvas& canvas, const LabScreen& initial)
      : canvas_(canvas), not_square_(!initial.square_pixels) {
    const ScreenGeometry& size = initial.geometry;
    const std::array<double, kMeasures> start{size.width_m, size.height_m, size.viewing_distance_m};
    for (std::size_t i = 0; i < kMeasures; ++i) {
      fields_.emplace_back(
          Field{kPlausible[i].name, kPlausible[i].label, Field::Kind::kNumber, {}, 0.0, 0.0});
      fields_.back().set_answer(centimetres(start[i]));
    }
  }

  std::optional<LabScreen> run() {
    canvas_.window.show_cursor(true);
    canvas_.gui.forget_input();
    canvas_.pacer.restart();
    draw_and_flip();
    canvas_.events.discard();
    while (!canvas_.events.closed() && !cancelled_) {
      take_events();
      draw_and_flip();
      if (saved_) {
        return saved_;
      }
    }
    static_cast<void>(canvas_.events.take_pause_request());
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kSaveStop = kMeasures;
  static constexpr std::size_t kCancelStop = kMeasures + 1;
  static constexpr std::size_t kShapeStop = kMeasures + 2;  ///< only where it is asked for
  static constexpr std::size_t kStops = kMeasures + 3;

  void take_events() {
    for (const StampedEvent& event : canvas_.events.take()) {
      canvas_.gui.feed(event.event);
      if (event.event.type == SDL_KEYDOWN && event.event.key.repeat == 0) {
        press(event.event.key.keysym);
      }
    }
  }

  void press(const SDL_Keysym& key) {
    const bool enter = is_key(key, "enter");
    message_.clear();
    if (key.sym == SDLK_ESCAPE || (enter && focus_ == kCancelStop)) {
      cancelled_ = true;
    } else if (enter && focus_ == kShapeStop) {
      not_square_ = !not_square_;
    } else if (enter) {
      save();
    } else if (key.sym == SDLK_TAB) {
      const std::size_t stops = warning().empty() ? kShapeStop : kStops;
      const bool back = (key.mod & KMOD_SHIFT) != 0;
      focus_ = (focus_ + (back ? stops - 1 : 1)) % stops;
      focus_moved_ = true;
    }
  }

  void save() {
    const EnteredMeasures entered = read();
    message_ = objection_to(entered);
    if (message_.empty() && !not_square_) {
      message_ = warning();
    }
    if (message_.empty()) {
      saved_ = {geometry_of(entered, canvas_.window.width_px(), canvas_.window.height_px()),
                warning().empty()};
    }
  }

  /// Of pixels that are not square.
  [[nodiscard]] std::string warning() const {
    return warning_about(read(), canvas_.window.width_px(), canvas_.window.height_px());
  }

  [[nodiscard]] EnteredMeasures read() const {
    EnteredMeasures entered;
    for (std::size_t i = 0; i < kMeasures; ++i) {
      entered[i] = typed_number(fields_[i].answer());
    }
    return entered;
  }

  void draw_and_flip() {
    canvas_.painter.fill(canvas_.whole(), palette::kPageGrey);
    canvas_.gui.begin();
    draw();
    canvas_.gui.end();
    static_cast<void>(canvas_.pacer.flip());
  }

  void draw() {
    const Gui& gui = canvas_.gui;
    const Column column = reading_column(gui);
    ImGui::PushFont(gui.fonts().body[kReadingSize]);
    ImGui::SetCursorScreenPos(ImVec2(column.left, std::round(0.05F * gui.height())));
    draw_words(gui, instructions(), kReadingSize);
    draw_fields(column);
    draw_remark(column);
    draw_buttons(column);
    draw_check(column);
    ImGui::PopFont();
  }

  void draw_fields(const Column& column) {
    if (focus_moved_) {
      ImGui::ClearActiveID();
    }
    const float top = ImGui::GetCursorScreenPos().y + part_gap();
    const float apart = column.width / static_cast<float>(kMeasures);
    float bottom = top;
    for (std::size_t i = 0; i < kMeasures; ++i) {
      ImGui::SetCursorScreenPos(ImVec2(column.left + static_cast<float>(i) * apart, top));
      const bool focused = focus_ == i;
      const FocusChange change =
          fields_[i].draw(static_cast<int>(i), canvas_.gui, kReadingSize, apart - 0.5F * part_gap(),
                          focused, focused && focus_moved_);
      if (change == FocusChange::kGained) {
        focus_ = i;
      }
      bottom = std::max(bottom, ImGui::GetCursorScreenPos().y);
    }
    focus_moved_ = false;
    ImGui::SetCursorScreenPos(ImVec2(column.left, bottom + 0.4F * part_gap()));
  }

  void draw_remark(const Column& column) {
    const std::string remark = message_.empty() && !not_square_ ? warning() : message_;
    const float top = ImGui::GetCursorScreenPos().y;
    ImFont* font = canvas_.gui.fonts().small;
    draw_text(remark, font, palette::kWarning, column.width, Align::kLeft);
    ImGui::SetCursorScreenPos(ImVec2(column.left, top + std::round(2.8F * font->FontSize)));
  }

  void draw_buttons(const Column& column) {
    const float top = ImGui::GetCursorScreenPos().y;
    const ImVec2 save_px = button_size("Save", "  (Enter)");
    if (draw_button(10, {"Save", "  (Enter)", save_px, focus_ == kSaveStop, false})) {
      save();
    }
    ImGui::SetCursorScreenPos(ImVec2(column.left + save_px.x + part_gap(), top));
    const ImVec2 cancel_px = button_size("Cancel", "  (Esc)");
    if (draw_button(11, {"Cancel", "  (Esc)", cancel_px, focus_ == kCancelStop, false})) {
      cancelled_ = true;
    }
    if (!warning().empty()) {
      ImGui::SetCursorScreenPos(
          ImVec2(column.left + save_px.x + cancel_px.x + 2.0F * part_gap(), top));
      const char* words = "The pixels really are not square";
      const bool focused = focus_ == kShapeStop;
      if (draw_button(12, {words, "", button_size(words, ""), focused, not_square_})) {
        not_square_ = !not_square_;
        message_.clear();
      }
    }
    ImGui::SetCursorScreenPos(ImVec2(column.left, top + save_px.y + 1.4F * part_gap()));
  }

  void draw_check(const Column& column) {
    const auto pixels =
        pixels_per_metre(read(), canvas_.window.width_px(), canvas_.window.height_px());
    if (pixels) {
      draw_card_and_ruler(canvas_.gui, ImVec2(column.left, ImGui::GetCursorScreenPos().y),
                          ImVec2(column.left + column.width, 0.97F * canvas_.gui.height()),
                          *pixels);
    }
  }

  Canvas& canvas_;
  std::vector<FormField> fields_;
  std::size_t focus_{0};
  bool focus_moved_{true};
  std::string message_;
  bool not_square_;  ///< somebody said so
  std::optional<LabScreen> saved_;
  bool cancelled_{false};
};

}  // namespace

std::optional<LabScreen> ask_screen(Window& window, const LabScreen& initial) {
  std::optional<LabScreen> entered;
  while_display_lasts([&] { entered = SetupScreen(window.canvas(), initial).run(); });
  return entered;
}

}  // namespace impetus::inline viewers
