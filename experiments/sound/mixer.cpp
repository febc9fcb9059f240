// SPDX-License-Identifier: MIT
#include "experiments/sound/mixer.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline sound {

void StreamClock::called(std::int64_t first, std::int64_t count, std::int64_t called_ns) {
  // When sample 0 would have left by this call alone: `first` leaves a block after it is asked for.
  offsets_ns_[calls_++ % kCalls] =
      called_ns + std::llround(static_cast<double>(count - first) * ns_per_sample_);
  const std::size_t known = std::min(calls_, kCalls);
  offset_ns_ = *std::min_element(offsets_ns_.begin(),
                                 offsets_ns_.begin() + static_cast<std::ptrdiff_t>(known));
}

std::int64_t StreamClock::leaves_ns(std::int64_t sample) const {
  return offset_ns_ + std::llround(static_cast<double>(sample) * ns_per_sample_);
}

std::int64_t StreamClock::sample_at(std::int64_t at_ns) const {
  const double samples = static_cast<double>(at_ns - offset_ns_) / ns_per_sample_;
  return static_cast<std::int64_t>(std::ceil(samples - 1e-3));  // of rounding to nanoseconds
}

std::optional<std::int64_t> Mixer::play(std::span<const float> samples, std::int64_t at_ns,
                                        double loudness) {
  const Voice voice{samples, at_ns, static_cast<float>(loudness), numbers_ + 1, -1};
  if (!asked_.put(voice)) {
    return std::nullopt;
  }
  return ++numbers_;
}

std::optional<std::int64_t> Mixer::realised_ns(std::int64_t number) {
  while (const auto begun = begun_.take()) {
    known_.push_back(*begun);
  }
  const auto found = std::find_if(known_.begin(), known_.end(),
                                  [&](const Begun& begun) { return begun.number == number; });
  return found == known_.end() ? std::nullopt : std::optional(found->leaves_ns);
}

void Mixer::fill(std::span<float> block, std::int64_t called_ns) {
  const std::int64_t size = std::ssize(block);
  std::fill(block.begin(), block.end(), 0.0F);
  clock_.called(filled_, size, called_ns);
  for (Voice& free : voices_) {
    if (free.number == 0) {
      const auto asked = asked_.take();
      if (!asked) {
        break;
      }
      free = *asked;
    }
  }
  for (Voice& voice : voices_) {
    if (voice.number != 0) {
      begin(voice, size);
      add(voice, block);
      const bool is_over =
          voice.start >= 0 && voice.start + std::ssize(voice.samples) <= filled_ + size;
      voice.number = is_over ? 0 : voice.number;
    }
  }
  for (float& sample : block) {
    sample = std::clamp(sample, -1.0F, 1.0F);
  }
  filled_ += size;
}

/// Finds its place once it falls into the block; one that is late begins with it.
void Mixer::begin(Voice& voice, std::int64_t block_size) {
  if (voice.start >= 0) {
    return;
  }
  const std::int64_t start = std::max(clock_.sample_at(voice.at_ns), filled_);
  if (start < filled_ + block_size) {
    voice.start = start;
    static_cast<void>(begun_.put({voice.number, clock_.leaves_ns(start)}));
  }
}

void Mixer::add(const Voice& voice, std::span<float> block) const {
  if (voice.start < 0) {
    return;
  }
  const std::int64_t first = std::max<std::int64_t>(0, voice.start - filled_);
  for (std::int64_t i = first; i < std::ssize(block); ++i) {
    const std::int64_t sample = filled_ + i - voice.start;
    if (sample >= std::ssize(voice.samples)) {
      break;
    }
    block[static_cast<std::size_t>(i)] +=
        voice.loudness * voice.samples[static_cast<std::size_t>(sample)];
  }
}

}  // namespace impetus::inline sound
