// SPDX-License-Identifier: MIT
#include "engine/dynamics/state_hash.hpp"

#include <algorithm>
#include <initializer_list>

#include "engine/numerics/random_stream.hpp"

namespace impetus::inline dynamics {
namespace {

std::uint64_t hash_numbers(std::initializer_list<double> numbers) {
  std::uint64_t hash = 0;
  for (const double number : numbers) {
    hash = fold_bits(hash, canonical_bits(number));
  }
  return hash;
}

std::uint64_t hash_vector(const Vector3& v) { return hash_numbers({v.x(), v.y(), v.z()}); }

std::array<std::uint64_t, kStateFieldCount> field_hashes(const BodyState& state) {
  const Quaternion& q = state.pose.orientation;
  return {hash_vector(state.pose.position), hash_numbers({q.w(), q.x(), q.y(), q.z()}),
          hash_vector(state.linear_momentum), hash_vector(state.angular_momentum)};
}

}  // namespace

std::string_view name_of(StateField field) {
  switch (field) {
    case StateField::kPosition:
      return "position";
    case StateField::kOrientation:
      return "orientation";
    case StateField::kLinearMomentum:
      return "linear momentum";
    default:
      return "angular momentum";
  }
}

StateHash hash_state(const std::vector<BodyState>& states) {
  StateHash result;
  hash_state(states, result);
  return result;
}

void hash_state(const std::vector<BodyState>& states, StateHash& result) {
  result.hash = 0;
  result.bodies.clear();
  for (const BodyState& state : states) {
    BodyDigest digest{};
    const auto fields = field_hashes(state);
    for (std::size_t field = 0; field < kStateFieldCount; ++field) {
      result.hash = fold_bits(result.hash, fields[field]);
      digest[field] = static_cast<std::uint16_t>(fields[field]);
    }
    result.bodies.push_back(digest);
  }
}

std::optional<DigestDifference> first_difference(const std::vector<BodyDigest>& expected,
                                                 const std::vector<BodyDigest>& actual) {
  const std::size_t bodies = std::min(expected.size(), actual.size());
  for (std::size_t body = 0; body < bodies; ++body) {
    for (std::size_t field = 0; field < kStateFieldCount; ++field) {
      if (expected[body][field] != actual[body][field]) {
        return DigestDifference{body, static_cast<StateField>(field)};
      }
    }
  }
  return std::nullopt;
}

}  // namespace impetus::inline dynamics
