// SPDX-License-Identifier: MIT
#include "experiments/viewers/preview_overlays.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "experiments/drawing/overlay_marks.hpp"
#include "experiments/viewers/gaze_overlay.hpp"

namespace impetus::inline viewers {
namespace {

ImU32 colour(const std::array<float, 3>& rgb, double opacity) {
  return ImGui::ColorConvertFloat4ToU32(
      ImVec4(rgb[0], rgb[1], rgb[2], static_cast<float>(opacity)));
}

class OverlayDrawing {
 public:
  OverlayDrawing(const PreviewRun& run, const PictureMap& map)
      : run_(run), map_(map), draw_(*ImGui::GetWindowDrawList()) {}

  void pair(const ScheduledPair& pair, const std::vector<PosedBody>& bodies) {
    const Vector3& from = bodies[static_cast<std::size_t>(pair.pair.a)].pose.position;
    if (!is_wall(pair.pair.b)) {
      line(from, bodies[static_cast<std::size_t>(pair.pair.b)].pose.position, pair.list);
      return;
    }
    const Enclosure& walls = *run_.scene().world.settings().enclosure;
    const BodyModel& model = run_.scene().world.models()[static_cast<std::size_t>(pair.pair.a)];
    const Sphere bound{from, model.tree->bounding_radius_m()};
    for (int wall = 0; wall < kWallCount; ++wall) {
      if (reach_beyond(walls, wall, bound) >= 0.0) {
        line(from, touch_wall(walls, wall, bound).point, pair.list);
      }
    }
  }

  void contact(const ShownContact& contact, double arrow_m) {
    const Vector3& place = contact.touch.point;
    mark_contact(draw_, map_, place, place + arrow_m * contact.touch.normal,
                 run_.freshness(contact));
  }

  void node_contact(const ShownContact& contact) {
    mark_node_contact(draw_, map_, contact.touch.point, run_.freshness(contact));
  }

 private:
  void line(const Vector3& from, const Vector3& to, int list) {
    const auto begin = map_.seen(from);
    const auto end = map_.seen(to);
    if (begin && end) {
      draw_.AddLine(pixel(*begin), pixel(*end), IM_COL32(255, 255, 255, 150), 4.5F);
      draw_.AddLine(pixel(*begin), pixel(*end), colour(colour_of_list(list), 1.0), 2.5F);
    }
  }

  const PreviewRun& run_;
  const PictureMap& map_;
  ImDrawList& draw_;
};

double arrow_length_m(const PreviewRun& run) {
  double largest_m = 0.0;
  for (const BodyModel& body : run.scene().world.models()) {
    largest_m = std::max(largest_m, body.tree->bounding_radius_m());
  }
  return kArrowShare * largest_m;
}

}  // namespace

PreviewOverlays overlays_for(const StagedScene& scene) {
  PreviewOverlays overlays;
  if (is_crowd(scene.looks.size())) {
    overlays.pairs = overlays.contacts = false;
  }
  return overlays;
}

std::vector<PosedBody> shown_bodies(const PreviewRun& run, const PreviewOverlays& overlays) {
  std::vector<PosedBody> bodies = run.bodies();
  colour_bodies(bodies, run.details(), overlays.colours, run.settings().finest_level);
  return bodies;
}

void draw_overlays(const PreviewRun& run, const PreviewOverlays& overlays, const PictureMap& map,
                   const std::vector<PosedBody>& bodies) {
  if (!overlays.shown) {
    return;
  }
  OverlayDrawing drawing(run, map);
  if (overlays.pairs) {
    // Those of high priority last, so that they stay visible.
    for (auto pair = run.pairs().rbegin(); pair != run.pairs().rend(); ++pair) {
      drawing.pair(*pair, bodies);
    }
  }
  if (overlays.contacts) {
    for (const ShownContact& contact : run.node_contacts()) {
      drawing.node_contact(contact);
    }
    const double arrow_m = arrow_length_m(run);
    for (const ShownContact& contact : run.contacts()) {
      drawing.contact(contact, arrow_m);
    }
  }
  if (overlays.gaze && run.gaze()) {
    draw_gaze(map, map.viewer(), *run.gaze());
  }
  if (overlays.gaze && run.region()) {
    draw_region(map, map.viewer(), *run.region());
  }
}

}  // namespace impetus::inline viewers
