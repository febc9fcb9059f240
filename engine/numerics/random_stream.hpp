// A portable random generator with one named stream per purpose, and the mixing of 64 bits that it
// and the state hash rest on.
//
//   RandomStream(seed, "order/causality/P01")   one stream
//   RandomStream(seed, "practice/...")          another: draws from one never shift the other
//
// The same seed and name give the same numbers on every machine. (xoshiro256**, Blackman and
// Vigna 2021, seeded by SplitMix64.)
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/numerics/bits.hpp"

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
  return x == 0.0 ? 0 : bit_cast<std::uint64_t>(x);
}

/// One stream of random numbers.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view name);

  /// 64 uniform bits.
  std::uint64_t next_bits();

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform();

  /// Uniform integer in [0, count), without bias; `count` must be positive.
  std::uint64_t below(std::uint64_t count);
  /// The same as the place of one of `count` things.
  std::size_t place_below(std::size_t count) { return static_cast<std::size_t>(below(count)); }

  /// Fisher–Yates: every order equally likely.
  template <typename T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t left = items.size(); left > 1; --left) {
      const std::size_t chosen = place_below(left);
      std::swap(items[left - 1], items[chosen]);
    }
  }

 private:
  std::array<std::uint64_t, 4> state_;
};

/// A seed for `name` derived from `seed`, for what must be stored and used later (a trial's seed).
std::uint64_t derived_seed(std::uint64_t seed, std::string_view name);

}  // namespace impetus::inline numerics
