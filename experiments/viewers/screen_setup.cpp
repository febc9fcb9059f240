// SPDX-License-Identifier: MIT
#include "experiments/viewers/screen_setup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "experiments/tables/number_text.hpp"
#include "experiments/viewers/viewer_screen.hpp"
#include "experiments/window/display.hpp"
#include "experiments/window/pages/form_field.hpp"
#include "experiments/window/pages/page_layout.hpp"
#include "experiments/window/pages/widgets.hpp"
#include "experiments/window/typed_input.hpp"

namespace impetus::inline viewers {
namespace {

/// Width, height, viewing distance.
constexpr std::size_t kMeasures = 3;

/// One of them: what it is called, and what is plausible.
struct PlausibleMeasure {
  const char* name;
  const char* label;
  double least_cm;
  double most_cm;
};
constexpr std::array<PlausibleMeasure, kMeasures> kPlausible{
    {{"width", "Width of the picture (cm)", 10.0, 300.0},
     {"height", "Height of the picture (cm)", 10.0, 200.0},
     {"viewing distance", "Viewing distance (cm)", 20.0, 300.0}}};

/// In centimetres; nothing where no number stands.
using EnteredMeasures = std::array<std::optional<double>, kMeasures>;

bool is_plausible(const std::optional<double>& entered_cm, const PlausibleMeasure& measure) {
  return entered_cm && *entered_cm >= measure.least_cm && *entered_cm <= measure.most_cm;
}

/// "37.6" for 0.376 m; empty for 0.
std::string centimetres(double length_m) {
  return length_m > 0.0 ? printed("%g", 100.0 * length_m) : "";
}

/// One sentence naming what was expected and what was there; empty when all are plausible.
std::string objection_to(const EnteredMeasures& entered) {
  for (std::size_t i = 0; i < kMeasures; ++i) {
    const PlausibleMeasure& measure = kPlausible[i];
    if (is_plausible(entered[i], measure)) {
      continue;
    }
    const std::string there = entered[i] ? printed("%g", *entered[i]) : "nothing";
    return printed("The %s: expected %g to %g cm, got %s.", measure.name, measure.least_cm,
                   measure.most_cm, there.c_str());
  }
  return "";
}

/// Width and height must be plausible.
ScreenGeometry geometry_of(const EnteredMeasures& entered, int width_px, int height_px) {
  return {*entered[0] / 100.0, *entered[1] / 100.0, width_px, height_px,
          entered[2].value_or(0.0) / 100.0};
}

/// One sentence when the pixels come out non-square by more than 1 %; otherwise empty.
std::string warning_about(const ScreenGeometry& screen) {
  return has_square_pixels(screen)
             ? ""
             : "Of " + std::to_string(screen.width_px) + " × " + std::to_string(screen.height_px) +
                   " pixels each would be " + pixel_words(screen) +
                   ": not square within 1 %. Please check width and height.";
}

// ISO/IEC 7810 ID-1
constexpr double kCardWidthM = 0.08560;
constexpr double kCardHeightM = 0.05398;
constexpr double kCardCornerM = 0.00318;
constexpr int kRulerCm = 10;

void draw_ruler(const Gui& gui, ImVec2 from, double pixels_per_cm) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  ImFont* font = gui.fonts().small;
  const auto x = [&](double cm) { return from.x + static_cast<float>(cm * pixels_per_cm); };
  draw.AddLine(from, ImVec2(x(kRulerCm), from.y), palette::kText, 1.5F);
  for (int half_cm = 0; half_cm <= 2 * kRulerCm; ++half_cm) {
    const bool whole = half_cm % 2 == 0;
    const float at = x(0.5 * half_cm);
    draw.AddLine(ImVec2(at, from.y), ImVec2(at, from.y + (whole ? 0.8F : 0.45F) * font->FontSize),
                 palette::kText, 1.5F);
    if (whole) {
      const std::string number = std::to_string(half_cm / 2);
      const float width = width_of(number, *font);
      write_at(ImVec2(at - width / 2.0F, from.y + font->FontSize), number, font,
               palette::kQuietText);
    }
  }
  write_at(ImVec2(x(kRulerCm) + font->FontSize, from.y + font->FontSize), "cm", font,
           palette::kQuietText);
}

/// Both at life size between the corners, to be held against real ones; what does not fit is cut
/// off at the corners.
void draw_card_and_ruler(const Gui& gui, ImVec2 from, ImVec2 to, const ScreenGeometry& screen) {
  const double px_per_m_across = screen.width_px / screen.width_m;
  const double px_per_m_down = screen.height_px / screen.height_m;
  ImFont* font = gui.fonts().small;
  const float em = font->FontSize;
  const float bleed = 0.6F * em;  // for the ruler's first number
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(from - ImVec2(bleed, bleed), to, true);
  draw_ruler(gui, from, px_per_m_across / 100.0);
  const ImVec2 card = from + ImVec2(0.0F, 3.0F * em);
  const ImVec2 card_end = card + ImVec2(static_cast<float>(kCardWidthM * px_per_m_across),
                                        static_cast<float>(kCardHeightM * px_per_m_down));
  const auto corner_px = static_cast<float>(kCardCornerM * px_per_m_across);
  draw.AddRectFilled(card, card_end, palette::kSurface, corner_px);
  draw.AddRect(card, card_end, palette::kText, corner_px, 0, 1.5F);
  write_at(card + ImVec2(em, em), "bank card, 85.6 × 54.0 mm", font, palette::kQuietText);
  draw.PopClipRect();
}

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

/// The page with its three fields, its buttons, and the drawings that check them.
class SetupScreen final : public ViewerScreen {
 public:
  SetupScreen(Canvas& canvas, const LabScreen& initial)
      : ViewerScreen(canvas), not_square_(!initial.square_pixels) {
    const ScreenGeometry& size = initial.geometry;
    const std::array<double, kMeasures> start{size.width_m, size.height_m, size.viewing_distance_m};
    for (std::size_t i = 0; i < kMeasures; ++i) {
      fields_.emplace_back(Field{kPlausible[i].name,
                                 kPlausible[i].label,
                                 Field::Kind::kNumber,
                                 {},
                                 0.0,
                                 0.0,
                                 centimetres(start[i])});
    }
  }

