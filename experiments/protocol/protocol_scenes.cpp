// SPDX-License-Identifier: MIT
#include "experiments/protocol/protocol_scenes.hpp"

#include "experiments/scenes/scene_file.hpp"

namespace impetus {

StagedScene ProtocolScenes::stage(const Condition& condition, const ScreenGeometry& screen) const {
  return build_scene(scene_under(*protocol_, condition), screen, round_hold_to_hz_, shapes_);
}

}  // namespace impetus
