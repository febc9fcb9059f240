// The response to 64 contacts by Bullet's Dantzig solver.
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/bench/contact_problem.hpp"

namespace impetus {

struct DantzigCost {
  double solve_us{0.0};  ///< of the linear complementarity problem alone, its matrix given
  bool solved{false};
};

/// λ ≥ 0, J M⁻¹ Jᵀ λ − (1 + ε) approach ≥ 0. The matrix has rank 6, so a thousandth of its mean
/// diagonal is added to the diagonal, as Bullet does with its constraint force mixing.
DantzigCost dantzig_cost(const ContactProblem& problem, double restitution, double looking_ns);

}  // namespace impetus
