// SPDX-License-Identifier: MIT
#include "experiments/record/enclosure_image.hpp"

#include <algorithm>

namespace impetus::inline record {
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

}  // namespace impetus::inline record
