// SPDX-License-Identifier: MIT
#include "tests/bench/crowd_starts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/collision/pair_refinement.hpp"

namespace impetus {
namespace {

constexpr std::uint64_t kSeed = 6;
constexpr int kTries = 60;
constexpr double kJitter = 0.15;  ///< of a cell's edge, to both sides

bool finest_touch(PairRefinement refinement) {
  while (!refinement.resolved()) {
    refinement.refine_one_block();
  }
  return !refinement.overlapping().empty();
}

/// The bodies placed so far.
class Placing {
 public:
  Placing(const CrowdShape& shape, double half_edge_m)
      : shape_(shape),
        reach_m_(PlacedTree(*shape.fine).reach_m()),
        walls_(ClosedCube{half_edge_m}) {}

  /// A pose near `middle` that touches nobody, or the last that was tried.
  void add(const Vector3& middle, double cell_m, BenchCrowdStart& start) {
    BodyState state;
    bool free = false;
    for (int tried = 0; tried < kTries && !free; ++tried) {
      state.pose.position = middle + kJitter * cell_m * random_in_unit_cube(random_);
      state.pose.orientation = random_orientation(random_);
      free = is_free(state.pose);
    }
    start.touching += free ? 0 : 1;
    placed_.emplace_back(*shape_.fine);
    placed_.back().move_to(state.pose);
    start.states.push_back(state);
  }

 private:
  bool is_free(const Pose& pose) {
    PlacedTree here(*shape_.fine);
    here.move_to(pose);
    if (finest_touch(PairRefinement(here, walls_))) {
      return false;
    }
    for (PlacedTree& other : placed_) {
      if ((other.pose().position - pose.position).norm() < 2.0 * reach_m_ &&
          finest_touch(PairRefinement(here, other))) {
        return false;
      }
    }
    return true;
  }

  const CrowdShape& shape_;
  double reach_m_;
  Enclosure walls_;
  RandomStream random_{kSeed, "places"};
  std::vector<PlacedTree> placed_;
};

int cells_along(int bodies) {
  int along = 1;
  while (along * along * along < bodies) {
    ++along;
  }
  return along;
}

double half_edge_filled(int bodies, double fill) {
  return 0.5 * std::cbrt(bodies * 4.0 / 3.0 * std::numbers::pi / fill);
}

BenchCrowdStart flying_at(BenchCrowdStart start, const CrowdShape& shape, double speed_m_s) {
  RandomStream random(kSeed, "motion");
  for (BodyState& state : start.states) {
    state.linear_momentum = shape.mass.mass_kg * speed_m_s * random_direction(random);
    const Matrix3 turn = state.pose.orientation.toRotationMatrix();
    const Vector3 spin_rad_s = speed_m_s * random.uniform() * random_direction(random);
    state.angular_momentum = turn * shape.mass.inertia * turn.transpose() * spin_rad_s;
  }
  return start;
}

}  // namespace

Vector3 random_in_unit_cube(RandomStream& random) {
  const double x = 2.0 * random.uniform() - 1.0;
  const double y = 2.0 * random.uniform() - 1.0;
  const double z = 2.0 * random.uniform() - 1.0;
  return {x, y, z};
}

Vector3 random_direction(RandomStream& random) {
  for (;;) {
    const Vector3 in_cube = random_in_unit_cube(random);
    const double length = in_cube.norm();
    if (length > 0.1 && length <= 1.0) {
      return in_cube / length;
    }
  }
}

Quaternion random_orientation(RandomStream& random) {
  for (;;) {
    const Vector3 part = random_in_unit_cube(random);
    Quaternion turn(2.0 * random.uniform() - 1.0, part.x(), part.y(), part.z());
    const double length = turn.norm();
    if (length > 0.1 && length <= 1.0) {
      turn.normalize();
      return turn;
    }
  }
}

BenchCrowdStart at_rest(const CrowdShape& shape, int bodies, double fill) {
  BenchCrowdStart start;
  start.half_edge_m = half_edge_filled(bodies, fill);
  const int along = cells_along(bodies);
  const double cell_m = 2.0 * start.half_edge_m / along;
  std::vector<Vector3> middles;
  for (int x = 0; x < along; ++x) {
    for (int y = 0; y < along; ++y) {
      for (int z = 0; z < along; ++z) {
        middles.push_back(cell_m * Vector3(x + 0.5, y + 0.5, z + 0.5) -
                          Vector3::Constant(start.half_edge_m));
      }
    }
  }
  RandomStream(kSeed, "cells").shuffle(middles);
  Placing placing(shape, start.half_edge_m);
  for (int body = 0; body < bodies; ++body) {
    placing.add(middles[static_cast<std::size_t>(body)], cell_m, start);
  }
  return start;
}

BenchCrowdStart flying(const CrowdShape& shape, int bodies, double fill) {
  return flying_at(at_rest(shape, bodies, fill), shape, kCrowdSpeed_m_s);
}

BenchCrowdStart falling(const CrowdShape& shape, int bodies) {
  BenchCrowdStart start = at_rest(shape, bodies, /*fill=*/0.3);
  start.gravity_m_s2 = Vector3(0.0, -9.81, 0.0);
  return start;
}

BenchCrowdStart imploding(const CrowdShape& shape, int bodies) {
  constexpr double kUntilTheyMeet_s = 0.8;
  BenchCrowdStart start = at_rest(shape, bodies, /*fill=*/0.1);
  start.half_edge_m = 0.0;
  for (BodyState& state : start.states) {
    state.linear_momentum = -shape.mass.mass_kg / kUntilTheyMeet_s * state.pose.position;
  }
  return start;
}

}  // namespace impetus
