// SPDX-License-Identifier: MIT
#include "experiments/sound/waveform.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace impetus::inline sound {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLongest_s = 1.5;

/// Its lowest mode, and how fast modes die away.
struct Struck {
  double lowest_hz;
  double damping;  ///< tan φ, of the material's internal friction
};

Struck struck(SoundKind kind) {
  switch (kind) {
    case SoundKind::kWood:
      return {600.0, 0.02};
    case SoundKind::kMetal:
      return {1100.0, 0.0008};
    case SoundKind::kGlass:
      return {2200.0, 0.002};
    default:
      return {300.0, 0.1};  // rubber
  }
}

void scale_to_one(std::vector<float>& samples) {
  float loudest = 0.0F;
  for (const float sample : samples) {
    loudest = std::max(loudest, std::abs(sample));
  }
  for (float& sample : samples) {
    sample /= std::max(loudest, 1e-9F);
  }
}

/// Begins at full strength, as what is struck does; ends in silence.
std::vector<float> struck_samples(const Struck& what, double rate_hz) {
  constexpr std::array kRatios{1.0, 2.756, 5.404, 8.933};
  const double quiet_s = std::log(1000.0) / (kPi * what.lowest_hz * what.damping);
  const double lasts_s = std::min(quiet_s, kLongest_s);
  std::vector<float> samples(static_cast<std::size_t>(std::ceil(lasts_s * rate_hz)));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double time_s = (static_cast<double>(i) + 0.5) / rate_hz;
    double sum = 0.0;
    for (std::size_t mode = 0; mode < kRatios.size(); ++mode) {
      const double hz = what.lowest_hz * kRatios[mode];
      if (hz < 0.45 * rate_hz) {
        sum += std::exp(-kPi * hz * what.damping * time_s) * std::sin(2.0 * kPi * hz * time_s) /
               static_cast<double>(mode + 1);
      }
    }
    constexpr double kFade_s = 0.005;
    samples[i] = static_cast<float>(sum * std::min(1.0, (lasts_s - time_s) / kFade_s));
  }
  scale_to_one(samples);
  return samples;
}

/// Between two samples, on the line between them.
std::vector<float> resampled(const SoundSamples& recorded, double rate_hz) {
  if (recorded.rate_hz == rate_hz || recorded.values.empty()) {
    return recorded.values;
  }
  const double step = recorded.rate_hz / rate_hz;
  const double last = static_cast<double>(recorded.values.size() - 1);
  std::vector<float> samples(static_cast<std::size_t>(std::floor(last / step)) + 1);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double place = std::min(static_cast<double>(i) * step, last);
    const auto before = static_cast<std::size_t>(place);
    const std::size_t after = std::min(before + 1, recorded.values.size() - 1);
    const auto share = static_cast<float>(place - static_cast<double>(before));
    samples[i] = (1.0F - share) * recorded.values[before] + share * recorded.values[after];
  }
  return samples;
}

std::vector<float> tone_samples(const SoundTask& task, double rate_hz) {
  const double lasts_s = task.duration_ms / 1e3;
  const double ramp_s = std::min(0.002, 0.5 * lasts_s);
  std::vector<float> samples(
      static_cast<std::size_t>(std::max(1.0, std::round(lasts_s * rate_hz))));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double time_s = (static_cast<double>(i) + 0.5) / rate_hz;
    const double from_end_s = std::min({time_s, lasts_s - time_s, ramp_s});
    const double ramp = 0.5 - 0.5 * std::cos(kPi * std::max(0.0, from_end_s) / ramp_s);
    samples[i] = static_cast<float>(ramp * std::sin(2.0 * kPi * task.frequency_hz * time_s));
  }
  return samples;
}

}  // namespace

std::vector<float> waveform_of(const SoundTask& task, double rate_hz) {
  switch (task.kind) {
    case SoundKind::kNone:
      return {};
    case SoundKind::kTone:
      return tone_samples(task, rate_hz);
    case SoundKind::kFile:
      return task.samples ? resampled(*task.samples, rate_hz) : std::vector<float>();
    default:
      return struck_samples(struck(task.kind), rate_hz);
  }
}

}  // namespace impetus::inline sound
