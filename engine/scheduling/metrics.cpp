// SPDX-License-Identifier: MIT
#include "engine/scheduling/metrics.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/numerics/trigonometry.hpp"

namespace impetus {
namespace {

class Distance final : public PriorityMetric {
 public:
  Distance() : PriorityMetric(Urgent::kSmall) {}
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& /*fixation*/) const override {
    return (0.5 * (bounds.a.centre + bounds.b.centre) - viewer.eye).norm();
  }
};

/// The angle between opposite tangents from the eye: 2 asin(R / d).
double spanned_deg(const Sphere& sphere, const Viewer& viewer) {
  const double square = (sphere.centre - viewer.eye).squaredNorm();
  const double tangent_square = square - sphere.radius_m * sphere.radius_m;
  return tangent_square > 0.0 ? degrees(2.0 * atan2_rad(sphere.radius_m, std::sqrt(tangent_square)))
                              : 180.0;
}

class Size final : public PriorityMetric {
 public:
  Size() : PriorityMetric(Urgent::kLarge) {}
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& /*fixation*/) const override {
    return 0.5 * (spanned_deg(bounds.a, viewer) + spanned_deg(bounds.b, viewer));
  }
};

/// Angular speed at the eye: ‖X × V‖ / ‖X‖², X from the eye.
double angular_speed_deg_s(const Vector3& place, const Vector3& velocity, const Viewer& viewer) {
  const Vector3 from_eye = place - viewer.eye;
  return degrees(from_eye.cross(velocity).norm() / from_eye.squaredNorm());
}

class Velocity final : public PriorityMetric {
 public:
  Velocity() : PriorityMetric(Urgent::kSmall) {}
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& /*fixation*/) const override {
    return 0.5 * (angular_speed_deg_s(bounds.a.centre, bounds.velocity_a, viewer) +
                  angular_speed_deg_s(bounds.b.centre, bounds.velocity_b, viewer));
  }
};

class Eccentricity final : public PriorityMetric {
 public:
  Eccentricity() : PriorityMetric(Urgent::kSmall) {}
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& fixation) const override {
    const Vector3 looked_at = on_screen(viewer, fixation.value_or(ScreenPoint{}));
    return visual_angle_deg(viewer, collision_place(bounds), looked_at);
  }
};

class ProjectedGap final : public PriorityMetric {
 public:
  ProjectedGap() : PriorityMetric(Urgent::kLarge) {}
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& /*fixation*/) const override {
    const double distance_m = (collision_place(bounds) - viewer.eye).norm();
    return degrees(2.0 * atan2_rad(0.5 * bounds.fit_error_m, distance_m));
  }
};

using Metric = std::shared_ptr<const PriorityMetric>;

template <typename T>
Metric made() {
  return std::make_shared<const T>();
}

struct NamedMetric {
  std::string_view name;
  Metric (*make)();
};

constexpr NamedMetric kMetrics[] = {{"distance", made<Distance>},
                                    {"eccentricity", made<Eccentricity>},
                                    {"projected-gap", made<ProjectedGap>},
                                    {"size", made<Size>},
                                    {"velocity", made<Velocity>}};

}  // namespace

std::shared_ptr<const PriorityMetric> make_metric(std::string_view name,
                                                  const MetricOptions& /*options*/) {
  std::string known;
  for (const NamedMetric& metric : kMetrics) {
    if (metric.name == name) {
      return metric.make();
    }
    known += (known.empty() ? "" : ", ") + std::string(metric.name);
  }
  throw std::invalid_argument("scheduler: expected one of " + known + ", got \"" +
                              std::string(name) + "\"");
}

std::vector<std::string_view> metric_names() {
  std::vector<std::string_view> names;
  for (const NamedMetric& metric : kMetrics) {
    names.push_back(metric.name);
  }
  return names;
}

}  // namespace impetus
