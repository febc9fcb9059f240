// The Lab Streaming Layer, by a liblsl that the lab has: `--gaze lsl://NAME` reads a stream,
// `--markers lsl://NAME` is one. (Kothe et al. 2025; github.com/sccn/liblsl, version 1.16 or later)
//
// Its clock, lsl_local_clock(), is std::chrono::steady_clock in seconds: that of flips.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace impetus::inline connections {

/// A stream of numbers that somebody else sends.
class LslInlet {
 public:
  /// Looks for a stream of this name. Throws NoSuchLibrary, and NotConnected where there is none
  /// within that time.
  LslInlet(const std::string& name, double longest_s);

  [[nodiscard]] std::size_t channels() const { return channels_; }

  /// A value for each channel, and when they were taken.
  struct Sample {
    double remote_s{0.0};  ///< by the sender's clock
    std::vector<double> values;
  };
  /// The next, which is waited for; none: it did not come.
  std::optional<Sample> pull(double longest_s);

  /// What is added to the sender's time to have this machine's, and how far that may be off.
  struct Correction {
    double offset_s{0.0};
    double uncertainty_s{0.0};
  };
  /// Throws NotConnected where it is not known within that time.
  Correction correction(double longest_s);

 private:
  std::unique_ptr<void, void (*)(void*)> inlet_;
  std::size_t channels_{0};
};

/// A stream of texts, for whoever records it.
class LslOutlet {
 public:
  /// Throws NoSuchLibrary.
  LslOutlet(const std::string& name, const std::string& type);

  /// Whether it was taken; `at_ns` is of SteadyClock.
  bool push(const std::string& text, std::int64_t at_ns);

 private:
  std::unique_ptr<void, void (*)(void*)> outlet_;
};

}  // namespace impetus::inline connections
