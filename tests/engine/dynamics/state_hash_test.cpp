// The hash of a state, and where two states differ.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/dynamics/state_hash.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::state_hash_test {

/// Thirteen numbers of a state, by field.
std::vector<std::tuple<StateField, double*>> numbers_of(BodyState& state) {
  std::vector<std::tuple<StateField, double*>> numbers;
  for (int i = 0; i < 3; ++i) {
    numbers.emplace_back(StateField::kPosition, &state.pose.position[i]);
    numbers.emplace_back(StateField::kLinearMomentum, &state.linear_momentum[i]);
    numbers.emplace_back(StateField::kAngularMomentum, &state.angular_momentum[i]);
  }
  for (int i = 0; i < 4; ++i) {
    numbers.emplace_back(StateField::kOrientation, &state.pose.orientation.coeffs()[i]);
  }
  return numbers;
}

std::vector<BodyState> random_states(RandomStream& random, std::size_t count) {
  std::vector<BodyState> states(count);
  for (BodyState& state : states) {
    state.pose = {random_in_cube(random, 3.0), random_turn(random)};
    state.linear_momentum = random_in_cube(random, 3.0);
    state.angular_momentum = random_in_cube(random, 3.0);
  }
  return states;
}

TEST(StateHash, AOneBitChangeIsNoticedAndItsBodyAndFieldAreNamed) {
  RandomStream random(37, "states");
  std::vector<BodyState> states = random_states(random, 5);
  const StateHash clean = hash_state(states);
  int unnamed = 0;
  for (std::size_t body = 0; body < states.size(); ++body) {
    for (const auto& [field, number] : numbers_of(states[body])) {
      for (int bit = 0; bit < 64; ++bit) {
        const double original = *number;
        *number = std::bit_cast<double>(std::bit_cast<std::uint64_t>(original) ^
                                        (std::uint64_t{1} << bit));
        const StateHash changed = hash_state(states);
        *number = original;
        ASSERT_NE(changed.hash, clean.hash) << name_of(field) << " bit " << bit;
        const auto difference = first_difference(clean.bodies, changed.bodies);
        if (!difference) {
          ++unnamed;
          continue;
        }
        EXPECT_EQ(difference->body, body);
        EXPECT_EQ(difference->field, field);
      }
    }
  }
  // 16-bit digests: one change in 65,536 keeps its digest; there are 4,160 changes here.
  EXPECT_LE(unnamed, 2);
}

TEST(StateHash, NamesItsFields) {
  EXPECT_EQ(name_of(StateField::kPosition), "position");
  EXPECT_EQ(name_of(StateField::kOrientation), "orientation");
  EXPECT_EQ(name_of(StateField::kLinearMomentum), "linear momentum");
  EXPECT_EQ(name_of(StateField::kAngularMomentum), "angular momentum");
}

TEST(StateHash, SignedZerosAreTheSameState) {
  std::vector<BodyState> states(2);
  const std::uint64_t plus = hash_state(states).hash;
  for (BodyState& state : states) {
    for (const auto& [field, number] : numbers_of(state)) {
      *number = *number == 0.0 ? -0.0 : *number;
    }
  }
  EXPECT_EQ(hash_state(states).hash, plus);
}

TEST(StateHash, TheOrderOfBodiesMatters) {
  RandomStream random(38, "order");
  std::vector<BodyState> states = random_states(random, 2);
  const std::uint64_t hash = hash_state(states).hash;
  std::swap(states[0], states[1]);
  EXPECT_NE(hash_state(states).hash, hash);
}

TEST(StateHash, HoldsAreNotPartOfIt) {
  RandomStream random(39, "holds");
  std::vector<BodyState> states = random_states(random, 2);
  const std::uint64_t hash = hash_state(states).hash;
  states[0].held_s = 0.1;
  states[1].held_fraction = 0.5;
  EXPECT_EQ(hash_state(states).hash, hash);
}

TEST(StateHash, EqualDigestsHaveNoDifference) {
  RandomStream random(40, "equal");
  const StateHash hash = hash_state(random_states(random, 3));
  EXPECT_FALSE(first_difference(hash.bodies, hash.bodies).has_value());
}

}  // namespace impetus::state_hash_test
