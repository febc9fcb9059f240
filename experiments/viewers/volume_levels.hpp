// The bounding volumes of bodies, of whatever kind, at the level that their pairs use or at a
// chosen one.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "experiments/drawing/volume_painter.hpp"
#include "experiments/viewers/preview_overlays.hpp"

namespace impetus::inline viewers {

inline constexpr std::array<float, 3> kVolumeColour{0.10F, 0.36F, 0.20F};

/// The volumes that stand for the whole object at `level`, in the body's frame: the level's nodes,
/// and nodes without children of the levels before.
[[nodiscard]] std::vector<RoundedBox> volumes_at_level(const VolumeTree& tree, int level);

/// The volumes of each level that was asked for, made once.
class VolumeLevels {
 public:
  /// The volumes to draw of every body; none where `overlays` asks for none.
  [[nodiscard]] std::vector<ColouredVolume> of(const PreviewRun& run,
                                               const PreviewOverlays& overlays,
                                               const std::vector<PosedBody>& bodies);

  /// The same of trees at these levels, one of each for a body; none for a level below 0.
  [[nodiscard]] std::vector<ColouredVolume> of(
      const std::vector<std::shared_ptr<const VolumeTree>>& trees, const std::vector<int>& levels,
      const std::vector<PosedBody>& bodies);

 private:
  /// Kept with its tree, so that no other can have its address.
  struct Known {
    std::shared_ptr<const VolumeTree> tree;
    std::map<int, std::vector<RoundedBox>> levels;
  };

  const std::vector<RoundedBox>& at(const std::shared_ptr<const VolumeTree>& tree, int level);

  std::map<const VolumeTree*, Known> known_;
};

}  // namespace impetus::inline viewers
