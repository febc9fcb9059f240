// SPDX-License-Identifier: MIT
#include "experiments/viewers/picture_overlays.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/gaze/region_source.hpp"
#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline viewers {
namespace {

constexpr ImU32 kGazeColour = IM_COL32(20, 70, 30, 255);
constexpr ImU32 kHalo = IM_COL32(255, 255, 255, 150);  ///< sets it off from dark bodies
constexpr float kThickness = 1.5F;
constexpr float kTrailThickness = 3.0F;
constexpr ImU32 kLostColour = IM_COL32(132, 44, 24, 255);
constexpr float kRounding = 3.0F;

ImVec2 pixel(const WindowPoint& point) { return {point.x, point.y}; }

ImU32 faded_ink(int red, int green, int blue, double opacity) {
  return IM_COL32(red, green, blue, static_cast<int>(255.0 * opacity));
}

void draw_arrow(ImVec2 from, ImVec2 to, float thickness, ImU32 colour) {
  constexpr float kTooShortPx = 4.0F;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  draw.AddLine(from, to, colour, thickness);
  if (length < kTooShortPx) {
    return;  // towards the eye or away from it
  }
  const float head = std::min(9.0F, 0.5F * length);
  const ImVec2 back((from.x - to.x) / length * head, (from.y - to.y) / length * head);
  const ImVec2 side(-0.55F * back.y, 0.55F * back.x);
  draw.AddLine(to, to + back + side, colour, thickness);
  draw.AddLine(to, to + back - side, colour, thickness);
}

/// Small, on a ground of its own.
void write_beside(const WindowPoint& place, const char* words) {
  constexpr float kShareOfBody = 0.64F;
  ImFont* font = ImGui::GetFont();
  const float size_px = std::round(kShareOfBody * ImGui::GetFontSize());
  const ImVec2 from(std::round(place.x + 12.0F), std::round(place.y + 9.0F));
  const ImVec2 size = font->CalcTextSizeA(size_px, 1e6F, 0.0F, words);
  const ImVec2 margin(3.0F, 1.0F);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(from - margin, from + size + margin, kHalo, 2.0F);
  draw.AddText(font, size_px, from, kLostColour, words);
}

/// None: it goes away from the glass.
std::optional<Vector3> meeting_with_the_glass(const Viewer& viewer, const Vector3& direction) {
  const double ahead = -direction.dot(viewer.right.cross(viewer.up));
  constexpr double kAlong = 1e-9;
  if (ahead <= kAlong) {
    return std::nullopt;
  }
  return viewer.eye + viewer.screen.viewing_distance_m / ahead * direction;
}

/// How a key to colours is set, in letters' heights: the words' distance from their colour, and the
/// room above and below.
struct KeySetting {
  float indent;
  float above;
  float below;
  float widest_px;  ///< of a line; 0: each meaning has one of its own
};

void draw_key(const Gui& gui, const PixelArea& area, const std::vector<ColourMeaning>& meanings,
              const KeySetting& setting) {
  if (meanings.empty()) {
    return;
  }
  ImFont* font = gui.fonts().small;
  const float em = font->FontSize;
  const float inset_px = 0.5F * em;
  const float line_px = 1.35F * em;
  std::vector<ImVec2> places;
  ImVec2 at(0.0F, 0.0F);
  float widest_px = 0.0F;
  for (const ColourMeaning& each : meanings) {
    const float width_px = setting.indent * em + width_of(each.meaning, *font);
    if (at.x > 0.0F && at.x + width_px > setting.widest_px) {
      at = ImVec2(0.0F, at.y + line_px);
    }
    places.push_back(at);
    widest_px = std::max(widest_px, at.x + width_px);
    at.x += width_px + em;
  }
  const float left = static_cast<float>(area.left) + 2.0F * inset_px;
  const float bottom = gui.height() - static_cast<float>(area.bottom) - inset_px;
  const auto rows = static_cast<float>(meanings.size());
  const float highest =
      setting.widest_px > 0.0F ? bottom - at.y - line_px : bottom - rows * line_px;
  const float top = highest - (setting.above + setting.below) * em;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(ImVec2(left - inset_px, top), ImVec2(left + widest_px + inset_px, bottom),
                     palette::kSurface, kRounding);
  for (std::size_t i = 0; i < meanings.size(); ++i) {
    const BodyColour& colour = meanings[i].colour;
    const ImVec2 from = ImVec2(left, top + setting.above * em) + places[i];
    draw.AddRectFilled(
        from, from + ImVec2(em, em),
        ImGui::ColorConvertFloat4ToU32(ImVec4(colour[0], colour[1], colour[2], 1.0F)), 2.0F);
    write_at(from + ImVec2(setting.indent * em, 0.0F), meanings[i].meaning, font, palette::kText);
  }
}

}  // namespace

void mark_node_contact(const PictureMap& map, const Vector3& place, double opacity) {
  constexpr int kCorners = 8;
  if (const auto at = map.seen(place)) {
    ImGui::GetWindowDrawList()->AddCircleFilled(pixel(*at), 2.5F, faded_ink(217, 38, 28, opacity),
                                                kCorners);
  }
}

