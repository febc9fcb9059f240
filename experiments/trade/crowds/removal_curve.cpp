// SPDX-License-Identifier: MIT
#include "experiments/trade/crowds/removal_curve.hpp"

#include <algorithm>

namespace impetus::inline trade {

void RemovalCurve::add(const Point& piece) {
  points_.push_back({points_.back().work + piece.work, points_.back().removed + piece.removed});
}

RemovalCurve RemovalCurve::in_hindsight(const std::vector<PairLevels>& pairs, ErrorOf error) {
  const auto slope = [](const Point& piece) {
    return piece.removed / static_cast<double>(piece.work);
  };
  std::vector<Point> pieces;
  for (const PairLevels& pair : pairs) {
    const double at_root = pair.levels.front().left.*error;
    std::vector<Point> hull;  // pieces, their slopes falling
    Point reached;
    for (const PairAtLevel& level : pair.levels) {
      Point piece{level.work - reached.work, at_root - level.left.*error - reached.removed};
      if (piece.work <= 0 || piece.removed <= 0.0) {
        continue;
      }
      reached = {level.work, at_root - level.left.*error};
      while (!hull.empty() && slope(piece) >= slope(hull.back())) {
        piece = {piece.work + hull.back().work, piece.removed + hull.back().removed};
        hull.pop_back();
      }
      hull.push_back(piece);
    }
    pieces.insert(pieces.end(), hull.begin(), hull.end());
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [&](const Point& x, const Point& y) { return slope(x) > slope(y); });
  RemovalCurve curve(/*in_pieces=*/true);
  for (const Point& piece : pieces) {
    curve.add(piece);
  }
  return curve;
}

RemovalCurve RemovalCurve::depth_first(const std::vector<PairLevels>& pairs, ErrorOf error,
                                       const std::vector<std::size_t>& order) {
  RemovalCurve curve(/*in_pieces=*/false);
  for (const std::size_t index : order) {
    const std::vector<PairAtLevel>& levels = pairs[index].levels;
    for (std::size_t level = 1; level < levels.size(); ++level) {
      curve.add({levels[level].work - levels[level - 1].work,
                 levels[level - 1].left.*error - levels[level].left.*error});
    }
  }
  return curve;
}

RemovalCurve RemovalCurve::breadth_first(const std::vector<PairLevels>& pairs, ErrorOf error,
                                         const std::vector<std::size_t>& order) {
  RemovalCurve curve(/*in_pieces=*/false);
  bool deeper = true;
  for (std::size_t level = 1; deeper; ++level) {
    deeper = false;
    for (const std::size_t index : order) {
      const std::vector<PairAtLevel>& levels = pairs[index].levels;
      if (level < levels.size()) {
        deeper = true;
        curve.add({levels[level].work - levels[level - 1].work,
                   levels[level - 1].left.*error - levels[level].left.*error});
      }
    }
  }
  return curve;
}

double RemovalCurve::removed(std::int64_t work) const {
  const auto beyond =
      std::upper_bound(points_.begin(), points_.end(), work,
                       [](std::int64_t spent, const Point& point) { return spent < point.work; });
  if (beyond == points_.begin()) {
    return 0.0;
  }
  const Point& reached = *std::prev(beyond);
  if (!in_pieces_ || beyond == points_.end()) {
    return reached.removed;
  }
  const double share =
      static_cast<double>(work - reached.work) / static_cast<double>(beyond->work - reached.work);
  return reached.removed + share * (beyond->removed - reached.removed);
}

double left_at_roots(const std::vector<PairLevels>& pairs, ErrorOf error) {
  double sum = 0.0;
  for (const PairLevels& pair : pairs) {
    sum += pair.levels.front().left.*error;
  }
  return sum;
}

double left_at_finest(const std::vector<PairLevels>& pairs, ErrorOf error) {
  double sum = 0.0;
  for (const PairLevels& pair : pairs) {
    sum += pair.levels.back().left.*error;
  }
  return sum;
}

}  // namespace impetus::inline trade
