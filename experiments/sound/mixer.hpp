// Puts sounds into a device's stream, each onset on the sample that leaves at its instant.
//
//   play(at) ──queue──> fill(), in the device's thread ──queue──> realised(number)
//
//   calls     |   .|    . |  .|      the device asks for a block of samples; later or sooner,
//   offset    `---'----'---'         never too soon: the least of the last calls is its clock
//
// Sample n leaves at offset + n / rate + one block, which is what a device with two blocks plays
// while it asks for the next. What its driver and the loudspeaker add, software cannot know.
// Nothing here waits or takes memory once it is made.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace impetus::inline sound {

/// Hands values from one thread to one other, without waiting.
template <typename Value, std::size_t Size>
class Handover {
 public:
  /// Whether there was room.
  bool put(const Value& value) {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    if (end - begin_.load(std::memory_order_acquire) == Size) {
      return false;
    }
    values_[end % Size] = value;
    end_.store(end + 1, std::memory_order_release);
    return true;
  }

  std::optional<Value> take() {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) {
      return std::nullopt;
    }
    const Value value = values_[begin % Size];
    begin_.store(begin + 1, std::memory_order_release);
    return value;
  }

 private:
  std::array<Value, Size> values_{};
  std::atomic<std::size_t> begin_{0};
  std::atomic<std::size_t> end_{0};
};

/// When samples leave, by the times at which blocks were asked for.
class StreamClock {
 public:
  explicit StreamClock(double rate_hz) : ns_per_sample_(1e9 / rate_hz) {}

  /// A block of `count` samples from sample `first` on is asked for at `called_ns`.
  void called(std::int64_t first, std::int64_t count, std::int64_t called_ns);

  [[nodiscard]] std::int64_t leaves_ns(std::int64_t sample) const;
  /// The first that does not leave before.
  [[nodiscard]] std::int64_t sample_at(std::int64_t at_ns) const;

 private:
  static constexpr std::size_t kCalls = 64;

  double ns_per_sample_;
  std::array<std::int64_t, kCalls> offsets_ns_{};
  std::size_t calls_{0};
  std::int64_t offset_ns_{0};
};

/// The sounds of a stream. play() and realised_ns() are of one thread, fill() of another.
class Mixer {
 public:
  explicit Mixer(double rate_hz) : clock_(rate_hz) {}

  /// Plays the samples, which must stay as they are, from that instant on; its number, from 1.
  /// None: too many wait.
  std::optional<std::int64_t> play(std::span<const float> samples, std::int64_t at_ns,
                                   double loudness);

  /// When its first sample leaves; none: it was not in a block yet.
  std::optional<std::int64_t> realised_ns(std::int64_t number);

  /// Fills a block, mono; `called_ns` is now.
  void fill(std::span<float> block, std::int64_t called_ns);

 private:
  static constexpr std::size_t kMost = 64;

  /// A sound that is waited for, or heard.
  struct Voice {
    std::span<const float> samples;
    std::int64_t at_ns{0};
    float loudness{0.0F};
    std::int64_t number{0};
    std::int64_t start{-1};  ///< its first sample's number in the stream; −1: not known yet
  };
  /// When a sound's first sample leaves the device.
  struct Begun {
    std::int64_t number{0};
    std::int64_t leaves_ns{0};
  };

  void begin(Voice& voice, std::int64_t block_size);
  void add(const Voice& voice, std::span<float> block) const;

  StreamClock clock_;
  Handover<Voice, kMost> asked_;
  Handover<Begun, 4 * kMost> begun_;
  std::array<Voice, kMost> voices_{};  ///< number 0: free
  std::int64_t filled_{0};
  std::int64_t numbers_{0};
  std::vector<Begun> known_;  ///< of the thread that plays
};

}  // namespace impetus::inline sound
