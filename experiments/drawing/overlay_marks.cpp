// SPDX-License-Identifier: MIT
#include "experiments/drawing/overlay_marks.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline drawing {
namespace {

ImU32 ink(int red, int green, int blue, double opacity) {
  return IM_COL32(red, green, blue, static_cast<int>(255.0 * opacity));
}

void draw_arrow(ImDrawList& draw, ImVec2 from, ImVec2 to, float thickness, ImU32 colour) {
  constexpr float kTooShortPx = 4.0F;
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  draw.AddLine(from, to, colour, thickness);
  if (length < kTooShortPx) {
    return;  // towards the eye or away from it
  }
  const float head = std::min(9.0F, 0.5F * length);
  const ImVec2 back((from.x - to.x) / length * head, (from.y - to.y) / length * head);
  const ImVec2 side(-0.55F * back.y, 0.55F * back.x);
  draw.AddLine(to, ImVec2(to.x + back.x + side.x, to.y + back.y + side.y), colour, thickness);
  draw.AddLine(to, ImVec2(to.x + back.x - side.x, to.y + back.y - side.y), colour, thickness);
}

}  // namespace

void mark_node_contact(ImDrawList& draw, const PictureMap& map, const Vector3& place,
                       double opacity) {
  constexpr int kCorners = 8;
  if (const auto at = map.seen(place)) {
    draw.AddCircleFilled(pixel(*at), 2.5F, ink(217, 38, 28, opacity), kCorners);
  }
}

void mark_contact(ImDrawList& draw, const PictureMap& map, const Vector3& place, const Vector3& tip,
                  double opacity) {
  const auto from = map.seen(place);
  const auto to = map.seen(tip);
  if (!from || !to) {
    return;
  }
  const ImU32 dark = ink(20, 20, 20, opacity);
  const ImU32 halo = ink(255, 255, 255, 0.75 * opacity);
  draw_arrow(draw, pixel(*from), pixel(*to), 5.0F, halo);
  draw_arrow(draw, pixel(*from), pixel(*to), 2.0F, dark);
  draw.AddCircleFilled(pixel(*from), 6.0F, dark);
  draw.AddCircleFilled(pixel(*from), 4.8F, ink(247, 211, 30, opacity));
}

void mark_arrow(ImDrawList& draw, const PictureMap& map, const Vector3& from, const Vector3& to,
                ImU32 colour) {
  const auto begin = map.seen(from);
  const auto end = map.seen(to);
  if (begin && end) {
    draw_arrow(draw, pixel(*begin), pixel(*end), 4.5F, IM_COL32(255, 255, 255, 150));
    draw_arrow(draw, pixel(*begin), pixel(*end), 2.0F, colour);
  }
}

}  // namespace impetus::inline drawing
