// SPDX-License-Identifier: MIT
#include "experiments/window/wait_screen.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/drawing/palette.hpp"
#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline window {

void show_wait(Canvas& canvas, const std::string& title, const std::string& doing, double share) {
  const Gui& gui = canvas.gui;
  const float width = std::round(0.5F * gui.width());
  const float left = std::round(0.5F * (gui.width() - width));
  canvas.painter.fill(canvas.whole(), palette::kPageGrey);
  canvas.gui.begin();
  ImGui::SetCursorScreenPos(ImVec2(left, std::round(0.4F * gui.height())));
  draw_text(title, gui.fonts().title[2], palette::kText, width, Align::kLeft);
  const int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
  draw_text(doing + "  " + std::to_string(percent) + " %", gui.fonts().body[2], palette::kText,
            width, Align::kLeft);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 to(from.x + width, from.y + std::round(0.4F * gui.fonts().small->FontSize));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(from, to, palette::kSurface, 3.0F);
  draw.AddRectFilled(from, ImVec2(from.x + width * static_cast<float>(0.01 * percent), to.y),
                     palette::kAccent, 3.0F);
  canvas.gui.end();
  static_cast<void>(canvas.pacer.flip());
}

}  // namespace impetus::inline window
