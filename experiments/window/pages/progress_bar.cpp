// SPDX-License-Identifier: MIT
#include "experiments/window/pages/progress_bar.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline window {
namespace {

constexpr float kBarShareOfHeight = 0.006F;

/// The bar's inks.
struct Colours {
  ImU32 track;
  ImU32 done;
  ImU32 label;
};

Colours colours_on(Ground ground) {
  return ground == Ground::kPicture
             ? Colours{IM_COL32(118, 118, 118, 255), IM_COL32(92, 92, 92, 255),
                       IM_COL32(82, 82, 82, 255)}
             : Colours{IM_COL32(186, 186, 186, 255), IM_COL32(128, 128, 130, 255),
                       IM_COL32(84, 84, 88, 255)};
}

/// Quiet, for the experimenter: a ring, and what it means in two words.
void draw_lost_gaze_mark(ImDrawList& draw, ImVec2 at, const ImFont& font, ImU32 colour) {
  const float radius = 0.3F * font.FontSize;
  draw.AddCircle(ImVec2(at.x + radius, at.y + 0.55F * font.FontSize), radius, colour, 0, 1.5F);
  draw.AddText(&font, font.FontSize, at + ImVec2(3.0F * radius, 0.0F), colour, "gaze lost");
}

float bar_height(const Gui& gui) {
  return std::max(4.0F, std::round(gui.height() * kBarShareOfHeight));
}

}  // namespace

float progress_height(const Gui& gui) {
  return bar_height(gui) + std::round(1.7F * gui.fonts().small->FontSize);
}

void draw_progress(const Gui& gui, const SessionProgress& progress, Ground ground) {
  if (progress.total <= 0 && progress.label.empty()) {
    return;
  }
  const Colours colours = colours_on(ground);
  const double share =
      progress.total > 0 ? static_cast<double>(progress.done) / static_cast<double>(progress.total)
                         : 0.0;
  const float top = gui.height() - bar_height(gui);
  const float done_px = gui.width() * static_cast<float>(std::clamp(share, 0.0, 1.0));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(ImVec2(0, top), ImVec2(gui.width(), gui.height()), colours.track);
  draw.AddRectFilled(ImVec2(0, top), ImVec2(done_px, gui.height()), colours.done);

  ImFont* font = gui.fonts().small;
  const ImVec2 label_px = font->CalcTextSizeA(font->FontSize, 1e6F, 0.0F, progress.label.c_str());
  const ImVec2 at(std::floor((gui.width() - label_px.x) / 2.0F),
                  std::floor(top - 1.35F * font->FontSize));
  draw.AddText(font, font->FontSize, at, colours.label, progress.label.c_str());
  if (progress.gaze_was_lost) {
    draw_lost_gaze_mark(draw, ImVec2(at.x + label_px.x + font->FontSize, at.y), *font,
                        colours.label);
  }
}

}  // namespace impetus::inline window
