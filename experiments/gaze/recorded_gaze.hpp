// A recorded gaze, played again: each sample comes as long after the stimulus's onset as it did
// then.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/record/gaze.hpp"
#include "experiments/record/ports.hpp"

namespace impetus::inline gaze {

class RecordedGaze final : public Gaze {
 public:
  /// `samples` in order of time, with `onset_ns` of their trial. `clock` must outlive this.
  RecordedGaze(std::vector<GazeSample> samples, std::int64_t onset_ns, const Clock& clock)
      : clock_(clock), samples_(std::move(samples)), then_ns_(onset_ns) {}

  [[nodiscard]] std::string source() const override { return "recording"; }

  /// What is due by now; nothing before the onset. Stamps are of this session's clock.
  std::vector<GazeSample> take_samples() override;

  /// The first picture with something in it is the onset.
  void shown(const Picture& picture, const Flip& flip) override;

 private:
  const Clock& clock_;
  std::vector<GazeSample> samples_;
  std::int64_t then_ns_;
  std::optional<std::int64_t> onset_ns_;
  std::size_t next_{0};
};

}  // namespace impetus::inline gaze