  /// None: cancelled.
  [[nodiscard]] const std::optional<LabScreen>& saved() const { return saved_; }

 private:
  static constexpr std::size_t kSaveStop = kMeasures;
  static constexpr std::size_t kCancelStop = kMeasures + 1;
  static constexpr std::size_t kShapeStop = kMeasures + 2;  ///< only where it is asked for
  static constexpr std::size_t kStops = kMeasures + 3;

  void take(const SDL_Event& event) override {
    if (event.type == SDL_KEYDOWN && event.key.repeat == 0) {
      press(event.key.keysym);
    }
  }

  void press(const SDL_Keysym& key) {
    const bool enter = is_key(key, "enter");
    message_.clear();
    if (key.sym == SDLK_ESCAPE || (enter && focus_ == kCancelStop)) {
      leave();
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
    message_ = objection_to(read());
    if (message_.empty() && !not_square_) {
      message_ = warning();
    }
    if (message_.empty()) {
      saved_ = {*geometry(), warning().empty()};
      leave();
    }
  }

  /// Of pixels that are not square.
  [[nodiscard]] std::string warning() const {
    const auto entered = geometry();
    return entered ? warning_about(*entered) : "";
  }

  /// None while width or height is implausible.
  [[nodiscard]] std::optional<ScreenGeometry> geometry() const {
    const EnteredMeasures entered = read();
    const bool plausible =
        is_plausible(entered[0], kPlausible[0]) && is_plausible(entered[1], kPlausible[1]);
    return plausible ? std::optional(geometry_of(entered, canvas_.window.width_px(),
                                                 canvas_.window.height_px()))
                     : std::nullopt;
  }

  [[nodiscard]] EnteredMeasures read() const {
    EnteredMeasures entered;
    for (std::size_t i = 0; i < kMeasures; ++i) {
      entered[i] = typed_number(fields_[i].answer());
    }
    return entered;
  }

  void draw() override {
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
      leave();
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
    if (const auto screen = geometry()) {
      draw_card_and_ruler(canvas_.gui, ImVec2(column.left, ImGui::GetCursorScreenPos().y),
                          ImVec2(column.left + column.width, 0.97F * canvas_.gui.height()),
                          *screen);
    }
  }

  std::vector<FormField> fields_;
  std::size_t focus_{0};
  bool focus_moved_{true};
  std::string message_;
  bool not_square_;  ///< somebody said so
  std::optional<LabScreen> saved_;
};

}  // namespace

std::optional<LabScreen> ask_screen(Window& window, const LabScreen& initial) {
  std::optional<LabScreen> entered;
  while_display_lasts([&] {
    SetupScreen screen(window.canvas(), initial);
    screen.run();
    entered = screen.saved();
  });
  return entered;
}

}  // namespace impetus::inline viewers
