// Vectors of doubles, several widths from one source.
//
// A function that works on lanes is written once, inlined into one function for each width, and the
// widest that the machine has is chosen at run time (in_lanes). Lanes never meet but by exact
// operations on bits, so every width gives the same bits as no vector at all; none of the
// instruction sets named here is asked to fuse a multiplication with an addition
// (-ffp-contract=off).
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

// What is inlined into the function of each width, and the functions of the wider ones.
#define IMPETUS_INLINED inline __attribute__((always_inline))
#if defined(__x86_64__)
#define IMPETUS_EIGHT_LANES __attribute__((target("avx512f")))
#define IMPETUS_FOUR_LANES __attribute__((target("avx2")))
#endif

namespace impetus::inline numerics {

/// Doubles of a block, whatever the width.
inline constexpr int kLanes = 8;

/// A bit for each lane; in memory, for GCC 12 would put a vector of them together lane by lane.
inline constexpr std::int64_t kBitOfLane[kLanes] = {1, 2, 4, 8, 16, 32, 64, 128};

/// How many doubles a vector holds.
enum class LaneWidth { kTwo = 2, kFour = 4, kEight = 8 };

/// The widest that this machine has instructions for.
inline LaneWidth widest_lanes() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) {
    return LaneWidth::kEight;
  }
  if (__builtin_cpu_supports("avx2")) {
    return LaneWidth::kFour;
  }
#endif
  return LaneWidth::kTwo;
}

/// A vector of so many doubles, and of as many bit patterns. They are passed by reference alone:
/// how they would be passed by value depends on the width.
template <int kWidth>
struct Vectors;
template <>
struct Vectors<1> {
  using Numbers = double;
  using Bits = std::int64_t;
};
template <>
struct Vectors<2> {
  using Numbers = double __attribute__((vector_size(16)));
  using Bits = std::int64_t __attribute__((vector_size(16)));
};
template <>
struct Vectors<4> {
  using Numbers = double __attribute__((vector_size(32)));
  using Bits = std::int64_t __attribute__((vector_size(32)));
};
template <>
struct Vectors<8> {
  using Numbers = double __attribute__((vector_size(64)));
  using Bits = std::int64_t __attribute__((vector_size(64)));
};

template <typename Numbers>
IMPETUS_INLINED void read(const double* from, Numbers& into) {
  std::memcpy(&into, from, sizeof into);
}

/// Each lane's own root, exactly rounded.
template <int kWidth>
IMPETUS_INLINED void take_roots(typename Vectors<kWidth>::Numbers& numbers) {
  double lanes[kWidth];
  std::memcpy(lanes, &numbers, sizeof lanes);
  for (int lane = 0; lane < kWidth; ++lane) {
    lanes[lane] = std::sqrt(lanes[lane]);
  }
  std::memcpy(&numbers, lanes, sizeof lanes);
}

#ifdef IMPETUS_EIGHT_LANES
template <typename Kernel>
IMPETUS_EIGHT_LANES auto in_eight_lanes(const Kernel& kernel) {
  return kernel.template operator()<8>();
}

template <typename Kernel>
IMPETUS_FOUR_LANES auto in_four_lanes(const Kernel& kernel) {
  return kernel.template operator()<4>();
}
#endif

/// `kernel.operator()<lanes>()`, which is to be always inlined, as it is compiled for so many
/// lanes. Precondition: the machine has them.
template <typename Kernel>
auto in_lanes([[maybe_unused]] LaneWidth width, const Kernel& kernel) {
#ifdef IMPETUS_EIGHT_LANES
  if (width == LaneWidth::kEight) {
    return in_eight_lanes(kernel);
  }
  if (width == LaneWidth::kFour) {
    return in_four_lanes(kernel);
  }
#endif
  return kernel.template operator()<2>();
}

}  // namespace impetus::inline numerics
