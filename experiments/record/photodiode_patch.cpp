// SPDX-License-Identifier: MIT
#include "experiments/record/photodiode_patch.hpp"

#include <algorithm>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline record {
namespace {

using DataBits = std::array<std::uint8_t, static_cast<std::size_t>(kPatchPeriod)>;

constexpr DataBits data_bits() {
  DataBits bits{};
  std::uint32_t state = (1U << kPatchWord) - 1U;
  for (std::uint8_t& bit : bits) {
    bit = static_cast<std::uint8_t>(state & 1U);
    const std::uint32_t next = (state ^ (state >> 1U) ^ (state >> 4U) ^ (state >> 6U)) & 1U;
    state = (state >> 1U) | (next << (kPatchWord - 1));
  }
  return bits;
}

constexpr DataBits kDataBits = data_bits();

constexpr std::array<const char*, 4> kCornerNames{"top left", "top right", "bottom left",
                                                  "bottom right"};

}  // namespace

std::int64_t patch_code(std::int64_t frame) {
  const std::int64_t clock = 1 - frame % 2;
  return 2 * clock + kDataBits[static_cast<std::size_t>(frame % kPatchPeriod)];
}

float patch_grey(std::int64_t code) {
  // 0, 30, 70 and 100 % of white's light (IEC 61966-2-1).
  constexpr std::array<float, kPatchCodes> kGreys{0.0F, 0.584F, 0.854F, 1.0F};
  return kGreys[static_cast<std::size_t>(code)];
}

const char* name_of(ScreenCorner corner) { return kCornerNames[static_cast<std::size_t>(corner)]; }

std::optional<ScreenCorner> corner_named(std::string name) {
  std::replace(name.begin(), name.end(), '-', ' ');
  const auto found = std::find(kCornerNames.begin(), kCornerNames.end(), name);
  if (found == kCornerNames.end()) {
    return std::nullopt;
  }
  return static_cast<ScreenCorner>(found - kCornerNames.begin());
}

ScreenCorner patch_corner(const std::string& option, const std::string& name) {
  const auto corner = corner_named(name);
  if (!corner) {
    throw InputError(option + ": expected top left, top right, bottom left or bottom right, got " +
                     name);
  }
  return *corner;
}

}  // namespace impetus::inline record
