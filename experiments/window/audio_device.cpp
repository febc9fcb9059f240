// SPDX-License-Identifier: MIT
#include "experiments/window/audio_device.hpp"

#include <SDL.h>

#include <algorithm>
#include <span>

#include "experiments/settings/input_error.hpp"
#include "experiments/sound/waveform.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline window {
namespace {

constexpr int kRate_hz = 48000;
constexpr int kBlock = 256;
constexpr int kStereo = 2;

[[noreturn]] void refuse_sound() {
  const std::string why = SDL_GetError();
  SDL_QuitSubSystem(SDL_INIT_AUDIO);
  throw InputError("expected a sound device, got none (" + why +
                   "); a session whose protocol has sounds goes on without one with --observer");
}

}  // namespace

/// Both are called by SDL, in threads of its own.
struct AudioDevice::Fill {
  static void block(void* given, Uint8* bytes, int size) {
    auto& device = *static_cast<AudioDevice*>(given);
    auto* samples = reinterpret_cast<float*>(bytes);
    const std::size_t count = static_cast<std::size_t>(size) / sizeof(float) / kStereo;
    const std::span<float> mono(device.block_.data(), std::min(count, device.block_.size()));
    device.mixer_->fill(mono, device.clock_.now_ns());
    for (std::size_t i = 0; i < mono.size(); ++i) {
      for (int channel = 0; channel < kStereo; ++channel) {
        samples[kStereo * i + static_cast<std::size_t>(channel)] = mono[i];
      }
    }
  }

  static int watch(void* given, SDL_Event* event) {
    auto& device = *static_cast<AudioDevice*>(given);
    if (event->type == SDL_AUDIODEVICEREMOVED && event->adevice.iscapture == 0 &&
        event->adevice.which == device.device_) {
      device.gone_ns_ = device.clock_.now_ns();
    }
    return 0;
  }
};

AudioDevice::AudioDevice() {
  if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) {
    refuse_sound();
  }
  SDL_AudioSpec wanted{};
  wanted.freq = kRate_hz;
  wanted.format = AUDIO_F32SYS;
  wanted.channels = kStereo;
  wanted.samples = kBlock;
  wanted.callback = Fill::block;
  wanted.userdata = this;
  SDL_AudioSpec got{};
  device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, &got,
                                SDL_AUDIO_ALLOW_FREQUENCY_CHANGE | SDL_AUDIO_ALLOW_SAMPLES_CHANGE);
  if (device_ == 0) {
    refuse_sound();
  }
  rate_hz_ = got.freq;
  block_.resize(got.samples);
  mixer_ = std::make_unique<Mixer>(rate_hz_);
  const std::string words =
      printed("%s, %d Hz, blocks of %d samples (%.1f ms)", SDL_GetCurrentAudioDriver(), got.freq,
              got.samples, 1e3 * got.samples / got.freq);
  description_ = words;
  SDL_AddEventWatch(Fill::watch, this);
  SDL_PauseAudioDevice(device_, 0);
}

AudioDevice::~AudioDevice() {
  SDL_DelEventWatch(Fill::watch, this);
  SDL_CloseAudioDevice(device_);
  SDL_QuitSubSystem(SDL_INIT_AUDIO);
}

AudioDevice::Key AudioDevice::key_of(const SoundTask& task) {
  const bool is_tone = task.kind == SoundKind::kTone;
  return {task.kind, is_tone ? task.frequency_hz : 0.0, is_tone ? task.duration_ms : 0.0,
          task.kind == SoundKind::kFile ? task.file : ""};
}

void AudioDevice::prepare(const SoundTask& task) {
  const auto [made, is_new] = waveforms_.try_emplace(key_of(task));
  if (is_new) {
    made->second = waveform_of(task, rate_hz_);
  }
}

std::int64_t AudioDevice::play(const SoundTask& task, std::int64_t at_ns, double loudness) {
  const auto made = waveforms_.find(key_of(task));
  return made == waveforms_.end() ? 0 : mixer_->play(made->second, at_ns, loudness).value_or(0);
}

std::optional<std::int64_t> AudioDevice::realised_ns(std::int64_t number) {
  const std::optional<std::int64_t> leaves_ns = mixer_->realised_ns(number);
  const std::int64_t gone_ns = gone_ns_;
  return leaves_ns && gone_ns != 0 && *leaves_ns > gone_ns ? std::nullopt : leaves_ns;
}

}  // namespace impetus::inline window
