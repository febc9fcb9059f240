// SPDX-License-Identifier: MIT
#include "experiments/observers/gap_observer.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/run/collision_truth.hpp"

namespace impetus::inline observers {

const ObserverKind& gap_thresholds_observer();

namespace {

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

double seen_gap(const GapParameters& own, const Traits& traits, double visible_arcmin,
                double eccentricity_deg, double speed_deg_s, double bodies) {
  if (visible_arcmin <= 0.0) {
    return own.guess_rate;
  }
  const double crowd = std::max(0.0, bodies - 2.0);
  const double threshold =
      gap_threshold_arcmin(own.threshold_arcmin, eccentricity_deg, speed_deg_s) *
      std::pow(10.0, own.threshold_sd_log10 * traits.threshold) *
      (1.0 + own.crowding_per_body * crowd);
  return own.guess_rate + (1.0 - own.guess_rate - own.miss_rate) *
                              normal_cdf(std::log10(visible_arcmin / threshold) / own.width_log10);
}

namespace {

/// The number of bodies; then of each collision of two of them the gap (minutes of arc), its
/// eccentricity (degrees), and how fast they closed in (degrees per second).
Percept shown_gaps(const RatingParameters& /*parameters*/, const AttemptRecord& shown,
                   const StagedScene& scene) {
  const double m_per_deg = metres_per_degree(scene.viewer.screen.viewing_distance_m);
  Percept percept{static_cast<double>(scene.looks.size())};
  for (const CollisionRecord& collision : shown.collisions) {
    if (is_wall(collision.report.bodies.b)) {
      continue;
    }
    const auto a = static_cast<std::size_t>(collision.report.bodies.a);
    const auto b = static_cast<std::size_t>(collision.report.bodies.b);
    const CollisionTruth truth =
        measure_truth(scene.looks[a], collision.pose_a, scene.looks[b], collision.pose_b,
                      scene.viewer_at_time(collision.time_s));
    percept.insert(percept.end(), {truth.visible_arcmin(), collision.eccentricity_deg,
                                   collision.report.approach_m_s / m_per_deg});
  }
  return percept;
}

/// The clearest of them.
double clearest_gap(const RatingParameters& parameters, const Traits& traits,
                    const Percept& percept) {
  const auto& own = static_cast<const GapParameters&>(parameters);
  double clearest = own.guess_rate;
  for (std::size_t at = 1; at < percept.size(); at += 3) {
    clearest = std::max(
        clearest, seen_gap(own, traits, percept[at], percept[at + 1], percept[at + 2], percept[0]));
  }
  return clearest;
}

template <std::vector<ParameterEntry> (*entries)(GapParameters&)>
AnswerModel gap_answers(std::vector<std::string> fitted, std::vector<TraitSpread> spreads) {
  AnswerModel answers =
      answers_of_own<GapParameters, entries>(std::move(fitted), std::move(spreads));
  answers.percept = shown_gaps;
  answers.seen = clearest_gap;
  answers.late_threshold_sd = [](const RatingParameters& parameters) {
    return static_cast<const GapParameters&>(parameters).threshold_sd_log10;
  };
  return answers;
}

}  // namespace

std::vector<ParameterEntry> gap_entries(GapParameters& gap) {
  return {{"threshold_arcmin", 1e-3, kAny, &gap.threshold_arcmin,
           "The gap that is seen half of the time at the point of gaze, at rest, with two bodies."},
          {"width_log10", 1e-3, kAny, &gap.width_log10,
           "How wide the function is: a standard deviation of the decimal logarithm."},
          {"guess_rate", 0.0, 1.0, &gap.guess_rate, "Yes where nothing is seen."},
          {"miss_rate", 0.0, 1.0, &gap.miss_rate, "No where it is clearly seen."}};
}

const ObserverKind& gap_observer() {
  static const ObserverKind kind{
      .name = "gap",
      .words = "Notices a gap between two bodies that collide.",
      .attention = gap_attention(),
      .parameters = list_own<GapParameters, gap_entries>(),
      .read = read_own<GapParameters, gap_entries>,
      .make = make_modelled<gap_observer>,
      .answers = gap_answers<gap_entries>(
          {"threshold_arcmin", "width_log10", "guess_rate", "miss_rate"}, {})};
  return kind;
}

const ObserverKind& gap_thresholds_observer() {
  static const ObserverKind kind{
      .name = "gap-thresholds",
      .words =
          "Notices such a gap, less well in a crowd, by a threshold "
          "of each participant's own.",
      .attention = gap_attention(),
      .parameters = list_own<GapParameters, thresholds_entries>(),
      .read = read_own<GapParameters, thresholds_entries>,
      .make = make_modelled<gap_thresholds_observer>,
      .answers = gap_answers<thresholds_entries>(
          {"threshold_arcmin", "width_log10", "guess_rate", "miss_rate", "crowding_per_body"},
          {{"threshold_sd_log10", &Traits::threshold}})};
  return kind;
}

}  // namespace impetus::inline observers
