// Gaze from a stream of the Lab Streaming Layer, whatever tracker sends it.
//
//   lsl://NAME?x=1&y=2&valid=3&origin=top     channels, from 1, of shares of the screen's sides
//
// What is no number, or whose channel `valid` is 0, is lost. Rows count from the top unless
// origin=bottom.
// SPDX-License-Identifier: MIT
#include <charconv>
#include <cmath>

#include "experiments/connections/loaded_library.hpp"
#include "experiments/connections/lsl.hpp"
#include "experiments/connections/tcp.hpp"
#include "experiments/trackers/tracker_kinds.hpp"

namespace impetus::inline trackers {
namespace {

constexpr double kFirst_s = 2.0;

/// Reads the stream of one name.
class LslLink final : public TrackerLink {
 public:
  explicit LslLink(const TrackerAddress& address)
      : inlet_(address.host, kFirst_s),
        x_(channel(address, "x", 1)),
        y_(channel(address, "y", 2)),
        valid_(channel(address, "valid", 0)),
        is_from_top_(origin_of(address) == "top") {
    clock_ = clock_within(kFirst_s);
  }

  void receive(int wait_ms, std::vector<Reading>& readings) override {
    try {
      clock_ = clock_within(0.0);
      for (auto sample = inlet_.pull(wait_ms / 1e3); sample; sample = inlet_.pull(0.0)) {
        if (const auto remote_ns = nanoseconds(sample->remote_s)) {
          readings.push_back(reading_of(sample->values, *remote_ns + clock_.offset_ns));
        }
      }
    } catch (const NotConnected& lost) {
      throw TrackerGone(lost.what());
    }
  }

  [[nodiscard]] ClockEstimate clock() const override { return clock_; }

 private:
  /// From 1; 0: there is none.
  std::size_t channel(const TrackerAddress& address, const char* key, std::size_t otherwise) {
    const auto given = address.options.find(key);
    std::size_t number = otherwise;
    if (given != address.options.end()) {
      const std::string& words = given->second;
      const auto read = std::from_chars(words.data(), words.data() + words.size(), number);
      number = read.ec == std::errc{} && read.ptr == words.data() + words.size() ? number : 0;
    }
    if ((number == 0 && given != address.options.end()) || number > inlet_.channels()) {
      refuse_tracker(address.url, std::string(key) + ": a channel from 1 to " +
                                      std::to_string(inlet_.channels()) + ", which the stream has");
    }
    return number;
  }

  static std::string origin_of(const TrackerAddress& address) {
    const auto given = address.options.find("origin");
    const std::string origin = given == address.options.end() ? "top" : given->second;
    if (origin != "top" && origin != "bottom") {
      refuse_tracker(address.url, "origin=top or origin=bottom");
    }
    return origin;
  }

  ClockEstimate clock_within(double longest_s) {
    try {
      const LslInlet::Correction known = inlet_.correction(longest_s);
      return {std::llround(known.offset_s * 1e9), std::llround(known.uncertainty_s * 1e9)};
    } catch (const NotConnected&) {
      if (longest_s > 0.0) {
        throw;
      }
      return clock_;  // what was known stays
    }
  }

  [[nodiscard]] Reading reading_of(const std::vector<double>& values, std::int64_t taken_ns) const {
    const double x = values[x_ - 1];
    const double y = values[y_ - 1];
    const bool is_valid =
        valid_ == 0 || (std::isfinite(values[valid_ - 1]) && values[valid_ - 1] != 0.0);
    if (!is_valid || !std::isfinite(x) || !std::isfinite(y)) {
      return {taken_ns, 0.0, 0.0, GazeLoss::kLost};
    }
    const bool is_on = x >= 0.0 && x <= 1.0 && y >= 0.0 && y <= 1.0;
    return {taken_ns, x, is_from_top_ ? 1.0 - y : y,
            is_on ? GazeLoss::kNone : GazeLoss::kOffScreen};
  }

  LslInlet inlet_;
  std::size_t x_;
  std::size_t y_;
  std::size_t valid_;
  bool is_from_top_;
  ClockEstimate clock_;
};

std::unique_ptr<TrackerLink> connect_lsl(const TrackerAddress& address) {
  try {
    return std::make_unique<LslLink>(address);
  } catch (const NoSuchLibrary& missing) {
    refuse_tracker(address.url, std::string("the library liblsl, but ") + missing.what() +
                                    "; Debian has none: github.com/sccn/liblsl");
  } catch (const NotConnected& nobody) {
    refuse_tracker(address.url,
                   "a stream " + address.host + " on this network, got none: " + nobody.what());
  }
}

}  // namespace

const TrackerKind& lsl_tracker() {
  static const TrackerKind kind{"lsl", "LSL", 1, {"x", "y", "valid", "origin"}, connect_lsl};
  return kind;
}

}  // namespace impetus::inline trackers
