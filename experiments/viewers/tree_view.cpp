// SPDX-License-Identifier: MIT
#include "experiments/viewers/tree_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "experiments/viewers/panel.hpp"
#include "experiments/viewers/viewer_screen.hpp"
#include "experiments/window/display.hpp"
#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline viewers {
namespace {

/// What colours may tell, and how it is chosen.
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

/// A tree that is turned about, with its panel.
class TreeScreen final : public ViewerScreen {
 public:
  TreeScreen(Canvas& canvas, const ShownTree& shown, const TreeLook& look)
      : ViewerScreen(canvas), shown_(shown), painter_(shown), look_(look) {}

 private:
  void take(const SDL_Event& event) override {
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

  void press(SDL_Keycode key) {
    for (const ColourChoice& choice : kTreeColours) {
      look_.colour = choice.key == key ? choice.colour : look_.colour;
    }
    switch (key) {
      case SDLK_ESCAPE:
        leave();
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

  void paint() override {
    const int keys_px = static_cast<int>(keys_height());
    painter_.paint(look_, orbit_,
                   {0, keys_px, picture_width(), canvas_.window.height_px() - keys_px},
                   palette::kLightGrey);
  }

  void draw() override {
    draw_panel();
    ImFont* font = canvas_.gui.fonts().small;
    const float margin = font->FontSize;
    ImGui::SetCursorScreenPos(ImVec2(margin, canvas_.gui.height() - keys_height() + 0.5F * margin));
    draw_text(kKeys, font, palette::kQuietText, static_cast<float>(picture_width()) - 2.0F * margin,
              Align::kLeft);
  }

  void draw_panel() {
    const Panel panel(canvas_.gui, canvas_.gui.width() - panel_width());
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
    panel_box("mesh, through the volumes", look_.mesh, "Without it the volumes are solid. Key: M");
    panel_box("volumes", look_.volumes, "Key: V");
    if (ImGui::Button("View as at first")) {
      orbit_ = Orbit();
    }
    panel_tooltip("Key: R");
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
      panel_row(line.name, line.value);
    }
    ImGui::EndTable();
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

  const ShownTree& shown_;
  TreePainter painter_;
  TreeLook look_;
  Orbit orbit_;
  bool dragging_{false};
};

}  // namespace

void view_tree(Window& window, const ShownTree& shown, const TreeLook& look) {
  while_display_lasts([&] { TreeScreen(window.canvas(), shown, look).run(); });
}

std::vector<Pixels> pictures_of(const ShownTree& shown, const std::vector<TreeLook>& looks,
                                const PictureSize& size) {
  constexpr float kWhite = 1.0F;
  const GlWindow window(unseen_window({64, 64}));
  TreePainter painter(shown);
  MultisampledTarget drawn;
  const ReadableTarget averaged(size);
  std::vector<Pixels> pictures;
  for (const TreeLook& look : looks) {
    drawn.begin(size.width_px, size.height_px);
    painter.paint_here(look, Orbit(), size.width_px, size.height_px, kWhite);
    drawn.end_onto({0, 0, size.width_px, size.height_px}, averaged.framebuffer());
    pictures.push_back(averaged.read());
  }
  return pictures;
}

}  // namespace impetus::inline viewers
