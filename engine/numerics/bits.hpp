// 64-bit mixing, the base of the state hash and of the random streams.
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

namespace impetus::inline numerics {

/// A bijection of 64 bits in which every input bit reaches every output bit (SplitMix64's
/// finaliser; Steele, Lea and Flood 2014).
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// Folds one word into a hash. For a given `hash` it is a bijection of `word`, so two sequences
/// that differ in one word never collide.
constexpr std::uint64_t fold_bits(std::uint64_t hash, std::uint64_t word) {
  return mix_bits((hash ^ word) + 0x9e3779b97f4a7c15ULL);
}

/// The bits of `x`, with both zeros as +0: they compare equal, so they hash equal.
constexpr std::uint64_t canonical_bits(double x) {
  return x == 0.0 ? 0 : std::bit_cast<std::uint64_t>(x);
}

}  // namespace impetus::inline numerics
