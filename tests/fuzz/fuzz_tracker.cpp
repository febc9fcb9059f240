// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdlib>

#include "experiments/trackers/gazepoint.hpp"
#include "experiments/trackers/pupil.hpp"
#include "tests/fuzz/targets.hpp"

namespace impetus {
namespace {

/// What is not lost has a place.
void expect_place(const Reading& reading) {
  if (reading.loss == GazeLoss::kNone &&
      !(std::isfinite(reading.x_share) && std::isfinite(reading.y_share))) {
    std::abort();
  }
}

/// In pieces of so many bytes, as TCP may cut them.
void feed_gazepoint(std::string_view bytes, std::size_t piece) {
  std::string pending;
  for (std::size_t start = 0; start < bytes.size(); start += piece) {
    for (const std::string& line : take_lines(pending, std::string(bytes.substr(start, piece)))) {
      if (const auto record = gazepoint_record(line)) {
        expect_place(record->reading);
      }
    }
  }
}

}  // namespace

void fuzz_tracker(std::string_view bytes) {
  if (bytes.empty()) {
    return;
  }
  const auto first = static_cast<unsigned char>(bytes.front());
  const std::string_view rest = bytes.substr(1);
  if (first != kPupilMessage) {
    feed_gazepoint(rest, std::size_t{first} + 1);
    return;
  }
  for (const Reading& reading : surface_readings(std::string(rest), "screen", {1000, 0})) {
    expect_place(reading);
  }
}

}  // namespace impetus
