// The session's `Scenes`, from a protocol: a trial's levels put into the scene, then built, with
// trees as deep as any condition of the protocol can reach.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "experiments/design/plan.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/scenes/shape_library.hpp"

namespace impetus::inline protocol {

/// The scene of a planned trial, as JSON, with its levels and what was solved for it put in.
nlohmann::json scene_of(const Protocol& protocol, const PlannedTrial& trial);

/// What a random start goes by: never the participant or the order of trials.
std::string start_of(const PlannedTrial& trial);

/// The deepest level that any condition of the design, practice or catch trial, standard interval
/// or demonstration can reach: no tree need be deeper.
int deepest_level_of(const Protocol& protocol);

/// Stages the scenes of a protocol's trials.
class ProtocolScenes final : public Scenes {
 public:
  /// `protocol` must outlive this. `round_hold_to_hz` > 0 rounds imposed holds to that grid.
  /// `shapes` may be shared with other scenes; left out, they are the protocol's.
  ProtocolScenes(const Protocol& protocol, double round_hold_to_hz)
      : ProtocolScenes(protocol, round_hold_to_hz, protocol.shapes) {}
  ProtocolScenes(const Protocol& protocol, double round_hold_to_hz,
                 std::shared_ptr<ShapeLibrary> shapes)
      : protocol_(&protocol),
        round_hold_to_hz_(round_hold_to_hz),
        shapes_(std::move(shapes)),
        deepest_level_(deepest_level_of(protocol)) {}

  [[nodiscard]] StagedScene stage(const PlannedTrial& trial,
                                  const ScreenGeometry& screen) const override;
  [[nodiscard]] StagedScene stage_demonstration(const std::string& id,
                                                const ScreenGeometry& screen) const override;

  /// A condition's scene as in its first main trial.
  [[nodiscard]] StagedScene stage(const Condition& condition, const ScreenGeometry& screen) const;

  /// Builds every shape of every condition and demonstration, so that nobody waits for one later,
  /// if the screen's viewing distance is as it is here.
  void build_shapes(const ScreenGeometry& screen) const;

 private:
  const Protocol* protocol_;
  double round_hold_to_hz_;
  std::shared_ptr<ShapeLibrary> shapes_;  ///< each shape is built once
  int deepest_level_;                     ///< no tree is built beyond it
};

}  // namespace impetus::inline protocol
