// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_help.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/drawing/palette.hpp"
#include "experiments/viewers/replays/replay_commands.hpp"

namespace impetus::inline viewers {

void draw_replay_help(const Gui& gui) {
  constexpr float kLine = 1.5F;  // of the font's size
  ImFont* font = gui.fonts().small;
  const auto width_of = [font](const char* text) {
    return font->CalcTextSizeA(font->FontSize, 1e6F, 0.0F, text).x;
  };
  float keys_px = 0.0F;
  float meanings_px = 0.0F;
  float lines = 0.0F;
  for (const ReplayKey& key : replay_keys()) {
    keys_px = std::max(keys_px, width_of(key.keys));
    meanings_px = std::max(meanings_px, width_of(key.meaning));
    lines += *key.keys != '\0' ? 1.0F : 0.5F;
  }
  const float inset = 1.5F * font->FontSize;
  const ImVec2 size(keys_px + meanings_px + 4.0F * inset,
                    lines * kLine * font->FontSize + 2.0F * inset);
  const ImVec2 from(std::round(0.5F * (gui.width() - size.x)),
                    std::round(0.5F * (gui.height() - size.y)));
  const ImVec2 to(from.x + size.x, from.y + size.y);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(from, to, palette::kSurface, 6.0F);
  draw.AddRect(from, to, palette::kLine, 6.0F);
  float y = from.y + inset;
  for (const ReplayKey& key : replay_keys()) {
    draw.AddText(font, font->FontSize, ImVec2(from.x + inset, y), palette::kAccent, key.keys);
    draw.AddText(font, font->FontSize, ImVec2(from.x + 3.0F * inset + keys_px, y), palette::kText,
                 key.meaning);
    y += (*key.keys != '\0' ? kLine : 0.5F * kLine) * font->FontSize;
  }
}

}  // namespace impetus::inline viewers
