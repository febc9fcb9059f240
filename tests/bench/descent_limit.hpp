// How fast sphere pairs can be tested at all on this machine: the limit that a descent is held
// against.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus {

/// Pairs of spheres tested in a second of CPU time in blocks of 8 × 8, single precision, AVX2, the
/// transform of one side's eight included: median of some runs. Zero where there is no AVX2.
double limit_pairs_per_s();

}  // namespace impetus
