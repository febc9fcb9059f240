// What a session marks for another recorder: each event at its flip, before the next frame.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/session/session.hpp"
#include "tests/experiments/fakes.hpp"

namespace impetus::marked_session_test {

/// Keeps what is marked, and when it was told.
class WatchedMarkers final : public Markers {
 public:
  explicit WatchedMarkers(const VirtualClock& clock) : clock_(&clock) {}

  void mark(MarkedEvent event, std::int64_t event_ns, std::int64_t interval) override {
    records_.push_back({event, 1, event_ns, clock_->now_ns(), interval});
  }
  std::vector<MarkerRecord> take() override { return std::exchange(records_, {}); }

 private:
  const VirtualClock* clock_;
  std::vector<MarkerRecord> records_;
};

std::vector<AttemptRecord> marked_attempts(TestLab& lab, std::size_t main_trials) {
  WatchedMarkers markers(lab.clock);
  Ports ports = lab.ports();
  ports.markers = &markers;
  run_session(lab.protocol.script, short_plan(lab.protocol, main_trials), {}, ports);
  EXPECT_TRUE(markers.take().empty());
  return lab.recorder.attempts;
}

TEST(MarkedSession, MarksEachEventAtItsFlipBeforeTheNextFrame) {
  TestLab lab;
  const std::vector<AttemptRecord> attempts = marked_attempts(lab, 3);
  ASSERT_EQ(attempts.size(), 5U);
  for (const AttemptRecord& attempt : attempts) {
    ASSERT_EQ(attempt.markers.size(), 5U);
    const auto& [fixation, onset, contact, end, answer] =
        std::tie(attempt.markers[0], attempt.markers[1], attempt.markers[2], attempt.markers[3],
                 attempt.markers[4]);
    EXPECT_EQ(fixation.event, MarkedEvent::kFixation);
    EXPECT_EQ(fixation.event_ns, attempt.frames.front().flip.flipped_ns);
    EXPECT_EQ(onset.event, MarkedEvent::kOnset);
    EXPECT_EQ(onset.event_ns, attempt.onset_ns);
    EXPECT_EQ(contact.event, MarkedEvent::kContact);
    // A second after onset, by the frames of 60 Hz.
    EXPECT_NEAR(static_cast<double>(contact.event_ns - onset.event_ns) / 1e9, 1.0, 1e-6);
    EXPECT_EQ(end.event, MarkedEvent::kEnd);
    EXPECT_EQ(end.event_ns, attempt.frames.back().flip.flipped_ns);
    EXPECT_EQ(answer.event, MarkedEvent::kAnswer);
    EXPECT_EQ(answer.event_ns, attempt.ratings.front().arrived_ns);
    for (const MarkerRecord& marker : attempt.markers) {
      EXPECT_EQ(marker.written_ns, marker.event_ns);  // nothing was shown in between
    }
  }
}

TEST(MarkedSession, MarksClicksDuringTheStimulus) {
  nlohmann::json document = nlohmann::json::parse(text_of(source_file("protocols/causality.json")));
  document["clicks"] = {{"merge_within_ms", 100}, {"first_ends", true}};
  TestLab lab(60.0, protocol_from({"protocols/causality.json", document.dump(), document},
                                  source_file("protocols/causality.json")));
  lab.input.on_clicks = [&] { return std::vector<ClickRecord>{{"key", lab.clock.now_ns(), 0}}; };
  const std::vector<AttemptRecord> attempts = marked_attempts(lab, 1);
  ASSERT_FALSE(attempts.empty());
  const std::vector<MarkerRecord>& markers = attempts.front().markers;
  const auto click = std::find_if(markers.begin(), markers.end(), [](const MarkerRecord& one) {
    return one.event == MarkedEvent::kClick;
  });
  ASSERT_NE(click, markers.end());
  EXPECT_EQ(click->event_ns, attempts.front().clicks.front().arrived_ns);
  const auto ends = std::count_if(markers.begin(), markers.end(), [](const MarkerRecord& one) {
    return one.event == MarkedEvent::kEnd;
  });
  EXPECT_EQ(ends, 1);
}

TEST(MarkedSession, WithoutAnotherRecorderIsAsItWas) {
  TestLab lab;
  run_session(lab.protocol.script, short_plan(lab.protocol, 1), {}, lab.ports());
  for (const AttemptRecord& attempt : lab.recorder.attempts) {
    EXPECT_TRUE(attempt.markers.empty());
  }
}

}  // namespace impetus::marked_session_test
