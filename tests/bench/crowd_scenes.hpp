// The scenes of crowds: each prints its rows, with the goal beside them.
//
//   columns   step by thread CPU time: median, 99th percentile, longest | touching pairs, contacts
//             and work of a step, means | kinetic energy at the end over that at the start, bodies
//             outside | what went wrong
//
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/bench/bench_options.hpp"
#include "tests/bench/crowd_shape.hpp"

namespace impetus {

/// 250 bodies in a closed cube, 30 % full, restitution .5; then also stopped at entry.
void print_cube(const CrowdShape& shape, const BenchOptions& options);

/// Restitution 1 for 5 s: energy and escapes. 250 bodies at 30 %, and 100 at 150 %.
void print_elastic(const CrowdShape& shape, const BenchOptions& options);

/// 250 bodies aimed at one point, restitution .5, with budgets of none, 4 ms and 1 ms.
void print_implosion(const CrowdShape& shape, const BenchOptions& options);

/// 1,000 bodies, 100 % full, budget of 4 ms.
void print_thousand(const CrowdShape& shape, const BenchOptions& options);

/// 250 bodies that fall into a pit and pile up there.
void print_pit(const CrowdShape& shape, const BenchOptions& options);

/// 10 to 10,000 bodies at 30 %, with 64 leaves and 510: how the cost of a step grows.
void print_growth(const CrowdShape& shape, const BenchOptions& options);

/// 250 and 2,000 bodies at 30 and 100 %, fast pairs stopped at entry, as by default, and ignored:
/// each step by one worker and by as many as there are cores. Times are what passed, of no thread.
void print_shared(const CrowdShape& shape, const BenchOptions& options);

}  // namespace impetus
