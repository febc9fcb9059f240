// SPDX-License-Identifier: MIT
#include "experiments/observers/gaze_observer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/observers/explained_clicks.hpp"
#include "experiments/observers/gap_observer.hpp"
#include "experiments/run/collision_truth.hpp"

namespace impetus::inline observers {

const ObserverKind& gaze_observer();

namespace {

/// Gaps that are so much smaller than what can be seen make no difference.
constexpr double kNegligibleShare = 0.1;

/// A body as it is judged: exactly, but for one of a crowd, whose gaps are of no less than
/// `threshold_m` when they are seen, and there are thousands.
DrawnBody judged(const StagedScene& scene, std::int32_t body, double threshold_m) {
  DrawnBody look = scene.looks[static_cast<std::size_t>(body)];
  const double px_per_metre = kMostDeviation_px / (kNegligibleShare * threshold_m);
  look.mesh = mesh_as_seen(look.mesh, look.coarser.get(), px_per_metre);
  return look;
}

/// A collision's bodies, judged by a viewer.
class JudgedCollision {
 public:
  JudgedCollision(const CollisionRecord& collision, const StagedScene& scene, double threshold_m)
      : collision_(collision),
        walls_(scene.world.settings().enclosure),
        viewer_(scene.viewer_at_time(collision.time_s)),
        a_(judged(scene, collision.report.bodies.a, threshold_m)) {
    if (!is_wall(collision.report.bodies.b)) {
      b_ = judged(scene, collision.report.bodies.b, threshold_m);
    }
  }

  /// No less than visible_arcmin(), soon known.
  [[nodiscard]] double most_arcmin() const {
    if (b_) {
      return most_gap_arcmin(a_, collision_.pose_a, *b_, collision_.pose_b, viewer_);
    }
    return walls_ ? wall_gap_arcmin(a_, collision_.pose_a, *walls_, wall(), viewer_) : 0.0;
  }

  [[nodiscard]] double visible_arcmin() const {
    if (b_) {
      return measure_truth(a_, collision_.pose_a, *b_, collision_.pose_b, viewer_).visible_arcmin();
    }
    return walls_ ? measure_wall_truth(a_, collision_.pose_a, *walls_, wall(), viewer_)
                        .visible_arcmin()
                  : 0.0;
  }

 private:
  [[nodiscard]] int wall() const { return kEnclosure - collision_.report.bodies.b; }

