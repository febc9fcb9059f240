// Stretches of time in which a signal is lost: they begin at random and last about as long as each
// other.
//
//   share of time lost = mean length / (mean length + 1 / rate)
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "experiments/observers/draws.hpp"

namespace impetus::inline observers {

class LossProcess {
 public:
  /// Begins anew at `per_s` while nothing is lost; lasts uniformly between half and one and a half
  /// of `mean_ms`. Rate 0: never.
  LossProcess(RandomStream stream, double per_s, double mean_ms, std::int64_t start_ns);

  /// Whether the signal is lost at the instant, which must not go back.
  bool lost_at(std::int64_t instant_ns);

 private:
  void draw_next();

  RandomStream stream_;
  double per_s_;
  double mean_ms_;
  double from_ns_{0.0};
  double to_ns_;
};

}  // namespace impetus::inline observers