void mark_contact(const PictureMap& map, const Vector3& place, const Vector3& tip, double opacity) {
  const auto from = map.seen(place);
  const auto to = map.seen(tip);
  if (!from || !to) {
    return;
  }
  const ImU32 dark = faded_ink(20, 20, 20, opacity);
  draw_arrow(pixel(*from), pixel(*to), 5.0F, faded_ink(255, 255, 255, 0.75 * opacity));
  draw_arrow(pixel(*from), pixel(*to), 2.0F, dark);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddCircleFilled(pixel(*from), 6.0F, dark);
  draw.AddCircleFilled(pixel(*from), 4.8F, faded_ink(247, 211, 30, opacity));
}

void mark_arrow(const PictureMap& map, const Vector3& from, const Vector3& to, ImU32 ink) {
  const auto begin = map.seen(from);
  const auto end = map.seen(to);
  if (begin && end) {
    draw_arrow(pixel(*begin), pixel(*end), 4.5F, kHalo);
    draw_arrow(pixel(*begin), pixel(*end), 2.0F, ink);
  }
}

void mark_line(const PictureMap& map, const Vector3& from, const Vector3& to, ImU32 ink) {
  const auto begin = map.seen(from);
  const auto end = map.seen(to);
  if (begin && end) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddLine(pixel(*begin), pixel(*end), kHalo, 4.5F);
    draw.AddLine(pixel(*begin), pixel(*end), ink, 2.5F);
  }
}

void draw_gaze(const PictureMap& map, const Viewer& own, const ScreenPoint& fixation) {
  constexpr float kArm = 7.0F;
  const auto seen = map.seen(on_screen(own, fixation));
  if (!seen) {
    return;
  }
  const WindowPoint at = *seen;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto cross = [&](float arm, ImU32 colour, float thickness) {
    draw.AddLine(ImVec2(at.x - arm, at.y), ImVec2(at.x + arm + 1, at.y), colour, thickness);
    draw.AddLine(ImVec2(at.x, at.y - arm), ImVec2(at.x, at.y + arm + 1), colour, thickness);
  };
  cross(kArm + 1.5F, kHalo, kThickness + 3.0F);
  cross(kArm, kGazeColour, kThickness);
}

void draw_region(const PictureMap& map, const Viewer& own, const GazeRegion& region) {
  constexpr int kCorners = 72;
  if (region.radius_deg >= kWholeView_deg) {
    return;
  }
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Vector3 ahead = (on_screen(own, region.centre) - own.eye).normalized();
  const Vector3 across = ahead.cross(own.up).normalized();
  const Vector3 along = across.cross(ahead);
  const SineCosine radius = sine_cosine_deg(region.radius_deg);
  for (int corner = 0; corner < kCorners; ++corner) {
    const SineCosine round = sine_cosine_deg(360.0 * corner / kCorners);
    const Vector3 direction =
        radius.cosine * ahead + radius.sine * (round.cosine * across + round.sine * along);
    const auto on_glass = meeting_with_the_glass(own, direction);
    if (const auto point = on_glass ? map.seen(*on_glass) : std::nullopt) {
      draw.PathLineTo(pixel(*point));
    }
  }
  draw.PathStroke(kGazeColour, ImDrawFlags_Closed, kThickness);
}

void draw_trail(const PictureMap& map, const Viewer& own, const GazeTrail& trail) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  std::optional<WindowPoint> last;
  for (const TrailPoint& point : trail.points) {
    const auto at = map.seen(on_screen(own, point.at));
    const double freshness = std::clamp(1.0 - point.age_s / kTrail_s, 0.0, 1.0);
    const ImU32 ink = IM_COL32(20, 110, 40, static_cast<int>(40.0 + 190.0 * freshness));
    if (at && last && point.joined) {
      draw.AddLine(pixel(*last), pixel(*at), ink, kTrailThickness);
    }
    if (at) {
      draw.AddCircleFilled(pixel(*at), 0.5F * kTrailThickness + 0.7F, ink);
    }
    last = at;
  }
  if (trail.lost != GazeLoss::kNone && last) {
    write_beside(*last, word_of(trail.lost));
  }
}

void draw_colour_legend(const Gui& gui, const PixelArea& area,
                        const std::vector<ColourMeaning>& meanings) {
  draw_key(gui, area, meanings, {1.5F, 0.5F, 0.5F, 0.0F});
}

void draw_colour_line(const Gui& gui, const PixelArea& area,
                      const std::vector<ColourMeaning>& meanings) {
  const float widest_px = static_cast<float>(area.width) - 2.0F * gui.fonts().small->FontSize;
  draw_key(gui, area, meanings, {1.3F, 0.25F, 0.0F, widest_px});
}

void draw_badge(const Gui& gui, const PixelArea& area, const std::string& words) {
  if (words.empty()) {
    return;
  }
  ImFont* font = gui.fonts().small;
  const float inset_px = 0.5F * font->FontSize;
  const ImVec2 corner(static_cast<float>(area.left) + inset_px,
                      gui.height() - static_cast<float>(area.bottom + area.height) + inset_px);
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e6F, 0.0F, words.c_str());
  ImGui::GetWindowDrawList()->AddRectFilled(
      corner, corner + size + ImVec2(2.0F * inset_px, inset_px), palette::kSurface, kRounding);
  write_at(corner + ImVec2(inset_px, 0.5F * inset_px), words, font, palette::kText);
}

}  // namespace impetus::inline viewers
