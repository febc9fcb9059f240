// What pages of a session say, whatever the session.
// SPDX-License-Identifier: MIT
#include "experiments/questions/session_pages.hpp"

#include <gtest/gtest.h>

namespace impetus::session_pages_test {

TEST(SessionPages, WhoSeesNoCrossIsNotToldToLookAtIt) {
  const auto advice = [](double cross_ms) {
    Script script;
    script.timing.fixation = {cross_ms, cross_ms};
    return phase_intro(script, TrialPhase::kMain, 1, 8, {}).paragraphs.back();
  };
  EXPECT_EQ(advice(500.0), "Keep your eyes on the cross before each one. Esc pauses at any time.");
  EXPECT_EQ(advice(0.0), "Esc pauses at any time.");
}

}  // namespace impetus::session_pages_test
