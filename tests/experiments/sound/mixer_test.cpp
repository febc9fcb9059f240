// Each onset on its sample, whatever the blocks; and what is late, too loud or too much.
// SPDX-License-Identifier: MIT
#include "experiments/sound/mixer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "experiments/sound/waveform.hpp"

namespace impetus::mixer_test {

const std::vector<float> kClick{1.0F, -0.5F, 0.25F};

/// A device that asks for blocks in time, or later by `jitter_ns` of the number of the call.
struct Device {
  Device(double hertz, std::int64_t size) : rate_hz(hertz), block(size), mixer(hertz) {}

  void run(std::int64_t calls) {
    for (std::int64_t i = 0; i < calls; ++i) {
      const auto due_ns = std::llround(static_cast<double>(std::ssize(stream)) * 1e9 / rate_hz);
      stream.resize(stream.size() + static_cast<std::size_t>(block));
      mixer.fill(std::span(stream).last(static_cast<std::size_t>(block)),
                 kBegin_ns + due_ns + (jitter_ns ? jitter_ns(call) : 0));
      ++call;
    }
  }

  /// When a sample leaves: a block after it was asked for.
  [[nodiscard]] std::int64_t leaves_ns(std::int64_t sample) const {
    return kBegin_ns + std::llround(static_cast<double>(sample + block) * 1e9 / rate_hz);
  }

  [[nodiscard]] std::int64_t first_heard() const {
    for (std::size_t i = 0; i < stream.size(); ++i) {
      if (stream[i] != 0.0F) {
        return static_cast<std::int64_t>(i);
      }
    }
    return -1;
  }

