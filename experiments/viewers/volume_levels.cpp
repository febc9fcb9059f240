// SPDX-License-Identifier: MIT
#include "experiments/viewers/volume_levels.hpp"

namespace impetus::inline viewers {
std::vector<RoundedBox> volumes_at_level(const VolumeTree& tree, int level) {
  std::vector<RoundedBox> volumes;
  for (const std::int32_t index : tree.standing_at(level)) {
    volumes.push_back(rounded_box(tree.volume(index)));
  }
  return volumes;
}

const std::vector<RoundedBox>& VolumeLevels::at(const std::shared_ptr<const VolumeTree>& tree,
                                                int level) {
  Known& known = known_[tree.get()];
  known.tree = tree;
  const auto found = known.levels.find(level);
  if (found != known.levels.end()) {
    return found->second;
  }
  return known.levels[level] = volumes_at_level(*tree, level);
}

std::vector<ColouredVolume> VolumeLevels::of(const PreviewRun& run, const PreviewOverlays& overlays,
                                             const std::vector<PosedBody>& bodies) {
  if (!overlays.shown || !overlays.volumes) {
    return {};
  }
  std::vector<std::shared_ptr<const VolumeTree>> trees;
  std::vector<int> levels;
  const std::vector<BodyDetail> details = run.details();
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    trees.push_back(run.scene().world.models()[body].tree);
    const bool chosen = overlays.volume_level >= 0;
    levels.push_back(chosen ? overlays.volume_level : details[body].level);
  }
  return of(trees, levels, bodies);
}

std::vector<ColouredVolume> VolumeLevels::of(
    const std::vector<std::shared_ptr<const VolumeTree>>& trees, const std::vector<int>& levels,
    const std::vector<PosedBody>& bodies) {
  std::vector<ColouredVolume> volumes;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    if (levels[body] < 0) {
      continue;
    }
    for (const RoundedBox& volume : at(trees[body], levels[body])) {
      volumes.push_back({posed(volume, bodies[body].pose), kVolumeColour});
    }
  }
  return volumes;
}

}  // namespace impetus::inline viewers
