// SPDX-License-Identifier: MIT
#include "experiments/viewers/tree_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "experiments/drawing/palette.hpp"
#include "experiments/drawing/tree_painter.hpp"
#include "experiments/viewers/panel_style.hpp"
#include "experiments/window/canvas.hpp"
#include "experiments/window/display_loss.hpp"
#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline viewers {
namespace {

struct ColourChoice {
  TreeColour colour;
  const char* name;
  SDL_Keycode key;
  const char* tooltip;
};

constexpr std::array<ColourChoice, 3> kTreeColours{
    {{TreeColour::kLevel, "level", SDLK_l, "Each level a colour of its own. Key: L"},
     {TreeColour::kOccupancy, "occupancy", SDLK_o,
      "The share of the node that is solid: violet nothing, green half, yellow all. Key: O"},
     {TreeColour::kGroup, "group", SDLK_g,
      "The nearly plane piece of surface that a node lies on; grey for none. Key: G"}}};

constexpr const char* kKeys =
    "← → level  ·  L O G colour  ·  M mesh  ·  V volumes  ·  drag to turn  ·  wheel to zoom  ·  R "
    "as at first  ·  Esc close";

class TreeScreen {
 public:
  TreeScreen(Canvas& canvas, const ShownTree& shown, const TreeLook& look)
      : canvas_(canvas), shown_(shown), painter_(shown), look_(look) {}

  void run() {
    canvas_.window.show_cursor(true);
    canvas_.gui.forget_input();
    canvas_.pacer.restart();
    draw_and_flip();
    canvas_.events.discard();
    while (!canvas_.events.closed() && !left_) {
      take_events();
      draw_and_flip();
    }
    static_cast<void>(canvas_.events.take_pause_request());
  }

 private:
  void take_events() {
    for (const StampedEvent& stamped : canvas_.events.take()) {
      const SDL_Event& event = stamped.event;
      canvas_.gui.feed(event);
      if (event.type == SDL_KEYDOWN) {
        press(event.key.keysym.sym);
      } else if (event.type == SDL_MOUSEBUTTONDOWN) {
        dragging_ = event.button.x < picture_width();
      } else if (event.type == SDL_MOUSEBUTTONUP) {
        dragging_ = false;
      } else if (event.type == SDL_MOUSEMOTION && dragging_) {
        const double height_px = canvas_.window.height_px();
        orbit_.drag(event.motion.xrel / height_px, -event.motion.yrel / height_px);
      } else if (event.type == SDL_MOUSEWHEEL) {
        orbit_.notch(event.wheel.y);
      }
    }
  }

  void press(SDL_Keycode key) {
    for (const ColourChoice& choice : kTreeColours) {
      look_.colour = choice.key == key ? choice.colour : look_.colour;
    }
    switch (key) {
      case SDLK_ESCAPE:
        left_ = true;
        break;
      case SDLK_LEFT:
      case SDLK_DOWN:
        step(-1);
        break;
      case SDLK_RIGHT:
      case SDLK_UP:
        step(1);
        break;
      case SDLK_m:
        look_.mesh = !look_.mesh;
        break;
      case SDLK_v:
        look_.volumes = !look_.volumes;
        break;
      case SDLK_r:
        orbit_ = Orbit();
        break;
      default:
        break;
    }
  }

  void step(int levels) {
    look_.level = std::clamp(look_.level + levels, 0, shown_.tree.level_count() - 1);
  }

  void draw_and_flip() {
    canvas_.painter.fill(canvas_.whole(), palette::kPageGrey);
    const int keys_px = static_cast<int>(keys_height());
    painter_.paint(look_, orbit_,
                   {0, keys_px, picture_width(), canvas_.window.height_px() - keys_px},
                   palette::kPageGrey);
    canvas_.gui.begin();
    draw_panel();
    draw_keys(static_cast<float>(picture_width()));
    canvas_.gui.end();
    canvas_.pacer.flip();
  }

  void draw_panel() {
    const Gui& gui = canvas_.gui;
    const PanelStyle style(gui.fonts().small);
    const float left = gui.width() - panel_width();
    ImGui::SetCursorScreenPos(ImVec2(left, 0));
    ImGui::BeginChild("panel", ImVec2(panel_width(), gui.height()), false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::TextWrapped("%s", shown_.title.c_str());
    panel_heading("Level");
    draw_levels();
    draw_legend();
    panel_heading("Colour by");
    for (const ColourChoice& choice : kTreeColours) {
      if (ImGui::RadioButton(choice.name, look_.colour == choice.colour)) {
        look_.colour = choice.colour;
      }
      panel_tooltip(choice.tooltip);
    }
    panel_heading("Show");
    ImGui::Checkbox("mesh, through the volumes", &look_.mesh);
    panel_tooltip("Without it the volumes are solid. Key: M");
    ImGui::Checkbox("volumes", &look_.volumes);
    panel_tooltip("Key: V");
    if (ImGui::Button("View as at first")) {
      orbit_ = Orbit();
    }
    panel_tooltip("Key: R");
    ImGui::EndChild();
  }

  void draw_levels() {
    for (int level = 0; level < shown_.tree.level_count(); ++level) {
      if (level > 0) {
        ImGui::SameLine();
      }
      if (ImGui::RadioButton(std::to_string(level).c_str(), look_.level == level)) {
        look_.level = level;
      }
      panel_tooltip("0 is the root. Keys: ← →");
    }
  }

  void draw_legend() {
    if (!ImGui::BeginTable("legend", 2)) {
      return;
    }
    for (const LegendLine& line : legend_of(shown_, look_.level)) {
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", line.name.c_str());
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(line.value.c_str());
    }
    ImGui::EndTable();
  }

  void draw_keys(float width_px) {
    const Gui& gui = canvas_.gui;
    ImFont* font = gui.fonts().small;
    const float margin = font->FontSize;
    ImGui::SetCursorScreenPos(ImVec2(margin, gui.height() - keys_height() + 0.5F * margin));
    draw_text(kKeys, font, palette::kQuietText, width_px - 2.0F * margin, Align::kLeft);
  }

  [[nodiscard]] int picture_width() const {
    return canvas_.window.width_px() - static_cast<int>(panel_width());
  }

  /// Room for two lines.
  [[nodiscard]] float keys_height() const {
    return std::round(4.0F * canvas_.gui.fonts().small->FontSize);
  }

  [[nodiscard]] float panel_width() const {
    return std::round(19.0F * canvas_.gui.fonts().small->FontSize);
  }

  Canvas& canvas_;
  const ShownTree& shown_;
  TreePainter painter_;
  TreeLook look_;
  Orbit orbit_;
  bool dragging_{false};
  bool left_{false};
};

}  // namespace

void view_tree(Window& window, const ShownTree& shown, const TreeLook& look) {
  while_display_lasts([&] { TreeScreen(window.canvas(), shown, look).run(); });
}

}  // namespace impetus::inline viewers
