// SPDX-License-Identifier: MIT
#include "experiments/viewers/preview_overlays.hpp"

#include <algorithm>

#include "experiments/viewers/picture_overlays.hpp"

namespace impetus::inline viewers {
namespace {

/// From body to body, or to the walls that a body reaches beyond.
void draw_pair(const PreviewRun& run, const ScheduledPair& pair, const PictureMap& map,
               const std::vector<PosedBody>& bodies) {
  const auto place_of = [&](std::int32_t body) {
    return bodies[static_cast<std::size_t>(body)].pose.position;
  };
  const BodyColour rgb = colour_of_list(pair.list);
  const ImU32 ink = ImGui::ColorConvertFloat4ToU32(ImVec4(rgb[0], rgb[1], rgb[2], 1.0F));
  const Vector3 from = place_of(pair.pair.a);
  if (!is_wall(pair.pair.b)) {
    mark_line(map, from, place_of(pair.pair.b), ink);
    return;
  }
  const World& world = run.scene().world;
  const Enclosure& walls = *world.settings().enclosure;
  const BodyModel& model = world.models()[static_cast<std::size_t>(pair.pair.a)];
  const Sphere bound{from, model.tree->bounding_radius_m()};
  for (int wall = 0; wall < kWallCount; ++wall) {
    if (reach_beyond(walls, wall, bound) >= 0.0) {
      mark_line(map, from, touch_wall(walls, wall, bound).point, ink);
    }
  }
}

void draw_contacts(const PreviewRun& run, const PictureMap& map) {
  for (const ShownContact& contact : run.node_contacts()) {
    mark_node_contact(map, contact.touch.point, run.freshness(contact));
  }
  double largest_m = 0.0;
  for (const BodyModel& body : run.scene().world.models()) {
    largest_m = std::max(largest_m, body.tree->bounding_radius_m());
  }
  for (const ShownContact& contact : run.contacts()) {
    const TouchPoint& touch = contact.touch;
    mark_contact(map, touch.point, touch.point + kArrowShare * largest_m * touch.normal,
                 run.freshness(contact));
  }
}

}  // namespace

PreviewOverlays overlays_for(const StagedScene& scene) {
  PreviewOverlays overlays;
  if (is_crowd(scene.looks.size())) {
    overlays.pairs = overlays.contacts = false;
  }
  return overlays;
}

void draw_overlays(const PreviewRun& run, const PreviewOverlays& overlays, const PictureMap& map,
                   const std::vector<PosedBody>& bodies) {
  if (!overlays.shown) {
    return;
  }
  if (overlays.pairs) {
    // Those of high priority last, so that they stay visible.
    for (auto pair = run.pairs().rbegin(); pair != run.pairs().rend(); ++pair) {
      draw_pair(run, *pair, map, bodies);
    }
  }
  if (overlays.contacts) {
    draw_contacts(run, map);
  }
  if (overlays.gaze && run.gaze()) {
    draw_gaze(map, map.viewer(), *run.gaze());
  }
  if (overlays.gaze && run.region()) {
    draw_region(map, map.viewer(), *run.region());
  }
}

}  // namespace impetus::inline viewers
