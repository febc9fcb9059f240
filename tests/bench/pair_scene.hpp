// Two bodies at many random poses: what a descent costs, what it misses and what it only thinks it
// hits, and how near it comes to the limit of the machine.
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/bench/bench_options.hpp"
#include "tests/bench/crowd_shape.hpp"

namespace impetus {

void print_pair(const CrowdShape& shape, const BenchOptions& options);

}  // namespace impetus
