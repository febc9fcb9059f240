// The bits of a number: as another type, and how many are set. The standard library's std::bit_cast
// may be missing, since browsers' compilers have an older one; its std::popcount is a call where no
// instruction for it may be assumed.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <type_traits>

namespace impetus::inline numerics {

/// A To with the bits of `from`.
template <typename To, typename From>
constexpr To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> &&
                std::is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}

/// How many are set.
inline std::int64_t bits_in(std::uint64_t bits) {
  bits -= (bits >> 1) & 0x5555555555555555;
  bits = (bits & 0x3333333333333333) + ((bits >> 2) & 0x3333333333333333);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0f;
  return static_cast<std::int64_t>((bits * 0x0101010101010101) >> 56);
}

}  // namespace impetus::inline numerics