  const CollisionRecord& collision_;
  const std::optional<Enclosure>& walls_;
  Viewer viewer_;
  DrawnBody a_;
  std::optional<DrawnBody> b_;
};

/// The numbers of its own, then those of its eye.
std::vector<ParameterEntry> gaze_entries(GazeObserverParameters& gaze) {
  return {
      {"threshold_arcmin", 1e-3, kAny, &gaze.threshold_arcmin,
       "The gap that is seen half of the time at the point of gaze, at rest, with two bodies."},
      {"width_log10", 1e-3, kAny, &gaze.width_log10,
       "How wide the function is: a standard deviation of the decimal logarithm."},
      {"miss_rate", 0.0, 1.0, &gaze.miss_rate, "No where it is clearly seen."},
      {"crowding_per_body", 0.0, kAny, &gaze.crowding_per_body,
       "Share by which the threshold rises for each body beyond two."},
      {"merge_ms", 0.0, kAny, &gaze.merge_ms, "Collisions closer than this are one event."},
      {"click_median_ms", 1.0, kAny, &gaze.click_median_ms,
       "From what was seen to the click; times are lognormal."},
      {"click_sigma_log", 0.0, kAny, &gaze.click_sigma_log,
       "Standard deviation of the natural logarithm of these times."},
      {"refractory_ms", 0.0, kAny, &gaze.refractory_ms,
       "After a click, in which there is no other."},
      {"false_clicks_per_s", 0.0, 100.0, &gaze.false_clicks_per_s, "Clicks at nothing."},
      {"events_per_s", 1e-3, kAny, &gaze.events_per_s,
       "Of what was seen as bad: at this rate badness is 1 − 1/e."},
      {"sampling_hz", 60.0, 1000.0, &gaze.sampling_hz, "Of the simulated tracker."},
      {"latency_ms", 0.0, 1000.0, &gaze.latency_ms,
       "From a sample of the gaze to when it can be used."},
      {"visual_delay_ms", 1.0, 1000.0, &gaze.visual_delay_ms,
       "After which pursuit and saccades follow what is seen."},
      {"fixation_min_ms", 1.0, kAny, &gaze.fixation_min_ms, "The shortest fixation."},
      {"fixation_max_ms", 1.0, kAny, &gaze.fixation_max_ms, "The longest fixation."},
      {"saccade_base_ms", 1.0, kAny, &gaze.saccade_base_ms, "Duration of a saccade of no length."},
      {"saccade_ms_per_deg", 0.0, kAny, &gaze.saccade_ms_per_deg, "What each degree adds to it."},
      {"pair_share", 0.0, 1.0, &gaze.pair_share,
       "Of looks, those at the middle of the pair that will touch first."},
      {"pursuit_share", 0.0, 1.0, &gaze.pursuit_share,
       "Of looks at what moves, those that follow it."},
      {"pursuit_min_ms", 1.0, kAny, &gaze.pursuit_min_ms, "The shortest pursuit."},
      {"pursuit_max_ms", 1.0, kAny, &gaze.pursuit_max_ms, "The longest pursuit."},
      {"pursuit_gain", 0.0, 1.0, &gaze.pursuit_gain,
       "Speed of the eye by that of what it follows."},
      {"pursuit_time_ms", 1.0, kAny, &gaze.pursuit_time_ms,
       "In which all but 1/e of a distance to the target is made good."},
      {"catch_up_deg", 0.5, kAny, &gaze.catch_up_deg,
       "A greater distance is made good by a saccade."},
      {"fixational_sd_deg", 0.0, kAny, &gaze.fixational_sd_deg,
       "Per axis: the drift of the eye and the noise of the tracker together."},
      {"fixational_time_ms", 1e-3, kAny, &gaze.fixational_time_ms, "Correlation time of these."},
      {"offset_sd_deg", 0.0, kAny, &gaze.offset_sd_deg,
       "Per axis, over participants: what calibration leaves."},
      {"blink_per_s", 0.0, 100.0, &gaze.blink_per_s, "How often the eye blinks."},
      {"blink_ms", 1.0, kAny, &gaze.blink_ms, "How long a blink lasts."},
      {"dropout_per_s", 0.0, 100.0, &gaze.dropout_per_s, "How often the tracker loses the eye."},
      {"dropout_ms", 1.0, kAny, &gaze.dropout_ms, "For how long it does."}};
}

/// A range of durations: its end must not come before its beginning.
void require_range(const JsonDocument& document, const std::string& what) {
  if (number_in(document, what + "_max_ms") < number_in(document, what + "_min_ms")) {
    refuse(document, "/parameters/" + what + "_max_ms/value",
           "expected at least " + what + "_min_ms, got " +
               document.value["parameters"][what + "_max_ms"]["value"].dump());
  }
}

Attention gaze_attention() {
  Attention attention = gap_observer().attention;
  attention.words = "gaps that open in collisions, and how far from the gaze they do";
  attention.settings.insert(attention.settings.end(), {"crowd", "engine", "gaze_latency"});
  return attention;
}

std::shared_ptr<const RatingParameters> read_gaze(const JsonDocument& document) {
  auto parameters = read_own<GazeObserverParameters, gaze_entries>(document);
  require_range(document, "fixation");
  require_range(document, "pursuit");
  return parameters;
}

/// Of the events that were seen as bad.
double badness(const GazeObserverParameters& own, double events, double stimulus_s) {
  return 1.0 - std::exp(-events / std::max(stimulus_s, 1e-3) / own.events_per_s);
}

/// Below this gap a body of a crowd is judged by a coarser mesh.
double threshold_m(const GazeObserverParameters& own, const StagedScene& scene) {
  return metres_per_degree(scene.viewer.screen.viewing_distance_m) * own.threshold_arcmin /
         kArcminPerDegree;
}

double gaze_eccentricity_deg(const CollisionRecord& collision) {
  return collision.gaze_eccentricity_deg.value_or(collision.eccentricity_deg);
}

double shown_for_s(const AttemptRecord& shown) {
  return static_cast<double>(shown.frames.back().flip.flipped_ns - shown.onset_ns) / 1e9;
}

/// The stimulus's duration (s) and the number of bodies; then of each collision that a frame
/// showed its time (s), the gap (minutes of arc), its eccentricity (degrees) and how fast they
/// closed in (degrees per second).
Percept shown_collisions(const RatingParameters& parameters, const AttemptRecord& shown,
                         const StagedScene& scene) {
  if (shown.frames.empty()) {
    return {0.0, static_cast<double>(scene.looks.size())};
  }
  const auto& own = static_cast<const GazeObserverParameters&>(parameters);
  const double m_per_deg = metres_per_degree(scene.viewer.screen.viewing_distance_m);
  Percept percept{shown_for_s(shown), static_cast<double>(scene.looks.size())};
  for (const CollisionRecord& collision : shown.collisions) {
    if (collision.first_frame_shown >= 0) {
      const JudgedCollision judged_collision(collision, scene, threshold_m(own, scene));
      percept.insert(percept.end(),
                     {collision.time_s, judged_collision.visible_arcmin(),
                      gaze_eccentricity_deg(collision), collision.report.approach_m_s / m_per_deg});
    }
  }
  return percept;
}

/// Where each collision of a percept, which has them in order of time, begins an event, and how
/// probably: when it is seen and none was within the time in which two count as one; so of those
/// that are no further apart than that, one at most does.
std::vector<PossibleEvent> possible_events(const GazeObserverParameters& own,
                                           const Percept& percept) {
  constexpr double kNegligible = 1e-10;
  std::vector<PossibleEvent> seen;
  std::vector<PossibleEvent> events;
  std::size_t first_near = 0;  // of those seen
  double group_s = 0.0;        // when the first of the alternatives begins
  for (std::size_t at = 2; at < percept.size(); at += 4) {
    const double at_s = percept[at];
    const double chance =
        seen_gap(own, {}, percept[at + 1], percept[at + 2], percept[at + 3], percept[1]);
    if (chance < kNegligible) {
      continue;
    }
    while (first_near < seen.size() && at_s - seen[first_near].at_s >= own.merge_ms / 1e3) {
      ++first_near;
    }
    double begins = chance;
    for (std::size_t near = first_near; near < seen.size(); ++near) {
      begins *= 1.0 - seen[near].chance;
    }
    seen.push_back({at_s, chance});
    if (begins > kNegligible) {
      const bool is_alternative = !events.empty() && at_s - group_s < own.merge_ms / 1e3;
      group_s = is_alternative ? group_s : at_s;
      events.push_back({at_s, begins, is_alternative});
    }
  }
  return events;
}

double gaze_outcomes(const RatingParameters& parameters, const Percept& percept,
                     const std::vector<double>* clicks_s, std::vector<Outcome>& outcomes) {
  const auto& own = static_cast<const GazeObserverParameters&>(parameters);
  const double stimulus_s = percept[0];
  std::vector<PossibleEvent> events = possible_events(own, percept);
  double logarithm = 0.0;
  if (clicks_s != nullptr) {
    logarithm = explain_clicks({own.click_median_ms / 1e3, own.click_sigma_log,
                                own.refractory_ms / 1e3, own.false_clicks_per_s},
                               *clicks_s, stimulus_s, events);
  }
  outcomes.clear();
  const std::vector<double> chances = chances_of_count(events);
  constexpr double kNegligible = 1e-7;
  for (std::size_t count = 0; count < chances.size(); ++count) {
    if (chances[count] > kNegligible) {
      outcomes.push_back({chances[count], badness(own, static_cast<double>(count), stimulus_s)});
    }
  }
  return logarithm;
}

AnswerModel gaze_answers() {
  AnswerModel answers = answers_of_own<GazeObserverParameters, gaze_entries>(
      {"threshold_arcmin", "width_log10", "miss_rate", "false_clicks_per_s", "click_median_ms",
       "click_sigma_log", "events_per_s", "crowding_per_body"},
      {});
  answers.percept = shown_collisions;
  answers.outcomes = gaze_outcomes;
  answers.blank = [](const Percept& percept) { return Percept{percept[0], percept[1]}; };
  return answers;
}

}  // namespace

GazeObserver::GazeObserver(const GazeObserverParameters& parameters, const Birth& birth)
    : RatingObserver(parameters, birth, "gaze-contingent"),
      parameters_(parameters),
      click_stream_(birth.seed, "observer/gaze-contingent/clicks/" + birth.pseudonym),
      eye_(parameters, birth.seed, birth.pseudonym, birth.flip_clock) {
  draw_traits();
}

double GazeObserver::seen_gap(double visible_arcmin, double eccentricity_deg, double speed_deg_s,
                              std::size_t bodies) const {
  return impetus::seen_gap(parameters_, {}, visible_arcmin, eccentricity_deg, speed_deg_s,
                           static_cast<double>(bodies));
}

bool GazeObserver::sees(double draw, const CollisionRecord& collision,
                        const StagedScene& scene) const {
  constexpr double kBeyondRounding = 1e-9;
  if (collision.first_frame_shown < 0) {
    return false;
  }
  const double m_per_deg = metres_per_degree(scene.viewer.screen.viewing_distance_m);
  const JudgedCollision judged_collision(collision, scene, threshold_m(parameters_, scene));
  const auto probability = [&](double arcmin) {
    return seen_gap(arcmin, gaze_eccentricity_deg(collision),
                    collision.report.approach_m_s / m_per_deg, scene.looks.size());
  };
  // In a crowd most gaps are too small for this draw whatever they are exactly, which takes long.
  if (draw >= probability(judged_collision.most_arcmin()) + kBeyondRounding) {
    return false;
  }
  return draw < probability(judged_collision.visible_arcmin());
}

std::vector<double> GazeObserver::draw_events_s(const AttemptRecord& shown,
                                                const StagedScene& scene) {
  std::vector<double> events_s;
  double last_s = 0.0;
  for (const CollisionRecord& collision : shown.collisions) {
    if (!sees(click_stream_.uniform(), collision, scene)) {
      continue;
    }
    if (events_s.empty() || collision.time_s - last_s >= parameters_.merge_ms / 1e3) {
      events_s.push_back(collision.time_s);
    }
    last_s = collision.time_s;
  }
  return events_s;
}

std::vector<double> GazeObserver::draw_clicks_s(const std::vector<double>& events_s,
                                                double stimulus_s) {
  std::vector<double> wanted_s;
  wanted_s.reserve(events_s.size());
  for (const double event_s : events_s) {
    wanted_s.push_back(event_s + draw_lognormal(click_stream_, parameters_.click_median_ms / 1e3,
                                                parameters_.click_sigma_log));
  }
  const double rate = parameters_.false_clicks_per_s;
  double false_s = draw_waiting(click_stream_, rate);
  while (false_s <= stimulus_s) {
    wanted_s.push_back(false_s);
    false_s += draw_waiting(click_stream_, rate);
  }
  std::sort(wanted_s.begin(), wanted_s.end());
  std::vector<double> clicks_s;
  for (const double at_s : wanted_s) {
    const bool ready =
        clicks_s.empty() || at_s - clicks_s.back() >= parameters_.refractory_ms / 1e3;
    if (ready && at_s <= stimulus_s) {
      clicks_s.push_back(at_s);
    }
  }
  return clicks_s;
}

double GazeObserver::seen(const AttemptRecord& shown, const StagedScene& scene) {
  clicks_.clear();
  if (shown.frames.empty()) {
    return 0.0;
  }
  const double stimulus_s = shown_for_s(shown);
  const std::vector<double> events_s = draw_events_s(shown, scene);
  for (const double at_s : draw_clicks_s(events_s, stimulus_s)) {
    clicks_.push_back({"simulated", shown.onset_ns + std::llround(at_s * 1e9), 0});
  }
  return badness(parameters_, static_cast<double>(events_s.size()), stimulus_s);
}

const ObserverKind& gaze_observer() {
  static const ObserverKind kind{.name = "gaze-contingent",
                                 .words =
                                     "Looks about, clicks at collisions that look bad, and "
                                     "rates by how many there were.",
                                 .attention = gaze_attention(),
                                 .clicks = true,
                                 .has_eye = true,
                                 .parameters = list_own<GazeObserverParameters, gaze_entries>(),
                                 .read = read_gaze,
                                 .make = make_own<GazeObserverParameters, GazeObserver>,
                                 .answers = gaze_answers()};
  return kind;
}

}  // namespace impetus::inline observers
