// SPDX-License-Identifier: MIT
#include "engine/trees/builders/rough_distance.hpp"

#include <cmath>
#include <limits>

namespace impetus::inline trees {

RoughDistance::RoughDistance(const SurfaceDistance& exact, const Vector3& least,
                             const Vector3& most, int cells)
    : exact_(&exact), spacing_m_((most - least).maxCoeff() / cells) {
  // Two cells more on each side.
  least_ = least - Vector3::Constant(2.0 * spacing_m_);
  for (int axis = 0; axis < 3; ++axis) {
    counts_[axis] = static_cast<int>((most[axis] - least[axis]) / spacing_m_) + 6;
  }
  known_m_.assign(static_cast<std::size_t>(counts_[0]) * static_cast<std::size_t>(counts_[1]) *
                      static_cast<std::size_t>(counts_[2]),
                  std::numeric_limits<float>::quiet_NaN());
}

double RoughDistance::at(const Eigen::Vector3i& index) const {
  const auto place =
      static_cast<std::size_t>(index[0]) +
      static_cast<std::size_t>(counts_[0]) *
          (static_cast<std::size_t>(index[1]) +
           static_cast<std::size_t>(counts_[1]) * static_cast<std::size_t>(index[2]));
  float& known_m = known_m_[place];
  if (std::isnan(known_m)) {
    known_m =
        static_cast<float>(exact_->signed_distance_m(least_ + spacing_m_ * index.cast<double>()));
  }
  return known_m;
}

double RoughDistance::interpolated_m(const Vector3& point) const {
  const Vector3 place = (point - least_) / spacing_m_;
  Eigen::Vector3i index;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(place[axis] >= 0.0) || place[axis] >= counts_[axis] - 1) {
      return exact_->signed_distance_m(point);
    }
    index[axis] = static_cast<int>(place[axis]);
  }
  double sum_m = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3i offset(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double share = place[axis] - index[axis];
      weight *= offset[axis] == 1 ? share : 1.0 - share;
    }
    sum_m += weight * at(index + offset);
  }
  return sum_m;
}

}  // namespace impetus::inline trees
