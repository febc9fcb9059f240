// SPDX-License-Identifier: MIT
#include "engine/trees/builders/balanced_cover.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/trees/builders/power_cells.hpp"

namespace impetus::inline trees {
namespace {

constexpr int kPresses = 10;
constexpr int kInVain = 3;  ///< presses without success before starting softer from the best
constexpr double kSofter = 0.4;
constexpr double kFirstPress = 0.15;  ///< share of the stand-off

struct Cell {
  std::vector<Vector3> points;
  std::vector<InnerPoint> candidates;
};

std::vector<Cell> cells_of(const std::vector<Sphere>& spheres, const std::vector<Vector3>& points,
                           const std::vector<InnerPoint>& candidates) {
  std::vector<Cell> cells(spheres.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    Cell& cell = cells[least_power(spheres, points[p])];
    cell.points.push_back(points[p]);
    cell.candidates.push_back(candidates[p]);
  }
  return cells;
}

struct Judgement {
  BalancedCover cover;
  std::size_t worst{0};  ///< the sphere whose children fit worst
};

Judgement judge(const SurfaceDistance& surface, const OutsidePoints& outside,
                const std::vector<Sphere>& spheres, const std::vector<Cell>& cells,
                std::size_t most) {
  Judgement judgement{{spheres}, 0};
  BalancedCover& cover = judgement.cover;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].points.empty()) {
      continue;
    }
    const InnerPoint centre =
        best_centre(surface, cells[i].points, inner_point(surface, spheres[i].centre));
    const double needed_m = stand_off_m(centre, cells[i].points);
    cover.stand_off_m = std::max(cover.stand_off_m, needed_m);
    cover.outside_m3 += outside.volume_m3(centre.point, centre.depth_m + needed_m);
    const double next_m =
        cover_points_quickly(surface, cells[i].points, cells[i].candidates, most).stand_off_m;
    if (next_m > cover.next_stand_off_m) {
      cover.next_stand_off_m = next_m;
      judgement.worst = i;
    }
  }
  return judgement;
}

}  // namespace

double BalancedCover::cost(double limit_m) const {
  const double over = std::max(1.0, stand_off_m / limit_m);
  return over * over * next_stand_off_m * std::sqrt(outside_m3);
}

BalancedCover balanced_cover(const SurfaceDistance& surface, const OutsidePoints& outside,
                             const std::vector<Vector3>& points,
                             const std::vector<InnerPoint>& candidates, std::size_t most,
                             double limit_m) {
  const SphereCover cover = cover_points(surface, outside, points, candidates, most);
  std::vector<Sphere> spheres = spheres_of(cover);
  limit_m = std::max(limit_m, cover.stand_off_m);
  BalancedCover best;
  double least = std::numeric_limits<double>::infinity();
  double press_m = kFirstPress * cover.stand_off_m;
  int in_vain = 0;
  std::size_t worst_of_best = 0;
  for (int turn = 0; turn <= kPresses; ++turn) {
    const Judgement judgement =
        judge(surface, outside, spheres, cells_of(spheres, points, candidates), most);
    const double cost = judgement.cover.cost(limit_m);
    if (cost < least) {
      best = judgement.cover;
      least = cost;
      worst_of_best = judgement.worst;
      in_vain = 0;
      spheres[judgement.worst].radius_m -= press_m;
    } else if (++in_vain < kInVain) {
      spheres[judgement.worst].radius_m -= press_m;
    } else {
      in_vain = 0;
      press_m *= kSofter;
      spheres = best.spheres;
      spheres[worst_of_best].radius_m -= press_m;
    }
  }
  return best;
}

}  // namespace impetus::inline trees
