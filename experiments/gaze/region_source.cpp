// SPDX-License-Identifier: MIT
#include "experiments/gaze/region_source.hpp"

#include <algorithm>

namespace impetus::inline gaze {
namespace {

/// Twice the area of the triangle; positive when it turns left.
double turn(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
  return (b.x_m - a.x_m) * (c.y_m - a.y_m) - (b.y_m - a.y_m) * (c.x_m - a.x_m);
}

/// The convex hull, anticlockwise. (Andrew 1979)
std::vector<ScreenPoint> convex_hull(std::vector<ScreenPoint> points) {
  std::sort(points.begin(), points.end(), [](const ScreenPoint& a, const ScreenPoint& b) {
    return a.x_m != b.x_m ? a.x_m < b.x_m : a.y_m < b.y_m;
  });
  std::vector<ScreenPoint> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const ScreenPoint& point : points) {
      while (hull.size() >= first + 2 &&
             turn(hull[hull.size() - 2], hull[hull.size() - 1], point) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();  // the first of the other side
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

std::vector<ScreenPoint> whole_screen(const ScreenGeometry& screen) {
  const double x_m = 0.5 * screen.width_m;
  const double y_m = 0.5 * screen.height_m;
  return {{-x_m, -y_m}, {x_m, -y_m}, {x_m, y_m}, {-x_m, y_m}};
}

std::vector<ScreenPoint> outline_of(const std::optional<Enclosure>& enclosure,
                                    const Viewer& viewer) {
  if (!enclosure) {
    return whole_screen(viewer.screen);
  }
  std::vector<ScreenPoint> corners;
  for (int index = 0; index < 8; ++index) {
    const std::optional<ScreenPoint> image = projected(viewer, corner(*enclosure, index));
    if (!image) {
      return whole_screen(viewer.screen);
    }
    corners.push_back(*image);
  }
  return convex_hull(std::move(corners));
}

}  // namespace

EnclosureImage::EnclosureImage(const std::optional<Enclosure>& enclosure, const Viewer& viewer)
    : viewer_(viewer), outline_(outline_of(enclosure, viewer)) {
  least_ = greatest_ = outline_.front();
  for (const ScreenPoint& corner : outline_) {
    least_ = {std::min(least_.x_m, corner.x_m), std::min(least_.y_m, corner.y_m)};
    greatest_ = {std::max(greatest_.x_m, corner.x_m), std::max(greatest_.y_m, corner.y_m)};
  }
}

bool EnclosureImage::contains(const ScreenPoint& point) const {
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    if (turn(outline_[i], outline_[(i + 1) % outline_.size()], point) < 0.0) {
      return false;
    }
  }
  return true;
}

ScreenPoint EnclosureImage::in_frame(double across, double up) const {
  return {least_.x_m + across * (greatest_.x_m - least_.x_m),
          least_.y_m + up * (greatest_.y_m - least_.y_m)};
}

ScreenPoint EnclosureImage::uniform_point(RandomStream& stream) const {
  while (true) {
    const double across = stream.uniform();
    const ScreenPoint point = in_frame(across, stream.uniform());
    if (contains(point)) {
      return point;
    }
  }
}

double EnclosureImage::covered_share(const GazeRegion& region) const {
  constexpr int kPointsAcross = 32;
  const Vector3 centre = on_screen(viewer_, region.centre);
  int image = 0;
  int covered = 0;
  for (int row = 0; row < kPointsAcross; ++row) {
    for (int column = 0; column < kPointsAcross; ++column) {
      const ScreenPoint point =
          in_frame((column + 0.5) / kPointsAcross, (row + 0.5) / kPointsAcross);
      if (contains(point)) {
        ++image;
        covered += visual_angle_deg(viewer_, on_screen(viewer_, point), centre) <= region.radius_deg
                       ? 1
                       : 0;
      }
    }
  }
  return static_cast<double>(covered) / image;
}

RegionSource::RegionSource(const StagedScene& scene, std::uint64_t seed)
    : rule_(scene.region),
      recorded_gaze_(scene.recorded_gaze),
      enclosure_(scene.world.settings().enclosure),
      viewer_(scene.viewer),
      turn_(scene.turn),
      step_hz_(scene.step_hz),
      image_(scene.world.settings().enclosure, scene.viewer),
      places_(seed, "random region") {}

std::optional<GazeRegion> RegionSource::at(std::int64_t step, const Fixation& fixation) {
  switch (rule_.kind) {
    case RegionKind::kAllGood:
      return GazeRegion{{}, kWholeView_deg};
    case RegionKind::kTracked:
      return fixation ? std::optional(GazeRegion{*fixation, rule_.radius_deg}) : std::nullopt;
    case RegionKind::kRandom:
      if ((step - 1) % rule_.renewal_steps == 0) {
        if (turn_.rate_deg_s != 0.0) {
          const double time_s = static_cast<double>(step) / step_hz_;
          image_ = EnclosureImage(enclosure_, turned_viewer(viewer_, turn_, time_s));
        }
        place_ = image_.uniform_point(places_);
      }
      return GazeRegion{place_, rule_.radius_deg};
    case RegionKind::kRecorded: {
      const Fixation then = recorded_gaze_ ? recorded_gaze_->at(step) : std::nullopt;
      return then ? std::optional(GazeRegion{*then, rule_.radius_deg}) : std::nullopt;
    }
    case RegionKind::kFixed:
      return GazeRegion{rule_.point, rule_.radius_deg};
    default:
      return std::nullopt;
  }
}

std::optional<double> mean_covered_share(const StagedScene& scene,
                                         const std::vector<StepRecord>& steps) {
  EnclosureImage image(scene.world.settings().enclosure, scene.viewer);
  const bool turns = scene.turn.rate_deg_s != 0.0;
  double sum = 0.0;
  std::int64_t count = 0;
  double share = 0.0;
  const StepRecord* measured = nullptr;
  for (const StepRecord& step : steps) {
    if (!step.gaze.region || step.gaze.region->radius_deg >= kWholeView_deg) {
      continue;
    }
    if (turns) {
      const double time_s = static_cast<double>(step.step) / scene.step_hz;
      image = EnclosureImage(scene.world.settings().enclosure, scene.viewer_at_time(time_s));
    }
    if (turns || measured == nullptr ||
        !(measured->gaze.region->centre == step.gaze.region->centre)) {
      share = image.covered_share(*step.gaze.region);
      measured = &step;
    }
    sum += share;
    ++count;
  }
  return count > 0 ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
}

}  // namespace impetus::inline gaze
