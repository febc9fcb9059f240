// How long input that was sent took to arrive: what was sent and what arrived, put together.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/record/sent_input.hpp"
#include "experiments/timing/distribution.hpp"

namespace impetus::inline timing {

struct InputDelay {
  InputDevice device{InputDevice::kKey};
  InputRoute route{InputRoute::kQueue};
  std::int64_t sent{0};
  std::int64_t lost{0};           ///< that had not arrived when the next was sent
  std::vector<double> delays_ms;  ///< of those that arrived: from sending to the session's stamp
  /// Of those, the share that was sent within the uncertainty that a session states beside its
  /// stamp.
  double within_uncertainty_share{0.0};

  [[nodiscard]] Distribution delay_ms() const { return distribution_of(delays_ms); }
};

/// What was sent arrives before the next of its device and route is sent, or is lost. Arrivals that
/// nothing was sent for are somebody's own and do not count.
InputDelay input_delay(const InputTrace& trace, InputDevice device, InputRoute route);

}  // namespace impetus::inline timing
