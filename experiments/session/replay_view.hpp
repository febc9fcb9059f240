// One recorded trial, re-simulated, as the viewer plays it: plain data.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/dynamics/body.hpp"
#include "experiments/session/staged_scene.hpp"

namespace impetus {

/// A moment (end_s == begin_s) or a stretch on the timeline, seconds from onset.
struct TimelineMark {
  enum class Kind { kContact, kHold, kResponse, kLateFrame };
  Kind kind{Kind::kContact};
  double begin_s{0.0};
  double end_s{0.0};
  std::string label;
};

struct ReplayView {
  std::string title;               ///< "P01 · trial 37 of 87 · main"
  std::vector<std::string> facts;  ///< "delay_ms 100", "rated 2", ...
  Viewer viewer;
  std::vector<DrawnBody> looks;
  std::optional<ClosedCube> enclosure;
  double step_hz{240.0};
  double duration_s{0.0};
  std::vector<std::vector<BodyState>> states;  ///< [step][body], step 0 is the start
  std::vector<TimelineMark> marks;
  bool agrees{true};  ///< every step's hash as recorded
};

}  // namespace impetus
