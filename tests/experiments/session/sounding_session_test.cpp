// When a session has sounds played, whatever the lag; what it keeps of them; and that nothing else
// changes.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/session/session.hpp"
#include "tests/experiments/fakes.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::sounding_session_test {

/// Begins each sound at its instant, or at once where it is past.
class WatchedSounds final : public Sounds {
 public:
  explicit WatchedSounds(const VirtualClock& clock) : clock_(&clock) {}

  void prepare(const SoundTask& task) override { prepared.push_back(task); }
  std::int64_t play(const SoundTask& task, std::int64_t at_ns, double loudness) override {
    played.push_back(task);
    begun.push_back(std::max(at_ns, clock_->now_ns()));
    handed_over_ns.push_back(clock_->now_ns());
    loudnesses.push_back(loudness);
    return static_cast<std::int64_t>(begun.size());
  }
  std::optional<std::int64_t> realised_ns(std::int64_t number) override {
    return begun[static_cast<std::size_t>(number) - 1];
  }

  std::vector<SoundTask> prepared;
  std::vector<SoundTask> played;
  std::vector<std::int64_t> begun;
  std::vector<std::int64_t> handed_over_ns;
  std::vector<double> loudnesses;

 private:
  const VirtualClock* clock_;
};

/// Causality with this sound in its scene: contact a second after onset.
Protocol sounding(const nlohmann::json& sound) {
  const std::string file = source_file("protocols/causality.json").string();
  const std::string scene_file = source_file("stimuli/two-spheres.json").string();
  nlohmann::json scene = nlohmann::json::parse(text_of(scene_file));
  scene["sound"] = sound;
  return make_protocol({file, text_of(file), nlohmann::json::parse(text_of(file))},
                       {scene_file, scene.dump(), scene});
}

std::vector<AttemptRecord> attempts_of(TestLab& lab, Sounds* sounds) {
  Ports ports = lab.ports();
  ports.sounds = sounds;
  run_session(lab.protocol.script, short_plan(lab.protocol, 3), {}, ports);
  return lab.recorder.attempts;
}

TEST(SoundingSession, PlaysAtEachLagFromTheFlipThatShowsTheContact) {
  for (const double lag_ms : {-400.0, -250.0, -16.0, 0.0, 150.0, 250.0}) {
    SCOPED_TRACE(lag_ms);
    TestLab lab(60.0, sounding({{"kind", "wood"}, {"lag_ms", lag_ms}}));
    WatchedSounds sounds(lab.clock);
    const std::vector<AttemptRecord> attempts = attempts_of(lab, &sounds);
    ASSERT_EQ(attempts.size(), 5U);
    for (const AttemptRecord& attempt : attempts) {
      ASSERT_EQ(attempt.sounds.size(), 1U);
      const SoundRecord& sound = attempt.sounds.front();
      EXPECT_EQ(sound.step, attempt.collisions.front().step);
      EXPECT_EQ(sound.lag_ms, lag_ms);
      EXPECT_EQ(sound.loudness, 0.5);
      const auto shown = attempt.collisions.front().first_frame_shown;
      ASSERT_GE(shown, 0);
      ASSERT_TRUE(sound.shown_ns);
      EXPECT_NEAR(static_cast<double>(*sound.shown_ns - attempt.onset_ns) / 1e6, 1000.0, 1e-3);
      ASSERT_TRUE(sound.realised_ns);
      EXPECT_NEAR(static_cast<double>(*sound.realised_ns - *sound.shown_ns) / 1e6, lag_ms, 1e-3);
      EXPECT_EQ(sound.intended_ns, sound.realised_ns);
    }
    for (std::size_t i = 0; i < sounds.begun.size(); ++i) {  // so late frames still move both
      EXPECT_LE(sounds.begun[i] - sounds.handed_over_ns[i], 100'000'000);
    }
  }
}

TEST(SoundingSession, PlaysAtATimeWhereNothingTouches) {
  TestLab lab(60.0, sounding({{"kind", "tone"}, {"at_s", 0.5}, {"lag_ms", 100}}));
  WatchedSounds sounds(lab.clock);
  const std::vector<AttemptRecord> attempts = attempts_of(lab, &sounds);
  ASSERT_FALSE(attempts.empty());
  for (const AttemptRecord& attempt : attempts) {
    ASSERT_EQ(attempt.sounds.size(), 1U);
    EXPECT_FALSE(attempt.sounds.front().step);
    EXPECT_NEAR(static_cast<double>(*attempt.sounds.front().realised_ns - attempt.onset_ns) / 1e6,
                600.0, 1e-3);
  }
}

TEST(SoundingSession, IsSilentWhereTheSceneSaysSoOrHasNoSound) {
  TestLab silent(60.0, sounding({{"kind", "none"}}));
  WatchedSounds sounds(silent.clock);
  for (const AttemptRecord& attempt : attempts_of(silent, &sounds)) {
    EXPECT_TRUE(attempt.sounds.empty());
  }
  EXPECT_TRUE(sounds.begun.empty());
  TestLab without;
  for (const AttemptRecord& attempt : attempts_of(without, &sounds)) {
    EXPECT_TRUE(attempt.sounds.empty());
  }
}

TEST(SoundingSession, ChangesNoStep) {
  TestLab heard(60.0, sounding({{"kind", "glass"}, {"lag_ms", -100}}));
  WatchedSounds sounds(heard.clock);
  const std::vector<AttemptRecord> with = attempts_of(heard, &sounds);
  TestLab lab;
  const std::vector<AttemptRecord> without = attempts_of(lab, nullptr);
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t i = 0; i < with.size(); ++i) {
    ASSERT_EQ(with[i].steps.size(), without[i].steps.size());
    for (std::size_t step = 0; step < with[i].steps.size(); ++step) {
      ASSERT_EQ(with[i].steps[step].state.hash, without[i].steps[step].state.hash);
    }
  }
}

TEST(SoundOfAScene, IsRefusedInASentenceWhereItCannotBe) {
  EXPECT_EQ(refusal([] {
              sounding({{"kind", "wood"}, {"at_s", 1.0}, {"every_contact", true}});
            }),
            source_file("stimuli/two-spheres.json").string() +
                ":/sound/at_s: expected none beside every_contact");
  EXPECT_NE(refusal([] {
              sounding({{"kind", "gong"}});
            }).find("/sound/kind: expected"),
            std::string::npos);
  const std::string file = source_file("protocols/gaze-contingent.json").string();
  const std::string scene_file = source_file("stimuli/l-blocks-in-a-cube.json").string();
  nlohmann::json scene = nlohmann::json::parse(text_of(scene_file));
  scene["sound"] = {{"kind", "wood"}, {"lag_ms", -50}};
  EXPECT_NE(
      refusal([&] {
        make_protocol({file, text_of(file), nlohmann::json::parse(text_of(file))},
                      {scene_file, scene.dump(), scene});
      })
          .find("expected 0 or more where the gaze or a budget in milliseconds "
                "decides the steps, for nobody knows such a contact before it comes, got -50"),
      std::string::npos);
}

}  // namespace impetus::sounding_session_test
