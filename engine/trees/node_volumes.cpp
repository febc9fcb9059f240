// SPDX-License-Identifier: MIT
#include "engine/trees/node_volumes.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace impetus::inline trees {
namespace {

constexpr std::uint32_t kKindBits = 3;
constexpr std::uint32_t kKindMask = (1U << kKindBits) - 1;
static_assert(std::variant_size_v<Volume> <= kKindMask + 1);

std::size_t slot_of(std::int32_t index) { return static_cast<std::size_t>(index); }

bool of_one_kind(const std::vector<Volume>& volumes) {
  return std::all_of(volumes.begin(), volumes.end(), [&](const Volume& volume) {
    return volume.index() == volumes.front().index();
  });
}

template <typename T>
std::size_t bytes_of(const std::vector<T>& array) {
  return array.size() * sizeof(T);
}

}  // namespace

NodeVolumes::NodeVolumes(const std::vector<Volume>& volumes) {
  const bool one_kind = of_one_kind(volumes);
  const auto store = [&](auto& array, const auto& volume, std::uint32_t kind) {
    if (!one_kind) {
      slots_.push_back(kind | static_cast<std::uint32_t>(array.size()) << kKindBits);
    }
    array.push_back(volume);
  };
  if (one_kind && !volumes.empty() && std::holds_alternative<Sphere>(volumes.front())) {
    for (const Volume& volume : volumes) {
      all_spheres_.add(std::get<Sphere>(volume));
    }
    return;
  }
  for (const Volume& volume : volumes) {
    const auto kind = static_cast<std::uint32_t>(volume.index());
    switch (kind) {
      case 0:
        store(spheres_, std::get<0>(volume), kind);
        break;
      case 1:
        store(lines_, std::get<1>(volume), kind);
        break;
      case 2:
        store(rectangles_, std::get<2>(volume), kind);
        break;
      case 3:
        store(boxes_, std::get<3>(volume), kind);
        break;
      default:
        store(cubes_, std::get<4>(volume), kind);
        break;
    }
  }
}

NodeVolumes::NodeVolumes(const VoxelGrid& grid, std::vector<std::uint32_t> cells,
                         std::vector<std::int32_t> level_starts)
    : grid_(grid), cells_(std::move(cells)), level_starts_(std::move(level_starts)) {
  const auto count = static_cast<std::int32_t>(cells_.size());
  if (grid_.divisions < 2 || !(grid_.edge_m > 0.0) || level_starts_.empty() ||
      level_starts_.front() != 0 || level_starts_.back() >= count ||
      !std::is_sorted(level_starts_.begin(), level_starts_.end())) {
    throw std::invalid_argument("voxel tree: expected a grid and the first node of each level");
  }
  std::uint64_t along = 1;
  for (std::size_t level = 0; level < level_starts_.size(); ++level) {
    const std::int32_t end = level + 1 < level_starts_.size() ? level_starts_[level + 1] : count;
    for (std::int32_t node = level_starts_[level]; node < end; ++node) {
      if (cells_[slot_of(node)] >= along * along * along) {
        throw std::invalid_argument("voxel tree: node " + std::to_string(node) +
                                    " lies outside its level's grid");
      }
    }
    along *= static_cast<std::uint64_t>(grid_.divisions);
    if (level + 1 < level_starts_.size() && along > 1625) {  // 1625³ < 2³² ≤ 1626³
      throw std::invalid_argument("voxel tree: expected at most 1625 cubes along an edge, got " +
                                  std::to_string(along));
    }
  }
}

Cube NodeVolumes::voxel(std::int32_t node) const {
  std::uint32_t along = 1;
  for (std::size_t level = 1; level < level_starts_.size() && node >= level_starts_[level];
       ++level) {
    along *= static_cast<std::uint32_t>(grid_.divisions);
  }
  const std::uint32_t cell = cells_[slot_of(node)];
  const std::uint32_t row = cell / along;
  const std::uint32_t layer = row / along;
  const Vector3 place(cell % along, row % along, layer);
  const double edge_m = grid_.edge_m / along;
  return {grid_.least + edge_m * (place + Vector3::Constant(0.5)),
          0.5 * edge_m + kVoxelMargin * grid_.edge_m, Quaternion::Identity()};
}

std::int32_t NodeVolumes::size() const {
  const std::size_t stored =
      are_voxels() ? cells_.size()
      : slots_.empty()
          ? all_spheres_.size() + lines_.size() + rectangles_.size() + boxes_.size() + cubes_.size()
          : slots_.size();
  return static_cast<std::int32_t>(stored);
}

Volume NodeVolumes::at(std::int32_t node) const {
  if (are_voxels()) {
    return voxel(node);
  }
  std::size_t element = static_cast<std::size_t>(node);
  if (!slots_.empty()) {
    const std::uint32_t slot = slots_[element];
    element = slot >> kKindBits;
    switch (slot & kKindMask) {
      case 0:
        return spheres_[element];
      case 1:
        return lines_[element];
      case 2:
        return rectangles_[element];
      case 3:
        return boxes_[element];
      default:
        return cubes_[element];
    }
  }
  if (!all_spheres_.empty()) {
    return all_spheres_.at(element);
  }
  if (!lines_.empty()) {
    return lines_[element];
  }
  if (!rectangles_.empty()) {
    return rectangles_[element];
  }
  if (!boxes_.empty()) {
    return boxes_[element];
  }
  return cubes_[element];
}

std::size_t NodeVolumes::bytes() const {
  return all_spheres_.bytes() + bytes_of(spheres_) + bytes_of(lines_) + bytes_of(rectangles_) +
         bytes_of(boxes_) + bytes_of(cubes_) + bytes_of(slots_) + bytes_of(cells_) +
         (are_voxels() ? bytes_of(level_starts_) : 0);
}

}  // namespace impetus::inline trees
