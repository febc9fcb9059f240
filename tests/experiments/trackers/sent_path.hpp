// The path that the scripts in tests/trackers send, and whether samples are of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "experiments/settings/input_error.hpp"
#include "experiments/trackers/tracker_kinds.hpp"

namespace impetus {

inline constexpr std::int64_t kStep_ns = 5'000'000;  ///< sample n is taken at n times this
inline constexpr ScreenGeometry kScreen{0.4, 0.2, 800, 400, 0.6};

/// Once the script, which takes a moment to begin, answers.
inline std::shared_ptr<Tracker> opened(const std::string& url) {
  for (int tries = 0;; ++tries) {
    try {
      return open_tracker(url);
    } catch (const InputError&) {
      if (tries > 20) {
        throw;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
  }
}

/// Takes samples for so long, every 16 ms as a session does.
inline void look(Gaze& gaze, std::chrono::milliseconds how_long, std::vector<GazeSample>& samples) {
  const auto until = std::chrono::steady_clock::now() + how_long;
  while (std::chrono::steady_clock::now() < until) {
    for (const GazeSample& sample : gaze.take_samples()) {
      samples.push_back(sample);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
  }
}

inline std::int64_t number_of(const GazeSample& sample) {
  return (sample.taken_ns + kStep_ns / 2) / kStep_ns;
}

/// How far from the time at which it was taken it is stamped.
inline double error_ms(const GazeSample& sample) {
  return static_cast<double>(sample.taken_ns - number_of(sample) * kStep_ns) * 1e-6;
}

/// Whether it is what the script sent as this number.
inline void expect_sent(const GazeSample& sample) {
  const std::int64_t n = number_of(sample);
  EXPECT_LT(std::abs(error_ms(sample)), 1.0) << "sample " << n;
  const GazeLoss loss = n % 100 == 7   ? GazeLoss::kLost
                        : n % 100 == 8 ? GazeLoss::kOffScreen
                                       : GazeLoss::kNone;
  ASSERT_EQ(sample.loss, loss) << "sample " << n;
  ASSERT_EQ(sample.at.has_value(), loss == GazeLoss::kNone);
  if (sample.at) {
    // Metres right of and above the centre; five digits are sent of a share.
    EXPECT_NEAR(sample.at->x_m, (static_cast<double>(n % 200) / 200 - 0.5) * 0.4, 1e-5);
    EXPECT_NEAR(sample.at->y_m, (static_cast<double>(n / 200 % 200) / 200 - 0.5) * 0.2, 1e-5);
  }
}

}  // namespace impetus
