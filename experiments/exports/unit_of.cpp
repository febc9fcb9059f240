// SPDX-License-Identifier: MIT
#include "experiments/exports/unit_of.hpp"

#include <array>

namespace impetus::inline exports {
namespace {

struct Suffix {
  std::string_view ending;
  const char* unit;
};

/// The longer ones before those that they end with.
constexpr std::array<Suffix, 14> kSuffixes{{{"_rad_s", "rad/s"},
                                            {"_deg_s", "deg/s"},
                                            {"_m_s", "m/s"},
                                            {"_arcmin", "arcmin"},
                                            {"_deg", "deg"},
                                            {"_Ns", "N s"},
                                            {"_ms", "ms"},
                                            {"_ns", "ns"},
                                            {"_hz", "Hz"},
                                            {"_px", "px"},
                                            {"_s", "s"},
                                            {"_m", "m"},
                                            {"_utc", "ISO 8601, UTC"},
                                            {"_share", "share, 0 to 1"}}};

}  // namespace

std::string unit_of(std::string_view column) {
  for (const Suffix& suffix : kSuffixes) {
    if (column.ends_with(suffix.ending)) {
      return suffix.unit;
    }
  }
  return "";
}

}  // namespace impetus::inline exports
