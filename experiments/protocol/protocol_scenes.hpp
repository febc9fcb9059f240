// The session's `Scenes`, from a protocol: a condition's levels put into the scene, then built.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/protocol_file.hpp"
#include "experiments/scenes/shape_library.hpp"
#include "experiments/session/ports.hpp"

namespace impetus {

class ProtocolScenes final : public Scenes {
 public:
  /// `protocol` must outlive this. `round_hold_to_hz` > 0 rounds imposed holds to that grid.
  ProtocolScenes(const Protocol& protocol, double round_hold_to_hz)
      : protocol_(&protocol), round_hold_to_hz_(round_hold_to_hz) {}

  [[nodiscard]] StagedScene stage(const PlannedTrial& trial,
                                  const ScreenGeometry& screen) const override {
    return stage(trial.condition, screen);
  }
  [[nodiscard]] StagedScene stage(const Condition& condition, const ScreenGeometry& screen) const;

 private:
  const Protocol* protocol_;
  double round_hold_to_hz_;
  mutable ShapeLibrary shapes_;  ///< each shape is built once
};

}  // namespace impetus
