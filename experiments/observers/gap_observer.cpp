// SPDX-License-Identifier: MIT
#include "experiments/observers/gap_observer.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/run/collision_truth.hpp"

namespace impetus::inline observers {

namespace {

constexpr const char* kThresholds = "gap-thresholds";

/// The same where thresholds are sought: crowd and t are in the file.
class ThresholdsObserver final : public GapObserver {
 public:
  ThresholdsObserver(const GapParameters& parameters, const Birth& birth)
      : GapObserver(parameters, birth, kThresholds) {}
};

std::vector<ParameterEntry> thresholds_entries(GapParameters& gap) {
  std::vector<ParameterEntry> entries = gap_entries(gap);
  entries.push_back({"crowding_per_body", 0.0, kAny, &gap.crowding_per_body,
                     "Share by which the threshold rises for each body beyond two."});
  entries.push_back({"threshold_sd_log10", 0.0, kAny, &gap.threshold_sd_log10,
                     "Spread of the threshold between participants, of its decimal logarithm."});
  return entries;
}

/// What a gap, and how well it is seen, depends on.
const Attention& gap_attention() {
  static const Attention attention{
      "gaps between bodies that collide, where and how fast they do",
      {"level", "gap", "tree", "viewer", "speed", "velocity", "at_deg", "distractors", "count",
       "schedule", "region", "budget", "shape"}};
  return attention;
}

}  // namespace

double visible_frequency_at(double speed_deg_s) {
  if (speed_deg_s <= 0.825) {
    return 60.0;
  }
  return speed_deg_s <= 118.3 ? 57.69 - 27.78 * std::log10(speed_deg_s) : 0.1;
}

double gap_threshold_arcmin(double at_rest_arcmin, double eccentricity_deg, double speed_deg_s) {
  return at_rest_arcmin * (1.0 + eccentricity_deg / 2.3) *
         (60.0 / visible_frequency_at(speed_deg_s));
}

GapObserver::GapObserver(const GapParameters& parameters, const Birth& birth,
                         const std::string& study)
    : RatingObserver(parameters, birth, study), parameters_(parameters) {
  draw_traits();
  if (parameters_.threshold_sd_log10 > 0.0) {
    threshold_log10_ = parameters_.threshold_sd_log10 * normal();
  }
}

double GapObserver::threshold_arcmin(double eccentricity_deg, double speed_deg_s,
                                     std::size_t bodies) const {
  const double crowd = std::max(0.0, static_cast<double>(bodies) - 2.0);
  return gap_threshold_arcmin(parameters_.threshold_arcmin, eccentricity_deg, speed_deg_s) *
         std::pow(10.0, threshold_log10_) * (1.0 + parameters_.crowding_per_body * crowd);
}

double GapObserver::seen_gap(double visible_arcmin, double eccentricity_deg, double speed_deg_s,
                             std::size_t bodies) const {
  if (visible_arcmin <= 0.0) {
    return parameters_.guess_rate;
  }
  const double threshold = threshold_arcmin(eccentricity_deg, speed_deg_s, bodies);
  return parameters_.guess_rate +
         (1.0 - parameters_.guess_rate - parameters_.miss_rate) *
             normal_cdf(std::log10(visible_arcmin / threshold) / parameters_.width_log10);
}

double GapObserver::seen(const AttemptRecord& shown, const StagedScene& scene) {
  const double m_per_deg = metres_per_degree(scene.viewer.screen.viewing_distance_m);
  double clearest = parameters_.guess_rate;
  for (const CollisionRecord& collision : shown.collisions) {
    if (is_wall(collision.report.bodies.b)) {
      continue;
    }
    const auto a = static_cast<std::size_t>(collision.report.bodies.a);
    const auto b = static_cast<std::size_t>(collision.report.bodies.b);
    const CollisionTruth truth =
        measure_truth(scene.looks[a], collision.pose_a, scene.looks[b], collision.pose_b,
                      scene.viewer_at_time(collision.time_s));
    const double speed_deg_s = collision.report.approach_m_s / m_per_deg;
    clearest = std::max(clearest, seen_gap(truth.visible_arcmin(), collision.eccentricity_deg,
                                           speed_deg_s, scene.looks.size()));
  }
  return clearest;
}

std::vector<ParameterEntry> gap_entries(GapParameters& gap) {
  return {{"threshold_arcmin", 1e-3, kAny, &gap.threshold_arcmin,
           "The gap that is seen half of the time at the point of gaze, at rest, with two bodies."},
          {"width_log10", 1e-3, kAny, &gap.width_log10,
           "How wide the function is: a standard deviation of the decimal logarithm."},
          {"guess_rate", 0.0, 1.0, &gap.guess_rate, "Yes where nothing is seen."},
          {"miss_rate", 0.0, 1.0, &gap.miss_rate, "No where it is clearly seen."}};
}

const ObserverKind& gap_observer() {
  static const ObserverKind kind{.name = "gap",
                                 .words = "Notices a gap between two bodies that collide.",
                                 .attention = gap_attention(),
                                 .parameters = list_own<GapParameters, gap_entries>(),
                                 .read = read_own<GapParameters, gap_entries>,
                                 .make = make_own<GapParameters, GapObserver>};
  return kind;
}

const ObserverKind& gap_thresholds_observer() {
  static const ObserverKind kind{.name = kThresholds,
                                 .words =
                                     "Notices such a gap, less well in a crowd, by a threshold "
                                     "of each participant's own.",
                                 .attention = gap_attention(),
                                 .parameters = list_own<GapParameters, thresholds_entries>(),
                                 .read = read_own<GapParameters, thresholds_entries>,
                                 .make = make_own<GapParameters, ThresholdsObserver>};
  return kind;
}

}  // namespace impetus::inline observers
