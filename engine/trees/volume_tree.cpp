// SPDX-License-Identifier: MIT
#include "engine/trees/volume_tree.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/numerics/lanes.hpp"
#include "engine/volumes/rounded_box.hpp"

namespace impetus::inline trees {
namespace {

constexpr std::uint32_t kKindBits = 3;
constexpr std::uint32_t kKindMask = (1U << kKindBits) - 1;
static_assert(std::variant_size_v<Volume> <= kKindMask + 1);
static_assert(kLanes == 8, "a place in a block is three bits");

bool of_one_kind(const std::vector<Volume>& volumes) {
  return std::all_of(volumes.begin(), volumes.end(), [&](const Volume& volume) {
    return volume.index() == volumes.front().index();
  });
}

template <typename T>
std::size_t bytes_of(const std::vector<T>& array) {
  return array.size() * sizeof(T);
}

/// Breadth-first order means: each node's children follow the children of the node before it.
bool is_breadth_first(const std::vector<NodeLinks>& links) {
  std::int64_t next_child = 1;
  for (const NodeLinks& node : links) {
    if (node.child_count < 0 || (node.child_count > 0 && node.first_child != next_child)) {
      return false;
    }
    next_child += node.child_count;
  }
  return next_child == static_cast<std::int64_t>(links.size());
}

bool levels_match(const std::vector<NodeLinks>& links, const std::vector<std::int32_t>& starts) {
  std::int32_t begin = 0;
  std::int32_t end = 1;
  for (const std::int32_t start : starts) {
    if (start != begin || begin == end) {
      return false;
    }
    std::int32_t children = 0;
    for (std::int32_t index = begin; index < end; ++index) {
      children += links[static_cast<std::size_t>(index)].child_count;
    }
    begin = std::exchange(end, end + children);
  }
  return begin == end;
}

/// One member of every node.
template <typename Member>
std::vector<Member> each(const std::vector<VolumeNode>& nodes, Member VolumeNode::*member) {
  std::vector<Member> members;
  members.reserve(nodes.size());
  for (const VolumeNode& node : nodes) {
    members.push_back(node.*member);
  }
  return members;
}

std::vector<NodeLinks> links_of(const std::vector<VolumeNode>& nodes) {
  std::vector<NodeLinks> links;
  links.reserve(nodes.size());
  for (const VolumeNode& node : nodes) {
    links.push_back({node.first_child, node.child_count});
  }
  return links;
}

}  // namespace

NodeVolumes::NodeVolumes(const std::vector<Volume>& volumes)
    : size_(static_cast<std::int32_t>(volumes.size())) {
  const bool one_kind = of_one_kind(volumes);
  if (one_kind && !volumes.empty() && std::holds_alternative<Sphere>(volumes.front())) {
    for (const Volume& volume : volumes) {
      all_spheres_.add(std::get<Sphere>(volume));
    }
    return;
  }
  for (const Volume& volume : volumes) {
    only_kind_ = volume.index();
    const auto store = [&]<typename Kind>(const Kind& one) {
      auto& array = std::get<std::vector<Kind>>(arrays_);
      if (!one_kind) {
        slots_.push_back(static_cast<std::uint32_t>(only_kind_ | array.size() << kKindBits));
      }
      array.push_back(one);
    };
    std::visit(store, volume);
  }
}

NodeVolumes::NodeVolumes(const VoxelGrid& grid, std::vector<std::uint32_t> cells,
                         std::vector<std::int32_t> level_starts)
    : size_(static_cast<std::int32_t>(cells.size())),
      grid_(grid),
      cells_(std::move(cells)),
      level_starts_(std::move(level_starts)) {
  if (grid_.divisions < 2 || !(grid_.edge_m > 0.0) || level_starts_.empty() ||
      level_starts_.front() != 0 || level_starts_.back() >= size_ ||
      !std::is_sorted(level_starts_.begin(), level_starts_.end())) {
    throw std::invalid_argument("voxel tree: expected a grid and the first node of each level");
  }
  std::uint64_t along = 1;
  for (std::size_t level = 0; level < level_starts_.size(); ++level) {
    const std::int32_t end = level + 1 < level_starts_.size() ? level_starts_[level + 1] : size_;
    for (std::int32_t node = level_starts_[level]; node < end; ++node) {
      if (cells_[static_cast<std::size_t>(node)] >= along * along * along) {
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
  const std::uint32_t cell = cells_[static_cast<std::size_t>(node)];
  const std::uint32_t row = cell / along;
  const std::uint32_t layer = row / along;
  const Vector3 place(cell % along, row % along, layer);
  const double edge_m = grid_.edge_m / along;
  return {grid_.least + edge_m * (place + Vector3::Constant(0.5)),
          0.5 * edge_m + kVoxelMargin * grid_.edge_m, Quaternion::Identity()};
}

Volume NodeVolumes::at(std::int32_t node) const {
  if (are_voxels()) {
    return voxel(node);
  }
  const auto index = static_cast<std::size_t>(node);
  if (!all_spheres_.empty()) {
    return all_spheres_.at(index);
  }
  return slots_.empty() ? element(only_kind_, index)
                        : element(slots_[index] & kKindMask, slots_[index] >> kKindBits);
}

std::size_t NodeVolumes::bytes() const {
  const auto bytes_of_all = [](const auto&... arrays) { return (bytes_of(arrays) + ...); };
  return all_spheres_.bytes() + std::apply(bytes_of_all, arrays_) + bytes_of(slots_) +
         bytes_of(cells_) + (are_voxels() ? bytes_of(level_starts_) : 0);
}

SiblingBlocks::SiblingBlocks(const std::vector<NodeLinks>& links) {
  slots_.reserve(links.size());
  add_siblings(1);  // the root
  for (const NodeLinks& node : links) {
    add_siblings(node.child_count);
  }
}

void SiblingBlocks::add_siblings(std::int32_t nodes) {
  for (std::int32_t i = 0; i < nodes; ++i) {
    const auto lane = static_cast<std::uint32_t>(i % kLanes);
    count_ += lane == 0 ? 1 : 0;
    slots_.push_back((count_ - 1) << 3 | lane);
  }
}

VolumeTree::VolumeTree(const std::vector<VolumeNode>& nodes, std::vector<std::int32_t> level_starts)
    : VolumeTree(NodeVolumes(each(nodes, &VolumeNode::volume)), links_of(nodes),
                 each(nodes, &VolumeNode::surface), std::move(level_starts)) {}

VolumeTree::VolumeTree(NodeVolumes volumes, std::vector<NodeLinks> links,
                       std::vector<NodeSurface> surfaces, std::vector<std::int32_t> level_starts)
    : volumes_(std::move(volumes)),
      links_(std::move(links)),
      surfaces_(std::move(surfaces)),
      level_starts_(std::move(level_starts)),
      bounding_radius_m_(0.0) {
  if (links_.empty() || !is_breadth_first(links_) || !levels_match(links_, level_starts_)) {
    throw std::invalid_argument("volume tree: nodes are not in breadth-first order by level");
  }
  if (volumes_.size() != node_count() || surfaces_.size() != links_.size()) {
    throw std::invalid_argument("volume tree: expected a volume and a surface for every node");
  }
  if (!volumes_.all_spheres().empty()) {
    blocks_ = SiblingBlocks(links_);
  }
  measure_half_thicknesses();
  double of_leaves = 0.0;
  for (int level = 0; level < level_count(); ++level) {
    double worst = of_leaves;
    for (std::int32_t node = level_begin(level); node < level_end(level); ++node) {
      const double error_m = surfaces_[at(node)].fit_error_m;
      worst = std::max(worst, error_m);
      of_leaves = links_[at(node)].child_count == 0 ? std::max(of_leaves, error_m) : of_leaves;
    }
    fit_errors_m_.push_back(worst);
  }
  const Sphere root = bounding_sphere(volume(0));
  bounding_radius_m_ = root.centre.norm() + root.radius_m;
}

void VolumeTree::measure_half_thicknesses() {
  double of_leaves = std::numeric_limits<double>::infinity();
  for (int level = 0; level < level_count(); ++level) {
    double least = of_leaves;
    for (std::int32_t node = level_begin(level); node < level_end(level); ++node) {
      const double thickness_m = least_half_width_m(volume(node));
      least = std::min(least, thickness_m);
      of_leaves = links_[at(node)].child_count == 0 ? std::min(of_leaves, thickness_m) : of_leaves;
    }
    half_thicknesses_m_.push_back(least);
  }
}

std::vector<std::int32_t> VolumeTree::standing_at(int level) const {
  std::vector<std::int32_t> standing{0};
  for (int depth = 0; depth < level; ++depth) {
    std::vector<std::int32_t> deeper;
    for (const std::int32_t node : standing) {
      const auto& [first, count] = links(node);
      if (count == 0) {
        deeper.push_back(node);
      }
      for (std::int32_t child = first; child < first + count; ++child) {
        deeper.push_back(child);
      }
    }
    standing = std::move(deeper);
  }
  return standing;
}

double VolumeTree::fit_error_m(int level) const {
  return fit_errors_m_[at(std::min(level, level_count() - 1))];
}

double VolumeTree::least_half_thickness_m(int level) const {
  return half_thicknesses_m_[at(std::min(level, level_count() - 1))];
}

std::size_t VolumeTree::bytes() const {
  return volumes_.bytes() + links_.size() * sizeof(NodeLinks) + blocks_.bytes() +
         surfaces_.size() * sizeof(NodeSurface) + level_starts_.size() * sizeof(std::int32_t) +
         (fit_errors_m_.size() + half_thicknesses_m_.size()) * sizeof(double);
}

VolumeTree single_node_tree(const Volume& volume) {
  return {std::vector<VolumeNode>{{volume, 0, 0, {}}}, {0}};
}

}  // namespace impetus::inline trees
