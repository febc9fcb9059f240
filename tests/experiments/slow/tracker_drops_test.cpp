// Trackers that go and come back, a thousand times.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <vector>

#include "tests/experiments/trackers/sent_path.hpp"
#include "tests/experiments/trackers/stand_in.hpp"

namespace impetus::tracker_drops_test {

constexpr std::int64_t kDrops = 1000;

/// The script closes its sockets whenever somebody has heard it for a moment.
/// `least` samples come between two drops.
void expect_survival(const std::string& script, const std::string& scheme, std::int64_t least) {
  const int port = free_port();
  const StandIn stand_in(script, port, "1234.5", "drops");
  const std::shared_ptr<Tracker> tracker = opened(scheme + "://127.0.0.1:" + std::to_string(port));
  TrackedEye eye(tracker, kScreen);
  const auto until = std::chrono::steady_clock::now() + std::chrono::minutes(30);
  std::int64_t count = 0;
  std::int64_t last_ns = 0;
  while (tracker->silences() < kDrops && std::chrono::steady_clock::now() < until) {
    std::vector<GazeSample> samples;
    look(eye, std::chrono::milliseconds(200), samples);
    for (const GazeSample& sample : samples) {
      ASSERT_GT(sample.taken_ns, last_ns);
      if (sample.taken_ns > last_ns + 1) {  // else it stands for silence
        expect_sent(sample);
        ++count;
      }
      last_ns = sample.taken_ns;
    }
  }
  EXPECT_GE(tracker->silences(), kDrops);
  EXPECT_GT(count, least * kDrops);
  std::printf("  %lld samples\n", static_cast<long long>(count));
}

TEST(TrackerDrops, OfPupilAreSurvivedAThousandTimes) {
  if (!python_has("zmq, msgpack")) {
    GTEST_SKIP() << "needs python3-zmq and python3-msgpack";
  }
  expect_survival("pupil_stand_in.py", "pupil", 20);
}

TEST(TrackerDrops, OfGazepointAreSurvivedAThousandTimes) {
  if (!python_has("socket")) {
    GTEST_SKIP() << "needs python3";
  }
  expect_survival("gazepoint_stand_in.py", "gazepoint", 55);
}

}  // namespace impetus::tracker_drops_test
