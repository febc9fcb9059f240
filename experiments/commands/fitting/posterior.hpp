// The posterior of an observer's parameters: drawn by the R package mcmc, which asks this program
// how probable parameters are.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/fitting/posterior_density.hpp"

namespace impetus::inline commands {

/// A parameter in the light of the answers, in its own unit.
struct PosteriorParameter {
  std::string name;
  double median{0.0};
  double low{0.0};  ///< of the middle 95 %
  double high{0.0};
  double prior_low{0.0};
  double prior_high{0.0};
  double told{0.0};    ///< the share of the prior's variance that the answers took away
  double rhat{1.0};    ///< how far the chains disagree; 1: not at all
  double enough{0.0};  ///< independent draws that all draws are worth
};

/// What is believed of all parameters after the answers, and the draws that tell it.
struct Posterior {
  std::vector<PosteriorParameter> parameters;
  std::vector<std::vector<double>> draws;  ///< chain, then the value of each parameter

  /// Whether the chains agree and are long enough to be read (Vehtari et al. 2021).
  [[nodiscard]] bool agrees() const;
};

/// Refuses, unless R is there with what draws.
void require_sampler();

/// `progress` is told the share that is done. Throws InputError where R could not finish.
Posterior sample_posterior(PosteriorDensity& density, const std::function<void(double)>& progress);

/// The draws: chain, and each parameter by its name.
std::string draws_table(const Posterior& posterior);

}  // namespace impetus::inline commands
