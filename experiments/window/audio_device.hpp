// The sound device of this machine, by SDL.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/record/ports.hpp"
#include "experiments/record/sound.hpp"
#include "experiments/sound/mixer.hpp"

namespace impetus::inline window {

/// Plays on the default device. What it plays is made by prepare() and kept.
class AudioDevice final : public Sounds {
 public:
  /// Opens it, silent. Throws InputError where there is none.
  AudioDevice();
  ~AudioDevice() override;
  AudioDevice(const AudioDevice&) = delete;
  AudioDevice& operator=(const AudioDevice&) = delete;

  void prepare(const SoundTask& task) override;
  std::int64_t play(const SoundTask& task, std::int64_t at_ns, double loudness) override;
  std::optional<std::int64_t> realised_ns(std::int64_t number) override;

  /// "pulseaudio, 48000 Hz, blocks of 256 samples (5.3 ms)".
  [[nodiscard]] std::string description() const { return description_; }
  /// Whether it was taken away.
  [[nodiscard]] bool is_gone() const { return gone_ns_ != 0; }

 private:
  struct Fill;  ///< what SDL calls
  using Key = std::tuple<SoundKind, double, double, std::string>;
  static Key key_of(const SoundTask& task);

  SteadyClock clock_;
  std::uint32_t device_{0};
  double rate_hz_{0.0};
  std::string description_;
  std::unique_ptr<Mixer> mixer_;
  std::vector<float> block_;                     ///< of the device's thread
  std::map<Key, std::vector<float>> waveforms_;  ///< never moved or changed once made
  std::atomic<std::int64_t> gone_ns_{0};         ///< when it was taken away; 0: it is there
};

}  // namespace impetus::inline window
