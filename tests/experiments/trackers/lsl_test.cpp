// Gaze from a stream of the Lab Streaming Layer, and markers into one, by a library that stands in
// for liblsl, which Debian has not.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "experiments/connections/loaded_library.hpp"
#include "experiments/markers/marker_line.hpp"
#include "tests/experiments/refusals.hpp"
#include "tests/experiments/temporary_folder.hpp"
#include "tests/experiments/trackers/sent_path.hpp"

namespace impetus::lsl_test {

/// What liblsl is in this process.
class Lsl : public testing::Test {
 protected:
  Lsl() {
    setenv("PYLSL_LIB", IMPETUS_LSL_STAND_IN, 1);
    setenv("LSL_STAND_IN_LOG", (folder_ / "pushed").c_str(), 1);
  }

  std::vector<std::string> pushed() {
    std::ifstream file(folder_ / "pushed");
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) {
      lines.push_back(line);
    }
    return lines;
  }

  TemporaryFolder folder_;
};

TEST_F(Lsl, SendsEverySampleInOrderByThisMachinesClock) {
  const std::shared_ptr<Tracker> tracker = open_tracker("lsl://gaze?valid=4");
  TrackedEye eye(tracker, kScreen);
  std::vector<GazeSample> samples;
  look(eye, std::chrono::milliseconds(1500), samples);
  ASSERT_GT(samples.size(), 200U);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    expect_sent(samples[i]);
    if (i > 0) {
      ASSERT_EQ(number_of(samples[i]), number_of(samples[i - 1]) + 1);
    }
  }
  EXPECT_EQ(eye.source(), "LSL");
  EXPECT_EQ(tracker->clock_words(),
            "LSL's clock plus -1234.500000 s is this machine's, known to 0.200 ms");
}

TEST_F(Lsl, HasChannelsAndAnOriginOfChoice) {
  const std::shared_ptr<Tracker> tracker = open_tracker("lsl://gaze?x=2&y=1&valid=4&origin=bottom");
  TrackedEye eye(tracker, kScreen);
  std::vector<GazeSample> samples;
  look(eye, std::chrono::milliseconds(300), samples);
  ASSERT_FALSE(samples.empty());
  for (const GazeSample& sample : samples) {
    const std::int64_t n = number_of(sample);
    if (sample.at) {
      EXPECT_NEAR(sample.at->y_m, (static_cast<double>(n % 200) / 200 - 0.5) * 0.2, 1e-9);
      EXPECT_NEAR(sample.at->x_m, (0.5 - static_cast<double>(n / 200 % 200) / 200) * 0.4, 1e-9);
    }
  }
}

TEST_F(Lsl, RefusesInOneSentence) {
  EXPECT_EQ(refusal([] { open_tracker("lsl://nobody"); }),
            "--gaze lsl://nobody: expected a stream nobody on this network, got none: no stream of "
            "that name");
  EXPECT_EQ(refusal([] { open_tracker("lsl://gaze?x=5"); }),
            "--gaze lsl://gaze?x=5: expected x: a channel from 1 to 4, which the stream has");
  EXPECT_EQ(refusal([] { open_tracker("lsl://gaze?origin=left"); }),
            "--gaze lsl://gaze?origin=left: expected origin=top or origin=bottom");
  EXPECT_EQ(refusal([] { open_marker_line("lsl://"); }),
            "--markers: expected lsl://NAME, the name of the stream, got lsl://");
  EXPECT_THROW(LoadedLibrary({"libnone.so"}), NoSuchLibrary);
}

TEST_F(Lsl, TakesMarkersStampedByTheirFlips) {
  const std::unique_ptr<MarkerLine> line = open_marker_line("lsl://impetus");
  EXPECT_TRUE(line->write(MarkedEvent::kOnset, 20, 1'500'000'000));
  EXPECT_TRUE(line->write(MarkedEvent::kContact, 30, 2'500'000'001));
  EXPECT_EQ(pushed(), (std::vector<std::string>{"impetus Markers 20 onset 1.500000000",
                                                "impetus Markers 30 contact 2.500000001"}));
}

}  // namespace impetus::lsl_test
