// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_picture.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/record/lab_screen.hpp"
#include "experiments/viewers/picture_overlays.hpp"
#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline viewers {
namespace {

Viewer participant_of(const ReplayMoment& moment) {
  return turned_viewer(moment.replay->viewer, moment.replay->turn, moment.time_s);
}

void draw_contacts(const ReplayMoment& moment, const PictureMap& map) {
  double largest_m = 0.0;
  for (const auto& tree : moment.replay->trees) {
    largest_m = std::max(largest_m, tree->bounding_radius_m());
  }
  for (const FadingContact& contact :
       contacts_at(*moment.replay, step_at(*moment.replay, moment.time_s))) {
    const TouchPoint& touch = contact.touch;
    mark_contact(map, touch.point, touch.point + kArrowShare * largest_m * touch.normal,
                 contact.freshness);
  }
}

/// The raw samples of the last moments, and what the present step was told.
void draw_gaze_of(const ReplayMoment& moment, const PictureMap& map) {
  const Viewer own = participant_of(moment);
  const GazeTrail trail = trail_at(moment.replay->samples, moment.time_s);
  draw_trail(map, own, trail);
  const GazeInput gaze = gaze_of_step(*moment.replay, step_at(*moment.replay, moment.time_s));
  if (gaze.fixation) {
    draw_gaze(map, own, *gaze.fixation);
  }
  if (gaze.region) {
    draw_region(map, own, *gaze.region);
  }
}

}  // namespace

float screen_margin(const Gui& gui) { return std::round(0.018F * gui.height()); }

float content_width(const Gui& gui) { return gui.width() - 2.0F * screen_margin(gui); }

std::vector<PixelArea> pane_areas(const Panes& panes, const Gui& gui,
                                  const ScreenGeometry& screen) {
  const float margin = screen_margin(gui);
  const double gap_px = 0.5 * margin;
  const double wide_px = (content_width(gui) - (panes.count - 1) * gap_px) / panes.count;
  const double high_px = gui.height() - panes.header_px - panes.footer_px - 0.5F * margin;
  const PicturePixels largest = largest_picture(screen, wide_px, high_px);
  PixelArea area;
  area.width = largest.width;
  area.height = largest.height;
  area.bottom = static_cast<int>(panes.footer_px + 0.5F * margin + (high_px - area.height) / 2);
  const double whole_px = panes.count * area.width + (panes.count - 1) * gap_px;
  std::vector<PixelArea> areas;
  for (int pane = 0; pane < panes.count; ++pane) {
    area.left = static_cast<int>((gui.width() - whole_px) / 2 + pane * (area.width + gap_px));
    areas.push_back(area);
  }
  return areas;
}

void ReplayPicture::paint(const ReplayMoment& moment, const ReplayLook& look) {
  const ReplayView& replay = *moment.replay;
  const std::vector<BodyDetail> details = details_at(replay, step_at(replay, moment.time_s));
  Picture picture;
  picture.bodies = bodies_at(replay, moment.time_s);
  picture.enclosure = replay.enclosure;
  picture.appearance = replay.appearance;
  picture.viewer = look.camera.seen_from(participant_of(moment));
  std::vector<ColouredVolume> volumes;
  if (look.volumes) {
    std::vector<int> levels;
    levels.reserve(details.size());
    for (const BodyDetail& detail : details) {
      levels.push_back(detail.level);
    }
    volumes = volumes_.of(replay.trees, levels, picture.bodies);
  }
  colour_bodies(picture.bodies, details, look.colours, replay.finest_level);
  canvas_.painter.paint(picture, moment.area, volumes);
}

void ReplayPicture::draw_over(const ReplayMoment& moment, const ReplayLook& look) const {
  const PictureMap map(look.camera.seen_from(participant_of(moment)), moment.area,
                       canvas_.window.height_px());
  push_clip_rect(moment.area, canvas_.gui.height());
  if (look.contacts) {
    draw_contacts(moment, map);
  }
  if (look.gaze) {
    draw_gaze_of(moment, map);
  }
  draw_colour_line(canvas_.gui, moment.area,
                   meanings_of(look.colours, moment.replay->finest_level));
  draw_badge(canvas_.gui, moment.area, moment.words);
  ImGui::PopClipRect();
}

}  // namespace impetus::inline viewers
