// What small scenes pay: two spheres, the response to 64 contacts, the hash of fifteen bodies.
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/bench/bench_options.hpp"
#include "tests/bench/crowd_shape.hpp"

namespace impetus {

/// One step of two spheres, in flight and in contact.
void print_spheres(const CrowdShape& shape, const BenchOptions& options);

/// The response to 64 contacts of one pair, in turn and together.
void print_response(const CrowdShape& shape, const BenchOptions& options);

/// The hash's share of a step of fifteen bodies.
void print_hash(const CrowdShape& shape, const BenchOptions& options);

}  // namespace impetus
