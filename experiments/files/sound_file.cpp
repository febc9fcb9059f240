// SPDX-License-Identifier: MIT
#include "experiments/files/sound_file.hpp"

#include <sndfile.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "experiments/tables/number_text.hpp"

namespace impetus::inline files {
namespace {

constexpr double kLongest_s = 5.0;

[[noreturn]] void refuse_file(const std::filesystem::path& path, const std::string& problem) {
  throw std::runtime_error(path.string() + ": " + problem);
}

}  // namespace

SoundSamples load_sound(const std::filesystem::path& path) {
  SF_INFO info{};
  const std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> file(sf_open(path.c_str(), SFM_READ, &info),
                                                         sf_close);
  if (!file) {
    refuse_file(path, sf_strerror(nullptr));
  }
  const double lasts_s = static_cast<double>(info.frames) / info.samplerate;
  if (info.frames < 1 || lasts_s > kLongest_s) {
    const std::string words =
        printed("expected a sound of up to %g s, got one of %.3g s", kLongest_s, lasts_s);
    refuse_file(path, words);
  }
  const auto channels = static_cast<std::size_t>(info.channels);
  std::vector<float> all(static_cast<std::size_t>(info.frames) * channels);
  if (sf_readf_float(file.get(), all.data(), info.frames) != info.frames) {
    refuse_file(path, "expected as many samples as it says, got fewer");
  }
  SoundSamples samples{static_cast<double>(info.samplerate), {}};
  samples.values.resize(static_cast<std::size_t>(info.frames));
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!std::isfinite(all[i])) {
      refuse_file(path, "expected numbers, got one that is none");
    }
    samples.values[i / channels] += all[i] / static_cast<float>(channels);
  }
  return samples;
}

}  // namespace impetus::inline files
