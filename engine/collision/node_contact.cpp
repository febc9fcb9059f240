// SPDX-License-Identifier: MIT
#include "engine/collision/node_contact.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline collision {

double time_since_entry_s(double reach_m, double depth_m, double approach_m_s, double speed_m_s) {
  const double way = (reach_m - depth_m) * approach_m_s;
  const double left = std::max(0.0, depth_m * (2.0 * reach_m - depth_m));
  const double divisor = way + std::sqrt(way * way + speed_m_s * speed_m_s * left);
  return divisor > 0.0 ? left / divisor : 0.0;
}

}  // namespace impetus::inline collision
