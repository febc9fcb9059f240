// SPDX-License-Identifier: MIT
#include "engine/trees/builders/cover_exchange.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace impetus::inline trees {
namespace {

constexpr std::size_t kRadii = 64;
constexpr int kSweeps = 12;

class Exchange {
 public:
  Exchange(const OutsidePoints& outside, const std::vector<Vector3>& points,
           const std::vector<InnerPoint>& candidates)
      : points_(points.size()), candidates_(candidates) {
    double reach_m = 0.0;
    for (const Vector3& point : points) {
      reach_m = std::max(reach_m, 2.0 * (point - points.front()).norm());
    }
    step_m_ = 1.5 * reach_m / kRadii;
    for (const InnerPoint& candidate : candidates) {
      volumes_m3_.push_back(outside.volumes_m3(candidate.point, step_m_, kRadii));
      for (const Vector3& point : points) {
        needed_m_.push_back((point - candidate.point).norm() - candidate.depth_m);
      }
    }
  }

  std::vector<std::size_t> improve(std::vector<std::size_t> chosen) {
    double least = cost(chosen);
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      std::vector<std::size_t> best = chosen;
      double best_cost = least;
      for (std::size_t slot = 0; slot < chosen.size(); ++slot) {
        prepare(chosen, slot);
        for (std::size_t candidate = 0; candidate < candidates_.size(); ++candidate) {
          const double found = cost_with(candidate);
          if (found < best_cost) {
            best_cost = found;
            best = chosen;
            best[slot] = candidate;
          }
        }
      }
      if (!(best_cost < least)) {
        break;
      }
      chosen = best;
      least = best_cost;
    }
    return chosen;
  }

 private:
  [[nodiscard]] double needed_m(std::size_t candidate, std::size_t point) const {
    return needed_m_[candidate * points_ + point];
  }

  /// For every point the best of all chosen but the one in `slot`.
  void prepare(const std::vector<std::size_t>& chosen, std::size_t slot) {
    others_.clear();
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (i != slot) {
        others_.push_back(chosen[i]);
      }
    }
    best_of_others_.assign(points_, 0);
    least_of_others_m_.assign(points_, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < others_.size(); ++i) {
      for (std::size_t p = 0; p < points_; ++p) {
        const double needed = needed_m(others_[i], p);
        if (needed < least_of_others_m_[p]) {
          least_of_others_m_[p] = needed;
          best_of_others_[p] = i;
        }
      }
    }
  }

  [[nodiscard]] double cost_with(std::size_t candidate) {
    worst_m_.assign(others_.size() + 1, -std::numeric_limits<double>::infinity());
    for (std::size_t p = 0; p < points_; ++p) {
      const double needed = needed_m(candidate, p);
      if (needed < least_of_others_m_[p]) {
        worst_m_.back() = std::max(worst_m_.back(), needed);
      } else {
        double& worst = worst_m_[best_of_others_[p]];
        worst = std::max(worst, least_of_others_m_[p]);
      }
    }
    double stand_off_m = 0.0;
    double volume_m3 = 0.0;
    for (std::size_t i = 0; i < worst_m_.size(); ++i) {
      if (std::isfinite(worst_m_[i])) {
        const std::size_t which = i < others_.size() ? others_[i] : candidate;
        stand_off_m = std::max(stand_off_m, worst_m_[i]);
        volume_m3 += volume_of(which, worst_m_[i] + candidates_[which].depth_m);
      }
    }
    return stand_off_m * volume_m3;
  }

  double cost(const std::vector<std::size_t>& chosen) {
    prepare(chosen, 0);
    return cost_with(chosen.front());
  }

  [[nodiscard]] double volume_of(std::size_t candidate, double radius_m) const {
    const auto bin = static_cast<std::size_t>(std::max(0.0, radius_m) / step_m_) + 1;
    return volumes_m3_[candidate][std::min(bin, kRadii - 1)];
  }

  std::size_t points_;
  const std::vector<InnerPoint>& candidates_;
  double step_m_{0.0};
  std::vector<std::vector<double>> volumes_m3_;
  std::vector<double> needed_m_;
  std::vector<std::size_t> others_;
  std::vector<std::size_t> best_of_others_;
  std::vector<double> least_of_others_m_;
  std::vector<double> worst_m_;
};

}  // namespace

std::vector<std::size_t> exchanged(const OutsidePoints& outside, const std::vector<Vector3>& points,
                                   const std::vector<InnerPoint>& candidates,
                                   std::vector<std::size_t> chosen) {
  return Exchange(outside, points, candidates).improve(std::move(chosen));
}

}  // namespace impetus::inline trees
