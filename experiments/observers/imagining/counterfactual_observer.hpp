// What a simulated participant of counterfactual judgements is made of, and what it foresees.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/observers/imagining/imagining_parameters.hpp"

namespace impetus::inline observers {

/// How it imagines, and how it marks a line.
struct CounterfactualParameters : ImaginingParameters {
  double mark_sd{0.0};  ///< of a mark, as a share of the line
};

/// What became of a clip, and what might have.
struct Foresight {
  bool through{false};               ///< what happened
  std::optional<std::size_t> other;  ///< whom the goal's body met; none: nobody
  double without{0.0};               ///< the share of imagined runs that get through without him
};

/// Draws from `draws`. Precondition: the scene has a goal, and no figures.
Foresight foresee(const StagedScene& scene, const Imagination& by, RandomStream& draws);

}  // namespace impetus::inline observers
