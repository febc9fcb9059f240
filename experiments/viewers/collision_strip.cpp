// SPDX-License-Identifier: MIT
#include "experiments/viewers/collision_strip.hpp"

#include <algorithm>
#include <string>

#include "experiments/drawing/scene_painter.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/viewers/picture_overlays.hpp"
#include "experiments/viewers/volume_levels.hpp"
#include "experiments/window/gl_window.hpp"
#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline viewers {
namespace {

constexpr double kStripRoom = 1.08;
constexpr ImU32 kGoingInk = IM_COL32(24, 60, 120, 255);

/// The pictures of one collision.
class StripDrawing {
 public:
  StripDrawing(const CollisionByLevel& collision, const StagedScene& scene, const PictureSize& size)
      : collision_(collision),
        scene_(scene),
        size_(size),
        window_(unseen_window(size)),
        gui_(window_),
        target_(size) {
    fit_view();
  }

  Pixels draw() {
    std::vector<Pixels> rows;
    for (const LevelCollision& row : collision_.levels) {
      rows.push_back(beside_each_other(
          {cell(row, kBeforeContact), cell(row, kAtContact), cell(row, kAfterContact)}));
    }
    return below_each_other(rows);
  }

 private:
  /// A screen that holds the bodies of every picture, above the words.
  void fit_view() {
    const Viewer own = scene_.viewer_at_time(collision_.levels.back().moments[kAtContact].time_s);
    const Vector3 towards_eye = own.eye.normalized();
    Eigen::AlignedBox2d seen;
    double depth_m = 0.0;
    for (const LevelCollision& row : collision_.levels) {
      for (const CollisionMoment& moment : row.moments) {
        for (std::size_t body = 0; body < moment.poses.size(); ++body) {
          const double radius_m = model(body).tree->bounding_radius_m();
          const Vector3& place = moment.poses[body].position;
          const Eigen::Vector2d middle(place.dot(own.right), place.dot(own.up));
          seen.extend(middle - Eigen::Vector2d::Constant(radius_m));
          seen.extend(middle + Eigen::Vector2d::Constant(radius_m));
          depth_m = place.dot(towards_eye);
          fastest_m_s_ = std::max(fastest_m_s_, moment.velocities[body].norm());
        }
      }
    }
    const double words_px = words_height_px();
    const double room_px = std::max(1.0, size_.height_px - words_px);
    const double m_per_px =
        kStripRoom * std::max(seen.sizes().x() / size_.width_px, seen.sizes().y() / room_px);
    const double below_m = 0.5 * words_px * m_per_px;
    centre_ = seen.center().x() * own.right + (seen.center().y() - below_m) * own.up +
              depth_m * towards_eye;
    viewer_ = own;
    viewer_.screen.width_m = m_per_px * size_.width_px;
    viewer_.screen.height_m = m_per_px * size_.height_px;
    viewer_.screen.width_px = size_.width_px;
    viewer_.screen.height_px = size_.height_px;
    arrow_m_ = 0.2 * viewer_.screen.height_m;
  }

  [[nodiscard]] const BodyModel& model(std::size_t body) const {
    return scene_.world.models()[collision_.bodies[body]];
  }

  [[nodiscard]] Pose moved(Pose pose) const {
    pose.position -= centre_;
    return pose;
  }

  Pixels cell(const LevelCollision& row, CollisionMomentName name) {
    const CollisionMoment& moment = row.moments[name];
    Picture picture;
    picture.viewer = viewer_;
    for (std::size_t body = 0; body < moment.poses.size(); ++body) {
      picture.bodies.push_back({moved(moment.poses[body]), scene_.looks[collision_.bodies[body]]});
    }
    const PixelArea area{0, 0, size_.width_px, size_.height_px};
    painter_.paint_onto(target_.framebuffer(), picture, area, shells(row, name));
    target_.draw_here();
    gui_.begin();
    draw_marks(row, name, PictureMap(viewer_, area, size_.height_px));
    gui_.end();
    return target_.read();
  }

