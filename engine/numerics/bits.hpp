// The bits of a number as another type, where the standard library's std::bit_cast may be missing:
// browsers' compilers have an older one.
// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

namespace impetus::inline numerics {

/// A To with the bits of `from`.
template <typename To, typename From>
constexpr To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> &&
                std::is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}

}  // namespace impetus::inline numerics
