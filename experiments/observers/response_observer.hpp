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
#pragma once

#include "experiments/observers/gap_observer.hpp"

namespace impetus::inline observers {

struct ResponseParameters : GapParameters {
  double spin_weight{0.0};         ///< w_spin, of a spin that is missing altogether
  double spin_median_deg_s{60.0};  ///< ω₅₀
  double spin_width_log10{0.3};
  double speed_weight{0.0};        ///< w_speed
  double speed_scale_deg_s{20.0};  ///< v₀
};

class ResponseObserver final : public GapObserver {
 public:
  ResponseObserver(const ResponseParameters& parameters, std::uint64_t seed,
                   const std::string& pseudonym, VirtualClock& clock);

  /// How clearly something wrong is seen, from 0 to 1.
  [[nodiscard]] double seen_of(double seen_gap, double spin_deg_s, double closing_deg_s) const;

 private:
  [[nodiscard]] double seen(const AttemptRecord& shown, const StagedScene& scene) override;

  ResponseParameters parameters_;
};

}  // namespace impetus::inline observers