  /// All volumes of the level before contact, those that touch at contact.
  std::vector<ColouredVolume> shells(const LevelCollision& row, CollisionMomentName name) {
    std::vector<ColouredVolume> volumes;
    if (name == kBeforeContact) {
      const CollisionMoment& moment = row.moments[name];
      for (std::size_t body = 0; body < moment.poses.size(); ++body) {
        for (const RoundedBox& box : volumes_at_level(*model(body).tree, row.level)) {
          volumes.push_back({posed(box, moved(moment.poses[body])), kVolumeColour});
        }
      }
    } else if (name == kAtContact) {
      for (RoundedBox box : row.touching) {
        box.centre -= centre_;
        volumes.push_back({box, kVolumeColour});
      }
    }
    return volumes;
  }

  void draw_marks(const LevelCollision& row, CollisionMomentName name, const PictureMap& map) {
    const CollisionMoment& moment = row.moments[name];
    if (name == kAtContact) {
      draw_contacts(row, map);
    } else {
      for (std::size_t body = 0; body < moment.poses.size(); ++body) {
        const Vector3 from = moved(moment.poses[body]).position;
        const double scale = fastest_m_s_ > 0.0 ? arrow_m_ / fastest_m_s_ : 0.0;
        mark_arrow(map, from, from + scale * moment.velocities[body], kGoingInk);
      }
    }
    write_below(words(row, name));
  }

  void draw_contacts(const LevelCollision& row, const PictureMap& map) const {
    for (const Vector3& place : row.node_contacts) {
      mark_node_contact(map, place - centre_, 1.0);
    }
    for (const TouchPoint& contact : row.contacts) {
      const Vector3 place = contact.point - centre_;
      mark_contact(map, place, place + 0.7 * arrow_m_ * contact.normal, 1.0);
    }
  }

  static std::string words(const LevelCollision& row, CollisionMomentName name) {
    const double apart_s = row.moments[name].time_s - row.moments[kAtContact].time_s;
    switch (name) {
      case kBeforeContact:
        return printed("level %d\n%.0f ms before contact\nbounds reach at most %.2f mm beyond",
                       row.level, -1e3 * apart_s, 1e3 * row.fit_error_m);
      case kAtContact:
        return printed(
            "at %.3f s: contacts of nodes %zu, kept %zu\ngap %.2f mm, %.1f′ in the "
            "scene\nnormal %.1f° off the finest level's",
            row.moments[name].time_s, row.node_contacts.size(), row.contacts.size(),
            1e3 * row.gap_m, row.gap_arcmin, row.normal_off_deg);
      default:
        return printed("%.0f ms after contact", 1e3 * apart_s);
    }
  }

  [[nodiscard]] float words_height_px() const {
    constexpr float kLines = 3.8F;
    return kLines * gui_.fonts().small->FontSize;
  }

  /// On a band below the picture, as wide as it is.
  void write_below(const std::string& text) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImFont* font = gui_.fonts().small;
    const float inset = 0.4F * font->FontSize;
    const auto width = static_cast<float>(size_.width_px);
    const auto height = static_cast<float>(size_.height_px);
    const float top = height - words_height_px();
    draw.AddRectFilled(ImVec2(0, top), ImVec2(width, height), palette::kSurface);
    draw.AddRect(ImVec2(0, 0), ImVec2(width, height), palette::kLine);
    write_at(ImVec2(inset, top + inset), text, font, palette::kText);
  }

  const CollisionByLevel& collision_;
  const StagedScene& scene_;
  PictureSize size_;
  Vector3 centre_{Vector3::Zero()};  ///< in the middle of every picture
  GlWindow window_;
  Gui gui_;
  ScenePainter painter_;
  ReadableTarget target_;
  Viewer viewer_;
  double fastest_m_s_{0.0};
  double arrow_m_{0.0};  ///< of the fastest body
};

}  // namespace

Pixels strip_of(const CollisionByLevel& collision, const StagedScene& scene,
                const PictureSize& size) {
  return StripDrawing(collision, scene, size).draw();
}

}  // namespace impetus::inline viewers
