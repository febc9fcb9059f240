// SPDX-License-Identifier: MIT
#include "experiments/models/tree_file.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "experiments/models/atomic_file.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/models/readable_file.hpp"
#include "experiments/models/tree_header.hpp"

namespace impetus::inline models {
namespace {

// The arrays of a tree, exactly:
//
//   volumes    voxels: a cell number per node; otherwise the kind of every node (one byte, its row
//              in `Volume`) and then the numbers of every node
//   links      first child, number of children
//   surfaces   occupancy, group, density normal, fit error

constexpr double kUnitTolerance = 1e-6;

[[noreturn]] void refuse_node(std::int32_t node, const std::string& expected, double got) {
  throw std::runtime_error("node " + std::to_string(node) + ": expected " + expected + ", got " +
                           std::to_string(got));
}

// ---------------------------------------------------------------- a volume as numbers

/// Calls `visit` on every number of a volume, in the order of the file: the same for both ways.
template <typename Visit>
void each_of(Vector3& vector, Visit& visit) {
  for (int axis = 0; axis < 3; ++axis) {
    visit(vector[axis]);
  }
}

template <typename Visit>
void each_of(Quaternion& turn, Visit& visit) {
  for (int axis = 0; axis < 4; ++axis) {
    visit(turn.coeffs()[axis]);  // x y z w
  }
}

template <typename Visit>
void each_number(Sphere& sphere, Visit visit) {
  each_of(sphere.centre, visit);
  visit(sphere.radius_m);
}

template <typename Visit>
void each_number(LineSwept& swept, Visit visit) {
  each_of(swept.centre, visit);
  each_of(swept.half_axis, visit);
  visit(swept.radius_m);
}

template <typename Visit>
void each_number(RectangleSwept& swept, Visit visit) {
  each_of(swept.centre, visit);
  each_of(swept.half_u, visit);
  each_of(swept.half_v, visit);
  visit(swept.radius_m);
}

template <typename Visit>
void each_number(Box& box, Visit visit) {
  each_of(box.centre, visit);
  each_of(box.half_extents_m, visit);
  each_of(box.orientation, visit);
}

template <typename Visit>
void each_number(Cube& cube, Visit visit) {
  each_of(cube.centre, visit);
  visit(cube.half_edge_m);
  each_of(cube.orientation, visit);
}

// ---------------------------------------------------------------- what a volume must be

void check_size(std::int32_t node, double size_m) {
  if (size_m < 0.0) {
    refuse_node(node, "a size that is not negative", size_m);
  }
}

void check_turn(std::int32_t node, const Quaternion& turn) {
  if (std::abs(turn.norm() - 1.0) > kUnitTolerance) {
    refuse_node(node, "a unit quaternion", turn.norm());
  }
}

void check(std::int32_t node, const Sphere& sphere) { check_size(node, sphere.radius_m); }
void check(std::int32_t node, const LineSwept& swept) { check_size(node, swept.radius_m); }
void check(std::int32_t node, const RectangleSwept& swept) {
  check_size(node, swept.radius_m);
  const double sides = swept.half_u.norm() * swept.half_v.norm();
  if (std::abs(swept.half_u.dot(swept.half_v)) > kUnitTolerance * sides) {
    refuse_node(node, "sides at right angles", swept.half_u.dot(swept.half_v));
  }
}
void check(std::int32_t node, const Box& box) {
  check_size(node, box.half_extents_m.minCoeff());
  check_turn(node, box.orientation);
}
void check(std::int32_t node, const Cube& cube) {
  check_size(node, cube.half_edge_m);
  check_turn(node, cube.orientation);
}

template <typename T>
Volume take_volume(ByteReader& bytes, std::int32_t node) {
  T volume;
  each_number(volume, [&](double& number) {
    number = bytes.take<double>();
    if (!std::isfinite(number)) {
      refuse_node(node, "finite numbers", number);
    }
  });
  check(node, volume);
  return volume;
}

// ---------------------------------------------------------------- volumes of all nodes

void append_volumes(std::string& bytes, const VolumeTree& tree) {
  const NodeVolumes& volumes = tree.volumes();
  if (volumes.are_voxels()) {
    for (const std::uint32_t cell : volumes.cells()) {
      append_number(bytes, cell);
    }
    return;
  }
  for (std::int32_t node = 0; node < volumes.size(); ++node) {
    append_number(bytes, static_cast<std::uint8_t>(volumes.at(node).index()));
  }
  for (std::int32_t node = 0; node < volumes.size(); ++node) {
    Volume any = volumes.at(node);
    std::visit(
        [&](auto& volume) {
          each_number(volume, [&](double number) { append_number(bytes, number); });
        },
        any);
  }
}

NodeVolumes take_voxels(ByteReader& bytes, const TreeHeader& header) {
  const auto nodes = static_cast<std::size_t>(header.nodes);
  ByteReader numbers(bytes.take_bytes(nodes * sizeof(std::uint32_t)));
  std::vector<std::uint32_t> cells;
  cells.reserve(nodes);
  for (std::size_t node = 0; node < nodes; ++node) {
    cells.push_back(numbers.take<std::uint32_t>());
  }
  return {header.grid, std::move(cells), header.level_starts};
}

NodeVolumes take_volumes(ByteReader& bytes, const TreeHeader& header) {
  using Take = Volume (*)(ByteReader&, std::int32_t);
  static constexpr std::array<Take, std::variant_size_v<Volume>> kTakes{
      take_volume<Sphere>, take_volume<LineSwept>, take_volume<RectangleSwept>, take_volume<Box>,
      take_volume<Cube>};
  ByteReader kinds(bytes.take_bytes(static_cast<std::size_t>(header.nodes)));
  std::vector<Volume> volumes;
  for (std::int32_t node = 0; node < header.nodes; ++node) {
    const auto kind = kinds.take<std::uint8_t>();
    if (kind >= kTakes.size()) {
      refuse_node(node, "a kind of volume below " + std::to_string(kTakes.size()), kind);
    }
    volumes.push_back(kTakes[kind](bytes, node));
  }
  return NodeVolumes(volumes);
}

// ---------------------------------------------------------------- links and surfaces

void append_surface(std::string& bytes, const NodeSurface& surface) {
  append_number(bytes, surface.occupancy);
  append_number(bytes, surface.group);
  for (int axis = 0; axis < 3; ++axis) {
    append_number(bytes, surface.density_normal[axis]);
  }
  append_number(bytes, surface.fit_error_m);
}

NodeSurface take_surface(ByteReader& bytes, std::int32_t node) {
  NodeSurface surface;
  surface.occupancy = bytes.take<float>();
  surface.group = bytes.take<std::int32_t>();
  for (int axis = 0; axis < 3; ++axis) {
    surface.density_normal[axis] = bytes.take<float>();
  }
  surface.fit_error_m = bytes.take<float>();
  if (!(surface.occupancy >= 0.0F && surface.occupancy <= 1.0F)) {
    refuse_node(node, "an occupancy from 0 to 1", surface.occupancy);
  }
  if (surface.group < kNoGroup) {
    refuse_node(node, "a group of at least -1", surface.group);
  }
  if (!surface.density_normal.allFinite()) {
    refuse_node(node, "a finite density normal", surface.density_normal.sum());
  }
  if (!std::isfinite(surface.fit_error_m) || surface.fit_error_m < 0.0F) {
    refuse_node(node, "a fit error that is not negative", surface.fit_error_m);
  }
  return surface;
}

void append_tree(std::string& bytes, const VolumeTree& tree) {
  append_volumes(bytes, tree);
  for (std::int32_t node = 0; node < tree.node_count(); ++node) {
    append_number(bytes, tree.links(node).first_child);
    append_number(bytes, tree.links(node).child_count);
  }
  for (std::int32_t node = 0; node < tree.node_count(); ++node) {
    append_surface(bytes, tree.surface(node));
  }
}

/// Throws std::out_of_range when bytes are missing, std::runtime_error or std::invalid_argument
/// (expected ..., got ...) when they are no tree.
VolumeTree take_tree(ByteReader& bytes, const TreeHeader& header) {
  NodeVolumes volumes = header.voxels ? take_voxels(bytes, header) : take_volumes(bytes, header);
  std::vector<NodeLinks> links;
  for (std::int32_t node = 0; node < header.nodes; ++node) {
    const auto first_child = bytes.take<std::int32_t>();
    links.push_back({first_child, bytes.take<std::int32_t>()});
  }
  std::vector<NodeSurface> surfaces;
  surfaces.reserve(links.size());
  for (std::int32_t node = 0; node < header.nodes; ++node) {
    surfaces.push_back(take_surface(bytes, node));
  }
  return {std::move(volumes), std::move(links), std::move(surfaces), header.level_starts};
}

// ---------------------------------------------------------------- the file

constexpr std::string_view kMagic = "impetree";
constexpr std::size_t kChecksumLetters = 32;

[[noreturn]] void refuse(const std::string& name, const std::string& problem) {
  throw std::runtime_error(name + ": " + problem);
}

/// The bytes before the checksum, which is right.
std::string_view unsealed(std::string_view bytes, const std::string& name) {
  if (bytes.size() < kChecksumLetters) {
    refuse(name, "expected a checksum at the end, got " + std::to_string(bytes.size()) +
                     " bytes: the file is cut short");
  }
  const std::string_view content = bytes.substr(0, bytes.size() - kChecksumLetters);
  const std::string_view stored = bytes.substr(content.size());
  const std::string computed = content_hash(content);
  if (stored != computed) {
    refuse(name, "expected the checksum " + computed +
                     " at the end, got another: the file is damaged or cut short");
  }
  return content;
}

StoredTree parsed(ByteReader& bytes) {
  const auto length = bytes.take<std::uint64_t>();
  TreeHeader header = tree_header_from(bytes.take_bytes(static_cast<std::size_t>(length)));
  VolumeTree tree = take_tree(bytes, header);
  TriangleMesh mesh = take_mesh(bytes, header.mesh);
  if (bytes.left() > 0) {
    throw std::runtime_error("expected the mesh to end the file, got " +
                             std::to_string(bytes.left()) + " bytes more");
  }
  const std::string hash = content_hash(mesh);
  if (hash != header.mesh_hash) {
    throw std::runtime_error("expected the mesh with the hash that the header names, got " + hash);
  }
  return {std::move(header.name), header.settings,           std::move(mesh),
          std::move(tree),        std::move(header.quality), header.builder_version};
}

}  // namespace

std::string sealed(std::string content) {
  content += content_hash(content);
  return content;
}

std::string bytes_of(const StoredTree& stored) {
  const std::string header = text_of(header_of(stored));
  std::string bytes(kMagic);
  append_number(bytes, kTreeFileFormat);
  append_number(bytes, static_cast<std::uint64_t>(header.size()));
  bytes += header;
  append_tree(bytes, stored.tree);
  append_mesh(bytes, stored.mesh);
  return sealed(std::move(bytes));
}

StoredTree stored_tree_from(std::string_view bytes, const std::string& name) {
  if (bytes.substr(0, kMagic.size()) != kMagic) {
    refuse(name, "expected a tree file, which begins with \"impetree\", got another kind of file");
  }
  ByteReader reader(bytes.substr(kMagic.size()));
  try {
    const auto format = reader.take<std::uint32_t>();
    if (format != kTreeFileFormat) {
      throw std::runtime_error("expected a tree file of format " + std::to_string(kTreeFileFormat) +
                               ", got format " + std::to_string(format));
    }
  } catch (const std::exception& error) {
    refuse(name, error.what());
  }
  const std::string_view content = unsealed(bytes, name);
  try {
    ByteReader body(content);
    body.take_bytes(kMagic.size() + sizeof kTreeFileFormat);
    return parsed(body);
  } catch (const std::exception& error) {
    refuse(name, error.what());
  }
}

void save_tree(const StoredTree& stored, const std::filesystem::path& file, bool replace) {
  if (!replace && std::filesystem::exists(file)) {
    refuse(file.string(), "exists already and is not overwritten");
  }
  const std::string bytes = bytes_of(stored);
  stored_tree_from(bytes, file.string());
  write_whole_file(file, bytes);
}

StoredTree load_tree(const std::filesystem::path& file) {
  std::string bytes;
  try {
    bytes = file_bytes(file);
  } catch (const std::exception& error) {
    refuse(file.string(), error.what());
  }
  return stored_tree_from(bytes, file.string());
}

}  // namespace impetus::inline models
