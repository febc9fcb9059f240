// The cube root from + − × ÷ alone, the same bits on every machine.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline numerics {

/// Of a positive number, to within an ulp or two. (Newton's iteration)
double cube_root(double x);

}  // namespace impetus::inline numerics
