// SPDX-License-Identifier: MIT
#include "experiments/stage/volume_levels.hpp"

#include <optional>
#include <utility>

namespace impetus {
namespace {

constexpr std::array<float, 3> kVolumeColour{0.10F, 0.36F, 0.20F};

}  // namespace

std::vector<Sphere> volumes_at_level(const VolumeTree& tree, int level) {
  std::vector<Sphere> volumes;
  for (const std::int32_t index : tree.standing_at(level)) {
    volumes.push_back(bounding_sphere(tree.volume(index)));
  }
  return volumes;
}

const std::vector<Sphere>& VolumeLevels::at(const std::shared_ptr<const VolumeTree>& tree,
                                            int level) {
  Known& known = known_[tree.get()];
  known.tree = tree;
  const auto found = known.levels.find(level);
  if (found != known.levels.end()) {
    return found->second;
  }
  return known.levels[level] = volumes_at_level(*tree, level);
}

std::vector<ColouredSphere> VolumeLevels::of(const PreviewRun& run, const PreviewOverlays& overlays,
                                             const std::vector<PosedBody>& bodies) {
  std::vector<ColouredSphere> volumes;
  if (!overlays.shown || !overlays.volumes) {
    return volumes;
  }
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const bool chosen = overlays.volume_level >= 0;
    const std::optional<int> level = chosen ? std::optional<int>(overlays.volume_level)
                                            : run.level_in_use(static_cast<std::int32_t>(body));
    if (!level) {
      continue;
    }
    for (const Sphere& volume : at(run.scene().world.models()[body].tree, *level)) {
      const Vector3 centre = bodies[body].pose.transform(volume.centre);
      volumes.push_back({{centre, volume.radius_m}, kVolumeColour});
    }
  }
  return volumes;
}

}  // namespace impetus
