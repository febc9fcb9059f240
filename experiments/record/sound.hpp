// What a contact sounds like, when it is to be heard, and when it was handed to the sound device.
//
//   flips       onset ......... flip that shows the contact
//   sound                  <─ lag ─>|                       before it, or after it
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace impetus::inline record {

/// What sounds.
enum class SoundKind { kNone, kWood, kMetal, kGlass, kRubber, kTone, kFile };

/// A sound that was recorded, mono.
struct SoundSamples {
  double rate_hz{0.0};
  std::vector<float> values;  ///< full scale: -1 to 1
};

/// What a scene says of its sound.
struct SoundTask {
  SoundKind kind{SoundKind::kNone};
  double lag_ms{0.0};    ///< from the flip that shows a contact to its onset; below 0: before
  double loudness{0.5};  ///< of the first, as a share of what the device can give
  double frequency_hz{1000.0};      ///< of a tone
  double duration_ms{100.0};        ///< of a tone
  bool is_of_every_contact{false};  ///< louder and softer by impulse; else of the first alone
  std::optional<double> at_s;       ///< from onset, in place of contacts
  std::string file{};               ///< of kind kFile: its name
  std::shared_ptr<const SoundSamples> samples{};  ///< what it holds
};

/// One sound of a trial.
struct SoundRecord {
  std::optional<std::int64_t> step{};      ///< in which the contact began; none: it is of a time
  double lag_ms{0.0};                      ///< as asked for
  double loudness{0.0};                    ///< share of what the device can give
  std::optional<std::int64_t> shown_ns{};  ///< the flip that showed the contact; none: it never did
  std::int64_t intended_ns{0};             ///< its onset, as was foreseen when it was handed over
  /// When its first sample leaves the device's buffer; none: nobody heard it, or it is not known.
  std::optional<std::int64_t> realised_ns{};
  std::int64_t interval{1};  ///< of a two-interval trial, its first or second
};

/// Plays sounds; never waits.
class Sounds {
 public:
  virtual ~Sounds() = default;

  /// Makes what will be played, before a trial begins. May take some milliseconds.
  virtual void prepare(const SoundTask& task) = 0;

  /// Plays what was prepared for this task, from `at_ns` of the clock of flips on, or at once where
  /// that is past. Its number, for realised_ns().
  virtual std::int64_t play(const SoundTask& task, std::int64_t at_ns, double loudness) = 0;

  /// When its onset leaves the device's buffer; none: it has not begun, or the device is gone.
  virtual std::optional<std::int64_t> realised_ns(std::int64_t number) = 0;
};

/// Where nobody hears anything.
class NoSounds final : public Sounds {
 public:
  void prepare(const SoundTask& /*task*/) override {}
  std::int64_t play(const SoundTask& /*task*/, std::int64_t /*at_ns*/,
                    double /*loudness*/) override {
    return 0;
  }
  std::optional<std::int64_t> realised_ns(std::int64_t /*number*/) override { return {}; }
};

}  // namespace impetus::inline record
