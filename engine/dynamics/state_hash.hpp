// The hash of a step: proof that a replay is in the same state, bit for bit.
//
// It covers position, orientation and momenta of every body, and nothing else, so that the
// engine's internals may change without breaking a recording. A 16-bit digest of each field, kept
// beside the 64-bit hash, is enough to name the body and the field that differ.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/dynamics/body.hpp"

namespace impetus::inline dynamics {

/// The parts of a body's state, as a divergence names them.
enum class StateField { kPosition, kOrientation, kLinearMomentum, kAngularMomentum };
inline constexpr std::size_t kStateFieldCount = 4;

/// "position", "orientation", "linear momentum", "angular momentum".
std::string_view name_of(StateField field);

/// One digest per field of one body.
using BodyDigest = std::array<std::uint16_t, kStateFieldCount>;

/// The hash of a state, and the digests of its bodies.
struct StateHash {
  std::uint64_t hash{0};
  std::vector<BodyDigest> bodies;
};

StateHash hash_state(const std::vector<BodyState>& states);

/// The same into `result`, whose memory is used again.
void hash_state(const std::vector<BodyState>& states, StateHash& result);

/// The first body and field whose digests differ; nothing when all agree.
struct DigestDifference {
  std::size_t body;
  StateField field;
};
std::optional<DigestDifference> first_difference(const std::vector<BodyDigest>& expected,
                                                 const std::vector<BodyDigest>& actual);

}  // namespace impetus::inline dynamics
