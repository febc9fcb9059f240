// SPDX-License-Identifier: MIT
#include "engine/trees/builders/kind_choice.hpp"

#include <algorithm>
#include <cmath>

#include "engine/trees/builders/reach_beyond.hpp"

namespace impetus::inline trees {
namespace {

struct Row {
  Fit (*fit)(const FitTask& task);
  double cost;
};

// From the cheapest to the dearest: the first wins among equals.
constexpr Row kRows[] = {
    {fit_sphere, 4.0}, {fit_line, 9.0}, {fit_box, 25.0}, {fit_rectangle, 30.0}};

bool belongs(const Row& row, TreeKind kind) {
  return kind == TreeKind::kHeterogeneous || (row.fit == fit_box) == (kind == TreeKind::kBox);
}

constexpr double kNearTie = 1.02;

/// How many times less a kind of `cost` must reach than a sphere.
double price(TreeKind kind, double cost) {
  return kind == TreeKind::kHeterogeneous ? std::sqrt(cost) : 1.0;
}

}  // namespace

Fit best_fit(TreeKind kind, const PartShape& shape, const RoughDistance& solid,
             const Matrix3& parent_frame, Effort effort, double negligible_m) {
  const FitTask task{&shape, DistanceToUse(solid, extent_m(shape.points)),
                     frames_worth_trying(shape, parent_frame, effort), effort};
  Fit best;
  double least = 0.0;
  bool any = false;
  for (const Row& row : kRows) {
    if (!belongs(row, kind)) {
      continue;
    }
    Fit fit = row.fit(task);
    if (effort == Effort::kCareful) {
      fit.reach_m = reach_beyond_m(fit.volume, DistanceToUse(solid));
    }
    const double got = std::max(fit.reach_m, negligible_m) * price(kind, row.cost);
    if (!any || got * kNearTie < least) {
      best = fit;
      least = got;
      any = true;
    }
  }
  return best;
}

}  // namespace impetus::inline trees
