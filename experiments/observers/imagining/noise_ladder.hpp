// The share of imagined runs at rungs of heading noise, and between them: by it people's answers
// tell how unsteady what they imagine is.
//
//   share        x                  one stream of draws for all rungs of a clip, so that shares
//     |      x       x  x           differ by the noise alone; a smooth curve through the rungs
//     |   x                x
//     +---.25-.35-.5 ... 8 deg
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "experiments/observers/imagining/imagining_parameters.hpp"

namespace impetus::inline observers {

/// The share at each rung, as `share` has it of who imagines with that noise; called from several
/// threads at a time. Each clip's own number draws other runs, or what chance leaves in the shares
/// would look in all clips like more noise, or like less.
Percept shares_by_noise(
    const ImaginingParameters& own, std::uint64_t clip,
    const std::function<double(const Imagination& by, RandomStream& draws)>& share);

/// The share at a noise of heading (degrees): the least rung's below it, the last one's above.
double share_at_noise(const Percept& shares, double heading_noise_deg);

/// What a fit of those who imagine has in common: the noise of heading is looked for first.
template <typename Parameters, Lister<Parameters> entries>
AnswerModel imagining_answers() {
  AnswerModel answers = answers_with<Parameters, entries>();
  answers.fitted = {"heading_noise_deg", "lapse_rate"};
  answers.is_of_scene = true;
  answers.seen = [](const RatingParameters& parameters, const Traits& /*all are alike*/,
                    const Percept& percept) {
    return share_at_noise(percept, static_cast<const Parameters&>(parameters).heading_noise_deg);
  };
  answers.settle = answer_blindly_by_lapses;
  return answers;
}

}  // namespace impetus::inline observers
