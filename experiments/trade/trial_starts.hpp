// Several trials of one scene, each from a start of its own, with trees of any kind.
//
//   crowd        each start draws places and directions anew
//   otherwise    the first start is the scene's own; the others turn each body by up to 5° and
//                shift it by up to 5 % of its size
//
// A start puts the bodies of all kinds of tree in the same places.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "experiments/record/staged_scene.hpp"
#include "experiments/scenes/shape_library.hpp"

namespace impetus::inline trade {

/// Stages a scene from one start after another.
class TrialStarts {
 public:
  /// `scene` as for build_scene(); `library` must outlive this.
  TrialStarts(nlohmann::json scene, const ScreenGeometry& screen, ShapeLibrary& library,
              std::uint64_t seed)
      : scene_(std::move(scene)), screen_(screen), library_(library), seed_(seed) {}

  /// Start `number`, from 1, with trees of `kind`; "": the scene's own.
  [[nodiscard]] StagedScene staged(const std::string& kind, std::int64_t number) const;

 private:
  [[nodiscard]] StagedScene as_drawn(const nlohmann::json& scene, std::int64_t number) const;
  void jitter(World& world, std::int64_t number) const;

  nlohmann::json scene_;
  ScreenGeometry screen_;
  ShapeLibrary& library_;
  std::uint64_t seed_;
};

}  // namespace impetus::inline trade
