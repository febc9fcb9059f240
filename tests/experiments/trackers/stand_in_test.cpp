// Trackers that scripts stand in for: every sample comes, where and when it was taken, and comes
// again after the tracker was killed.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "tests/experiments/trackers/sent_path.hpp"
#include "tests/experiments/trackers/stand_in.hpp"

namespace impetus::stand_in_test {

using namespace std::chrono_literals;

/// Each next to the one before.
void expect_all_sent(const std::vector<GazeSample>& samples, std::size_t from, std::size_t until) {
  double worst_ms = 0.0;
  for (std::size_t i = from; i < until; ++i) {
    expect_sent(samples[i]);
    worst_ms = std::max(worst_ms, std::abs(error_ms(samples[i])));
    if (i > from) {
      ASSERT_EQ(number_of(samples[i]), number_of(samples[i - 1]) + 1) << "sample " << i;
    }
  }
  std::printf("  %zu samples, stamped to %.3f ms\n", until - from, worst_ms);
}

/// The place of the one lost sample that stands in for silence.
std::optional<std::size_t> silence_in(const std::vector<GazeSample>& samples) {
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples[i].loss == GazeLoss::kLost && samples[i].taken_ns == samples[i - 1].taken_ns + 1) {
      return i;
    }
  }
  return std::nullopt;
}

void expect_survival(const std::string& script, const std::string& scheme) {
  const int port = free_port();
  const std::string url = scheme + "://127.0.0.1:" + std::to_string(port);
  auto stand_in = std::make_unique<StandIn>(script, port, "1234.5");
  const std::shared_ptr<Tracker> tracker = opened(url);
  TrackedEye eye(tracker, kScreen);
  std::printf("  %s\n", tracker->clock_words().c_str());
  std::vector<GazeSample> samples;
  look(eye, 2000ms, samples);
  stand_in.reset();
  look(eye, 600ms, samples);
  const std::optional<std::size_t> silence = silence_in(samples);
  ASSERT_TRUE(silence);
  EXPECT_EQ(*silence + 1, samples.size());  // said once
  EXPECT_EQ(tracker->silences(), 1);
  EXPECT_GT(*silence, 350U);  // of the 400 of two seconds
  expect_all_sent(samples, 0, *silence);

  // Its clock is another one now, as after a computer was started anew.
  stand_in = std::make_unique<StandIn>(script, port, "-77.25");
  for (int tries = 0; tries < 100 && samples.size() == *silence + 1; ++tries) {
    look(eye, 100ms, samples);
  }
  look(eye, 1000ms, samples);
  ASSERT_GT(samples.size(), *silence + 100);
  expect_all_sent(samples, *silence + 1, samples.size());
  EXPECT_EQ(tracker->silences(), 1);
  std::printf("  %s\n", tracker->clock_words().c_str());
}

TEST(TrackerStandIn, OfPupilSendsEverySampleInOrderToAMillisecondAndAfterItWasKilled) {
  if (!python_has("zmq, msgpack")) {
    GTEST_SKIP() << "needs python3-zmq and python3-msgpack";
  }
  expect_survival("pupil_stand_in.py", "pupil");
}

TEST(TrackerStandIn, OfGazepointSendsEverySampleInOrderToAMillisecondAndAfterItWasKilled) {
  if (!python_has("socket")) {
    GTEST_SKIP() << "needs python3";
  }
  expect_survival("gazepoint_stand_in.py", "gazepoint");
}

}  // namespace impetus::stand_in_test
