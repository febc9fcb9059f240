// Markers: codes that tell another recorder, such as an EEG's amplifier, what happens when.
//
//   flip ─> mark(event, instant) ─> a thread ─> a port or a socket ─> the instant it was written
//
// Nothing waits for a marker: what marks is never on the way to the next frame.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace impetus::inline record {

/// What can be marked, and by which instant.
enum class MarkedEvent : std::uint8_t {
  kFixation,  ///< the flip that first shows the cross
  kOnset,     ///< the flip that first shows the stimulus
  kContact,   ///< the flip that first shows a collision
  kEnd,       ///< the flip that shows the stimulus for the last time
  kClick,     ///< the arrival of a click during the stimulus
  kAnswer     ///< the arrival of an answer
};

inline constexpr std::array<std::string_view, 6> kMarkedEvents{"fixation", "onset", "contact",
                                                               "end",      "click", "answer"};
[[nodiscard]] constexpr std::string_view name_of(MarkedEvent event) {
  return kMarkedEvents[static_cast<std::size_t>(event)];
}

/// The code of each event that is marked, from 1 to 255; none: that is not marked.
struct MarkerCodes {
  std::optional<std::int64_t> fixation{};
  std::optional<std::int64_t> onset{};
  std::optional<std::int64_t> contact{};
  std::optional<std::int64_t> end{};
  std::optional<std::int64_t> click{};
  std::optional<std::int64_t> answer{};

  [[nodiscard]] std::optional<std::int64_t> of(MarkedEvent event) const {
    const std::array codes{fixation, onset, contact, end, click, answer};
    return codes[static_cast<std::size_t>(event)];
  }
};

/// One marker of a trial.
struct MarkerRecord {
  MarkedEvent event{MarkedEvent::kOnset};
  std::int64_t code{0};
  std::int64_t event_ns{0};                  ///< when what it marks happened
  std::optional<std::int64_t> written_ns{};  ///< when the system had taken it; none: it did not
  std::int64_t interval{1};                  ///< of a two-interval trial, its first or second
};

/// Takes markers; what it is told of it sends at once, on a thread of its own.
class Markers {
 public:
  virtual ~Markers() = default;

  /// An event of the stimulus `interval` happened at `event_ns`. Returns at once. Nothing is sent
  /// of an event that has no code.
  virtual void mark(MarkedEvent event, std::int64_t event_ns, std::int64_t interval) = 0;

  /// What was marked since the last call, in that order, once it is sent; what is not sent within a
  /// tenth of a second is without its instant.
  virtual std::vector<MarkerRecord> take() = 0;
};

}  // namespace impetus::inline record
