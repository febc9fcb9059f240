// SPDX-License-Identifier: MIT
#include "engine/numerics/cube_root.hpp"

namespace impetus::inline numerics {

double cube_root(double x) {
  // From above, the iteration falls until rounding stops it.
  double root = x > 1.0 ? x : 1.0;
  while (true) {
    const double next = (2.0 * root + x / (root * root)) / 3.0;
    if (!(next < root)) {
      return root;
    }
    root = next;
  }
}

}  // namespace impetus::inline numerics
