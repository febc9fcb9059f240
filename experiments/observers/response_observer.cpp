// A simulated participant of the response study: what looks wrong is a gap, a missing spin, and
// haste.
//
//   seen    = 1 − (1 − gap)(1 − w_spin · missing)(1 − w_speed · haste)
//   missing = 1 − Φ(log₁₀(ω / ω₅₀) / width)       ω: how fast the two turn at the end, mean
//   haste   = 1 − exp(−v / v₀)                    v: how fast they closed in
//
// gap is what a participant of the gap study sees. Blocks that do not turn after they met
// off-centre look wrong; a random spin hides that, as the thesis found. Its finding that at high
// speed accurate collisions were rated worse than randomised ones is not built in. The parameters
// are in experiments/observers/response.json.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/observers/gap_observer.hpp"
#include "experiments/observers/shown_truths.hpp"

namespace impetus::inline observers {

const ObserverKind& response_observer();

namespace {

/// What a participant of the response study is made of.
struct ResponseParameters : GapParameters {
  double spin_weight{0.0};         ///< w_spin, of a spin that is missing altogether
  double spin_median_deg_s{60.0};  ///< ω₅₀
  double spin_width_log10{0.3};
  double speed_weight{0.0};        ///< w_speed
  double speed_scale_deg_s{20.0};  ///< v₀
};

/// Judges the gap, the spin and the haste of the first collision of two bodies.
class ResponseObserver final : public RatingObserver {
 public:
  ResponseObserver(const ResponseParameters& parameters, const Birth& birth)
      : RatingObserver(parameters, birth, "response"), parameters_(parameters) {
    draw_traits();
  }

 private:
  [[nodiscard]] double seen(const AttemptRecord& shown, const StagedScene& scene) override;
  /// How clearly something wrong is seen, from 0 to 1.
  [[nodiscard]] double wrongness(double seen_gap, double spin_deg_s, double closing_deg_s) const;

  ResponseParameters parameters_;
};

/// How fast a body turns at the end of what was shown.
double spin_deg_s(const StagedScene& scene, std::int32_t body) {
  const auto index = static_cast<std::size_t>(body);
  return degrees(angular_velocity(scene.world.models()[index], scene.world.states()[index]).norm());
}

double ResponseObserver::wrongness(double seen_gap, double spin_deg_s, double closing_deg_s) const {
  const double turning = spin_deg_s > 0.0
                             ? normal_cdf(std::log10(spin_deg_s / parameters_.spin_median_deg_s) /
                                          parameters_.spin_width_log10)
                             : 0.0;
  const double haste = 1.0 - std::exp(-closing_deg_s / parameters_.speed_scale_deg_s);
  return 1.0 - (1.0 - seen_gap) * (1.0 - parameters_.spin_weight * (1.0 - turning)) *
                   (1.0 - parameters_.speed_weight * haste);
}

double ResponseObserver::seen(const AttemptRecord& shown, const StagedScene& scene) {
  const AnswerModel& gaps = gap_observer().answers;
  const double gap = gaps.seen(parameters_, traits_, gaps.percept(parameters_, shown, scene));
  const CollisionRecord* met = first_meeting(shown);
  if (met == nullptr) {
    return gap;
  }
  const BodyPair& bodies = met->report.bodies;
  const double m_per_deg = metres_per_degree(scene.viewer.screen.viewing_distance_m);
  return wrongness(gap, 0.5 * (spin_deg_s(scene, bodies.a) + spin_deg_s(scene, bodies.b)),
                   met->report.approach_m_s / m_per_deg);
}

std::vector<ParameterEntry> response_entries(ResponseParameters& own) {
  std::vector<ParameterEntry> entries = gap_entries(own);
  entries.push_back({"spin_weight", 0.0, 1.0, &own.spin_weight,
                     "How wrong a spin that is missing altogether looks."});
  entries.push_back({"spin_median_deg_s", 1e-3, kAny, &own.spin_median_deg_s,
                     "The spin that is missed half of the time."});
  entries.push_back({"spin_width_log10", 1e-3, kAny, &own.spin_width_log10,
                     "How wide that function is: a standard deviation of the decimal logarithm."});
  entries.push_back(
      {"speed_weight", 0.0, 1.0, &own.speed_weight, "How wrong haste can look at most."});
  entries.push_back({"speed_scale_deg_s", 1e-3, kAny, &own.speed_scale_deg_s,
                     "The closing speed at which haste looks all but 1/e as wrong as it can."});
  return entries;
}

Attention response_attention() {
  Attention attention = gap_observer().attention;
  attention.words += ", and how the two turn";
  attention.settings.insert(attention.settings.end(),
                            {"spin", "offset", "orientation", "friction", "restitution"});
  return attention;
}

}  // namespace

const ObserverKind& response_observer() {
  static const ObserverKind kind{.name = "response",
                                 .words = "Notices a gap, a spin that is missing, and haste.",
                                 .attention = response_attention(),
                                 .parameters = list_own<ResponseParameters, response_entries>(),
                                 .read = read_own<ResponseParameters, response_entries>,
                                 .make = make_own<ResponseParameters, ResponseObserver>};
  return kind;
}

}  // namespace impetus::inline observers
