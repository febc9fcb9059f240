// Films as data: what each refresh of the screen had on it, and pictures that are those of the
// session, bit for bit.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/viewing/film_run.hpp"
#include "tests/experiments/small_study.hpp"

namespace impetus::film_test {

using Kind = FilmFrame::Kind;

constexpr std::int64_t kPeriod_ns = 16'666'667;

/// The flips of a grid: after each frame, `missed[i]` slots go by before the next.
std::vector<FrameRecord> flips(const std::vector<std::int64_t>& missed,
                               double period_ns = static_cast<double>(kPeriod_ns)) {
  FrameGrid grid(1e9 / period_ns);
  grid.restart(5'000'000'000);
  std::vector<FrameRecord> frames;
  for (const std::int64_t slots : missed) {
    FrameRecord& frame = frames.emplace_back();
    frame.frame = static_cast<std::int64_t>(frames.size()) - 1;
    const std::int64_t late_ns = std::llround(static_cast<double>(slots) * period_ns);
    frame.flip = grid.flipped(grid.next_due_ns(), grid.next_due_ns() + late_ns);
  }
  return frames;
}

Film film_of(std::vector<FrameRecord> frames) {
  Film film;
  film.frames = std::move(frames);
  return film;
}

/// "0 1 1= 2": a frame by its number, held ones with "=", blanks with "-".
std::string words(const Film& film) {
  std::string text;
  for (const FilmFrame& frame : film_frames(film)) {
    text += (text.empty() ? "" : " ") + std::to_string(frame.recorded);
    text += frame.kind == Kind::kHeld ? "=" : frame.kind == Kind::kBetween ? "-" : "";
  }
  EXPECT_EQ(refreshes(film), static_cast<double>(film_frames(film).size()));
  return text;
}

TEST(Film, HasEachFrameOnceWhereNoneWasLate) {
  EXPECT_EQ(words(film_of(flips({0, 0, 0, 0}))), "0 1 2 3");
}

TEST(Film, HoldsAFrameForAsManyRefreshesAsTheNextWasLate) {
  EXPECT_EQ(words(film_of(flips({0, 0, 1, 0}))), "0 1 1= 2 3");
  EXPECT_EQ(words(film_of(flips({0, 2, 1, 0}))), "0 0= 0= 1 1= 2 3");
}

TEST(Film, BeginsWithItsFirstFrameHoweverLate) {
  EXPECT_EQ(words(film_of(flips({3, 0, 0}))), "0 1 2");
}

TEST(Film, GainsAndLosesNothingByAScreenThatIsNotQuiteAtItsRate) {
  for (const double hz : {59.94, 60.06}) {
    const Film film = film_of(flips(std::vector<std::int64_t>(1200, 0), 1e9 / hz));
    EXPECT_EQ(refreshes(film), 1200.0) << hz << " Hz: over a refresh off in 20 s";
  }
}

TEST(Film, ShowsTheBlankBetweenTwoIntervals) {
  std::vector<FrameRecord> frames = flips({0, 0, 0, 0});
  for (std::size_t i = 2; i < frames.size(); ++i) {
    frames[i].interval = 2;
    frames[i].flip.scheduled_ns += 3 * kPeriod_ns;
    frames[i].flip.flipped_ns += 3 * kPeriod_ns;
  }
  EXPECT_EQ(words(film_of(frames)), "0 1 1- 1- 1- 2 3");
}

// ---------------------------------------------------------------- pictures

std::string number_words(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%a ", value);
  return text;
}

/// Every bit that the painter goes by and that moves.
std::string bits(const Picture& picture) {
  std::string text;
  for (const PosedBody& body : picture.bodies) {
    for (const double value :
         {body.pose.position.x(), body.pose.position.y(), body.pose.position.z(),
          body.pose.orientation.w(), body.pose.orientation.x(), body.pose.orientation.y(),
          body.pose.orientation.z(), body.look.radius_m}) {
      text += number_words(value);
    }
  }
  return text + number_words(picture.viewer.eye.x()) + number_words(picture.viewer.eye.y());
}

/// A session of a few trials, and the pictures of its stimuli in the order shown.
class FilmedSession : public ::testing::Test {
 protected:
  explicit FilmedSession() : lab_(75.0, small_protocol()) {
    plan_ = plan_for(lab_.protocol, "P01", 1);
    run_session(lab_.protocol.script, plan_, {}, lab_.ports(), lab_.protocol.design);
    for (const Picture& picture : lab_.display.pictures) {
      if (!picture.bodies.empty()) {
        shown_.push_back(bits(picture));
      }
    }
  }

  FilmedStimulus stimulus(const AttemptRecord& attempt) {
    const auto trial = std::find_if(plan_.begin(), plan_.end(), [&](const PlannedTrial& each) {
      return each.slot == attempt.slot;
    });
    return {lab_.scenes.stage(*trial, lab_.display.geometry()), attempt.steps};
  }

  /// Of all attempts, in order.
  std::vector<std::string> filmed() {
    std::vector<std::string> all;
    for (const AttemptRecord& attempt : lab_.recorder.attempts) {
      const FilmedStimulus of_attempt = stimulus(attempt);
      FilmRun run(of_attempt);
      for (const FrameRecord& frame : attempt.frames) {
        if (frame.phase == FramePhase::kStimulus) {
          run.advance(frame.shown_time_s);
          all.push_back(bits(run.picture(frame.shown_time_s)));
        }
      }
    }
    return all;
  }

  TestLab lab_;  ///< at 75 Hz, so that most frames lie between two steps of 240 Hz
  Plan plan_;
  std::vector<std::string> shown_;
};

TEST_F(FilmedSession, HasThePicturesThatWereShownBitForBit) {
  ASSERT_GT(shown_.size(), 500U);
  EXPECT_EQ(filmed(), shown_);
}

TEST_F(FilmedSession, DiffersWhereOneFrameWasShownAtAnotherTime) {
  lab_.recorder.attempts[1].frames[60].shown_time_s += 1e-6;
  const std::vector<std::string> other = filmed();
  ASSERT_EQ(other.size(), shown_.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < other.size(); ++i) {
    different += other[i] == shown_[i] ? 0 : 1;
  }
  EXPECT_EQ(different, 1U);
}

TEST_F(FilmedSession, TellsOfEachContactInTheFrameThatShowsItFirst) {
  for (const AttemptRecord& attempt : lab_.recorder.attempts) {
    const FilmedStimulus of_attempt = stimulus(attempt);
    FilmRun run(of_attempt);
    std::vector<std::int64_t> begun;
    for (const FrameRecord& frame : attempt.frames) {
      run.advance(frame.shown_time_s);
      for (const FilmedContact& contact : run.contacts()) {
        EXPECT_EQ(contact.truth.has_value(), contact.report.began);
        if (contact.report.began) {
          begun.push_back(contact.step);
        }
      }
    }
    ASSERT_EQ(attempt.collisions.size(), 1U);
    EXPECT_EQ(begun, std::vector<std::int64_t>{attempt.collisions.front().step});
  }
}

}  // namespace impetus::film_test
