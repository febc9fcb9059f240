// A portable random generator with one named stream per purpose.
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

namespace impetus::inline numerics {

class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view name);

  /// 64 uniform bits.
  std::uint64_t next_bits();

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform();

  /// Uniform integer in [0, count), without bias; `count` must be positive.
  std::uint64_t below(std::uint64_t count);

  /// Fisher–Yates: every order equally likely.
  template <typename T>
  void shuffle(std::vector<T>& items) {
    for (std::uint64_t left = items.size(); left > 1; --left) {
      const std::uint64_t chosen = below(left);
      std::swap(items[left - 1], items[chosen]);
    }
  }

 private:
  std::array<std::uint64_t, 4> state_;
};

/// A seed for `name` derived from `seed`, for what must be stored and used later (a trial's seed).
std::uint64_t derived_seed(std::uint64_t seed, std::string_view name);

}  // namespace impetus::inline numerics
