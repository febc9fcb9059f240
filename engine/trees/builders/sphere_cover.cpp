// SPDX-License-Identifier: MIT
#include "engine/trees/builders/sphere_cover.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace impetus::inline trees {
namespace {

// Betters a choice of candidate centres by exchanging one for another while that helps (the
// interchange heuristic of location problems, Teitz and Bart 1968).
//
// What is made small is the product of the greatest stand-off and the volume outside the solid:
// either alone is paid for with the other.

constexpr std::size_t kRadii = 64;
constexpr int kSweeps = 12;

/// The exchange of candidates, with what it asks of them found in advance.
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

/// Indices of candidates, as many as `chosen` or fewer where some stand for no point.
std::vector<std::size_t> exchanged(const OutsidePoints& outside, const std::vector<Vector3>& points,
                                   const std::vector<InnerPoint>& candidates,
                                   std::vector<std::size_t> chosen) {
  return Exchange(outside, points, candidates).improve(std::move(chosen));
}

constexpr int kHalvings = 14;
constexpr double kFirstStride = 0.25;  ///< share of the radius
constexpr int kStrides = 7;
constexpr int kThoroughRounds = 8;
constexpr int kQuickRounds = 2;

using Clusters = std::vector<std::vector<Vector3>>;

double farthest_m(const Vector3& centre, const std::vector<Vector3>& points) {
  double squared_m2 = 0.0;
  for (const Vector3& point : points) {
    squared_m2 = std::max(squared_m2, (point - centre).squaredNorm());
  }
  return std::sqrt(squared_m2);
}

/// needed[c][p]: the stand-off with which candidate c reaches point p.
class Needs {
 public:
  Needs(const std::vector<Vector3>& points, const std::vector<InnerPoint>& candidates)
      : points_(points.size()),
        candidates_(candidates.size()),
        needed_m_(points.size() * candidates.size()) {
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      for (std::size_t p = 0; p < points_; ++p) {
        needed_m_[c * points_ + p] =
            (points[p] - candidates[c].point).norm() - candidates[c].depth_m;
      }
    }
  }

  /// The candidates picked, each covering the most of what is left; `most` + 1 when that is not
  /// enough.
  [[nodiscard]] std::vector<std::size_t> picked(double stand_off_m, std::size_t most) const {
    std::vector<std::size_t> left(points_);
    for (std::size_t p = 0; p < points_; ++p) {
      left[p] = p;
    }
    std::vector<std::size_t> picks;
    while (!left.empty() && picks.size() <= most) {
      const std::size_t best = covering_most(left, stand_off_m);
      const double* needed_m = &needed_m_[best * points_];
      const auto kept = std::remove_if(left.begin(), left.end(),
                                       [&](std::size_t p) { return needed_m[p] <= stand_off_m; });
      if (kept == left.end()) {
        picks.resize(most + 1);  // nothing reaches what is left
        return picks;
      }
      left.erase(kept, left.end());
      picks.push_back(best);
    }
    return picks;
  }

 private:
  [[nodiscard]] std::size_t covering_most(const std::vector<std::size_t>& left,
                                          double stand_off_m) const {
    std::size_t best = 0;
    std::size_t best_count = 0;
    for (std::size_t c = 0; c < candidates_; ++c) {
      const double* needed_m = &needed_m_[c * points_];
      std::size_t count = 0;
      for (const std::size_t p : left) {
        count += needed_m[p] <= stand_off_m ? 1U : 0U;
      }
      if (count > best_count) {
        best = c;
        best_count = count;
      }
    }
    return best;
  }

  std::size_t points_;
  std::size_t candidates_;
  std::vector<double> needed_m_;
};

double stand_off_of(const std::vector<InnerPoint>& centres,
                    const std::vector<std::vector<Vector3>>& parts) {
  double worst_m = -std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < centres.size(); ++c) {
    if (!parts[c].empty()) {
      worst_m = std::max(worst_m, stand_off_m(centres[c], parts[c]));
    }
  }
  return worst_m;
}

double outside_m3(const OutsidePoints& outside, const std::vector<InnerPoint>& centres,
                  const std::vector<std::vector<Vector3>>& parts) {
  double sum_m3 = 0.0;
  for (std::size_t c = 0; c < centres.size(); ++c) {
    if (!parts[c].empty()) {
      sum_m3 += outside.volume_m3(centres[c].point, farthest_m(centres[c].point, parts[c]));
    }
  }
  return sum_m3;
}

/// Moves along the axes while that lowers `cost`, by ever smaller strides. `cost` takes the radius
/// that holds the points and the depth, and falls with the depth.
template <typename Cost>
InnerPoint settled(const SurfaceDistance& surface, const std::vector<Vector3>& points,
                   const InnerPoint& start, const Cost& cost) {
  static const std::array<Vector3, 6> kAxes{Vector3::UnitX(), -Vector3::UnitX(),
                                            Vector3::UnitY(), -Vector3::UnitY(),
                                            Vector3::UnitZ(), -Vector3::UnitZ()};
  InnerPoint best = start;
  const double radius_m = farthest_m(start.point, points);
  double least = cost(start.point, radius_m, start.depth_m);
  double stride_m = kFirstStride * radius_m;
  for (int turn = 0; turn < kStrides;) {
    bool moved = false;
    for (const Vector3& axis : kAxes) {
      const Vector3 place = best.point + stride_m * axis;
      const double needed_m = farthest_m(place, points);
      // No deeper than to the triangle that was nearest: most moves fail on that already.
      if (!(cost(place, needed_m, surface.distance_to_m(best.nearest, place)) < least)) {
        continue;
      }
      const InnerPoint next = inner_point(surface, place, best.nearest);
      const double found = cost(place, needed_m, next.depth_m);
      if (found < least) {
        best = next;
        least = found;
        moved = true;
      }
    }
    if (!moved) {
      stride_m *= 0.5;
      ++turn;
    }
  }
  return best;
}

