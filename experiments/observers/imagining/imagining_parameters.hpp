// What simulated participants are made of who answer by what they imagine.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/observers/imagining/imagined_runs.hpp"
#include "experiments/observers/observer_kinds.hpp"

namespace impetus::inline observers {

/// How they imagine.
struct ImaginingParameters : RatingParameters {
  double heading_noise_deg{1.0};
  double runs{100.0};
  double step_hz{50.0};
  double level{-1.0};           ///< −1: as deep as the scene goes
  double tests_per_step{-1.0};  ///< −1: no limit

  /// Of one person.
  [[nodiscard]] Imagination imagination() const;
};

/// Their numbers, with those that a kind has `beside` how it imagines and how it answers.
std::vector<ParameterEntry> imagining_entries(ImaginingParameters& own,
                                              const std::vector<ParameterEntry>& beside = {});

}  // namespace impetus::inline observers