  static constexpr std::int64_t kBegin_ns = 7'000'000'000;
  double rate_hz;
  std::int64_t block;
  Mixer mixer;
  std::vector<float> stream;
  std::int64_t call{0};
  std::int64_t (*jitter_ns)(std::int64_t call){nullptr};
};

TEST(Mixer, PutsAnOnsetOnTheSampleOfItsInstantWhateverRateAndBlock) {
  for (const double rate_hz : {44100.0, 48000.0, 96000.0}) {
    for (const std::int64_t block : {1, 77, 256, 1024}) {
      for (const std::int64_t sample : {3000, 3001, 3327, 4095, 4096}) {
        Device device(rate_hz, block);
        device.run(1500 / block + 1);
        const std::int64_t at_ns = device.leaves_ns(sample);
        const auto number = device.mixer.play(kClick, at_ns, 0.5);
        device.run(5000 / block);
        ASSERT_EQ(device.first_heard(), sample) << rate_hz << " Hz, blocks of " << block;
        EXPECT_EQ(device.stream[static_cast<std::size_t>(sample)], 0.5F);
        EXPECT_EQ(device.stream[static_cast<std::size_t>(sample) + 1], -0.25F);
        EXPECT_EQ(device.stream[static_cast<std::size_t>(sample) + 3], 0.0F);
        ASSERT_TRUE(number && device.mixer.realised_ns(*number));
        EXPECT_NEAR(static_cast<double>(*device.mixer.realised_ns(*number) - at_ns), 0.0, 2.0);
      }
    }
  }
}

TEST(Mixer, GoesByTheCallsThatCameSoonest) {
  Device device(48000.0, 256);
  device.jitter_ns = [](std::int64_t call) -> std::int64_t {
    return call % 7 == 0 ? 0 : 1'000'000 * (call % 5);  // up to 4 ms late
  };
  device.run(50);
  device.mixer.play(kClick, device.leaves_ns(20'000), 1.0);
  device.run(50);
  EXPECT_EQ(device.first_heard(), 20'000);
}

TEST(Mixer, FollowsAStreamThatStoodStill) {
  Device device(48000.0, 256);
  device.run(100);
  device.jitter_ns = [](std::int64_t /*call*/) -> std::int64_t { return 30'000'000; };
  device.run(100);
  device.mixer.play(kClick, device.leaves_ns(60'000) + 30'000'000, 1.0);
  device.run(100);
  EXPECT_EQ(device.first_heard(), 60'000);
}

TEST(Mixer, PlaysWhatIsLateAtOnceAndSaysWhen) {
  Device device(48000.0, 256);
  device.run(10);
  const auto number = device.mixer.play(kClick, device.leaves_ns(100), 1.0);
  EXPECT_FALSE(device.mixer.realised_ns(*number));
  device.run(1);
  EXPECT_EQ(device.first_heard(), 2560);
  ASSERT_TRUE(device.mixer.realised_ns(*number));
  EXPECT_NEAR(static_cast<double>(*device.mixer.realised_ns(*number) - device.leaves_ns(2560)), 0.0,
              2.0);
}

TEST(Mixer, AddsWhatSoundsTogetherAndNeverLeavesTheScale) {
  Device device(48000.0, 256);
  device.run(1);
  for (int i = 0; i < 3; ++i) {
    device.mixer.play(kClick, device.leaves_ns(1000), 0.4);
  }
  device.run(8);
  EXPECT_EQ(device.stream[1000], 1.0F);  // 1.2 at full length
  EXPECT_NEAR(device.stream[1001], -0.6F, 1e-6F);
}

TEST(Mixer, RefusesMoreThanItHoldsAndGoesOnOnceTheyAreOver) {
  Device device(48000.0, 256);
  int taken = 0;
  while (device.mixer.play(kClick, device.leaves_ns(1000), 0.1)) {
    ++taken;
  }
  EXPECT_EQ(taken, 64);
  device.run(10);
  EXPECT_TRUE(device.mixer.play(kClick, device.leaves_ns(3000), 1.0));
  device.run(10);
  EXPECT_EQ(device.stream[3000], 1.0F);
}

// ---------------------------------------------------------------- what is played

double power_at(const std::vector<float>& samples, double hz, double rate_hz) {
  double cosine = 0.0;
  double sine = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double angle = 2.0 * M_PI * hz * static_cast<double>(i) / rate_hz;
    cosine += samples[i] * std::cos(angle);
    sine += samples[i] * std::sin(angle);
  }
  return cosine * cosine + sine * sine;
}

/// From the first sample to the last that is louder than a hundredth.
double lasts_s(const std::vector<float>& samples, double rate_hz) {
  std::size_t last = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    last = std::abs(samples[i]) > 0.01F ? i : last;
  }
  return static_cast<double>(last) / rate_hz;
}

SoundTask task(SoundKind kind) {
  SoundTask task;
  task.kind = kind;
  return task;
}

TEST(Waveform, OfATonesHasItsLengthItsPitchAndSoftEnds) {
  SoundTask asked = task(SoundKind::kTone);
  asked.frequency_hz = 440.0;
  asked.duration_ms = 50.0;
  const std::vector<float> samples = waveform_of(asked, 48000.0);
  EXPECT_EQ(samples.size(), 2400U);
  EXPECT_GT(power_at(samples, 440.0, 48000.0), 100.0 * power_at(samples, 660.0, 48000.0));
  EXPECT_LT(std::abs(samples.front()), 0.01F);
  EXPECT_LT(std::abs(samples.back()), 0.01F);
}

TEST(Waveform, OfWhatIsStruckBeginsAtOnceAndRingsAsItsMaterialDoes) {
  const double rate_hz = 48000.0;
  double before_s = 0.0;
  for (const SoundKind kind :
       {SoundKind::kRubber, SoundKind::kWood, SoundKind::kGlass, SoundKind::kMetal}) {
    const std::vector<float> samples = waveform_of(task(kind), rate_hz);
    ASSERT_FALSE(samples.empty());
    float loudest = 0.0F;
    float begin = 0.0F;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      loudest = std::max(loudest, std::abs(samples[i]));
      begin = i < 96 ? loudest : begin;  // in its first 2 ms
    }
    EXPECT_FLOAT_EQ(loudest, 1.0F);
    EXPECT_GT(begin, 0.8F);
    EXPECT_GT(lasts_s(samples, rate_hz), 1.5 * before_s);
    before_s = lasts_s(samples, rate_hz);
    EXPECT_LT(std::abs(samples.back()), 0.002F);
  }
  EXPECT_TRUE(waveform_of(task(SoundKind::kNone), rate_hz).empty());
}

}  // namespace impetus::mixer_test