std::vector<std::size_t> expanded(const std::vector<Vector3>& points,
                                  const std::vector<InnerPoint>& candidates, std::size_t most) {
  const Needs needs(points, candidates);
  double enough_m = std::numeric_limits<double>::infinity();
  std::size_t alone = 0;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const double needed_m = stand_off_m(candidates[c], points);
    if (needed_m < enough_m) {
      enough_m = needed_m;
      alone = c;
    }
  }
  std::vector<std::size_t> best{alone};
  double too_little_m = 0.0;
  for (int turn = 0; turn < kHalvings; ++turn) {
    const double middle_m = 0.5 * (too_little_m + enough_m);
    std::vector<std::size_t> picks = needs.picked(middle_m, most);
    if (picks.size() <= most) {
      enough_m = middle_m;
      best.swap(picks);
    } else {
      too_little_m = middle_m;
    }
  }
  return best;
}

std::vector<InnerPoint> centres_at(const std::vector<InnerPoint>& candidates,
                                   const std::vector<std::size_t>& picks) {
  std::vector<InnerPoint> centres;
  centres.reserve(picks.size());
  for (const std::size_t pick : picks) {
    centres.push_back(candidates[pick]);
  }
  return centres;
}

/// Points to centres, centres to points, in turn; the cheapest of what was met.
template <typename Cost>
SphereCover refined(const SurfaceDistance& surface, const std::vector<Vector3>& points,
                    std::vector<InnerPoint> centres, int rounds, const Cost& cost) {
  SphereCover best;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round <= rounds; ++round) {
    const Clusters parts = clusters(centres, points);
    const double found = cost(centres, parts);
    if (found < least) {
      best = {centres, stand_off_of(centres, parts)};
      least = found;
    }
    for (std::size_t c = 0; c < centres.size() && round < rounds; ++c) {
      if (!parts[c].empty()) {
        centres[c] = best_centre(surface, parts[c], centres[c]);
      }
    }
  }
  return best;
}

}  // namespace

std::vector<Sphere> spheres_of(const SphereCover& cover) {
  std::vector<Sphere> spheres;
  for (const InnerPoint& centre : cover.centres) {
    spheres.push_back({centre.point, centre.depth_m + cover.stand_off_m});
  }
  return spheres;
}

Clusters clusters(const std::vector<InnerPoint>& centres, const std::vector<Vector3>& points) {
  Clusters result(centres.size());
  for (const Vector3& point : points) {
    std::size_t best = 0;
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < centres.size(); ++c) {
      const double needed_m = (point - centres[c].point).norm() - centres[c].depth_m;
      if (needed_m < least_m) {
        least_m = needed_m;
        best = c;
      }
    }
    result[best].push_back(point);
  }
  return result;
}

double stand_off_m(const InnerPoint& centre, const std::vector<Vector3>& points) {
  return farthest_m(centre.point, points) - centre.depth_m;
}

InnerPoint best_centre(const SurfaceDistance& surface, const std::vector<Vector3>& points,
                       const InnerPoint& start) {
  return settled(surface, points, start, [](const Vector3&, double radius_m, double depth_m) {
    return radius_m - depth_m;
  });
}

InnerPoint leanest_centre(const SurfaceDistance& surface, const OutsidePoints& outside,
                          const std::vector<Vector3>& points, const InnerPoint& start,
                          double stand_off) {
  return settled(surface, points, start,
                 [&](const Vector3& centre, double radius_m, double depth_m) {
                   return radius_m - depth_m <= stand_off ? outside.volume_m3(centre, radius_m)
                                                          : std::numeric_limits<double>::infinity();
                 });
}

SphereCover cover_points(const SurfaceDistance& surface, const OutsidePoints& outside,
                         const std::vector<Vector3>& points,
                         const std::vector<InnerPoint>& candidates, std::size_t most) {
  const std::vector<std::size_t> picks =
      exchanged(outside, points, candidates, expanded(points, candidates, most));
  return refined(surface, points, centres_at(candidates, picks), kThoroughRounds,
                 [&](const std::vector<InnerPoint>& centres, const Clusters& parts) {
                   return stand_off_of(centres, parts) * outside_m3(outside, centres, parts);
                 });
}

SphereCover cover_points_quickly(const SurfaceDistance& surface, const std::vector<Vector3>& points,
                                 const std::vector<InnerPoint>& candidates, std::size_t most) {
  return refined(surface, points, centres_at(candidates, expanded(points, candidates, most)),
                 kQuickRounds, stand_off_of);
}

}  // namespace impetus::inline trees
