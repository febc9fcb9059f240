// SPDX-License-Identifier: MIT
#include "experiments/models/tree_header.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace impetus::inline models {
namespace {

using nlohmann::json;

constexpr std::int64_t kMostNodes = 1'000'000'000;
constexpr std::int64_t kMostElements = std::int64_t{1} << 40;

[[noreturn]] void refuse(const std::string& key, const std::string& expected,
                         const std::string& got) {
  throw std::runtime_error("header/" + key + ": expected " + expected + ", got " + got);
}

/// The value of a key: never dumped, since a hostile one may be nested without end.
const json& value_of(const json& object, const std::string& key) {
  const auto found = object.find(key);
  if (found == object.end()) {
    refuse(key, "a value", "none");
  }
  return *found;
}

std::int64_t whole(const json& value, const std::string& key, std::int64_t least,
                   std::int64_t most) {
  const std::string expected =
      "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
  if (!value.is_number_integer()) {
    refuse(key, expected, value.type_name());
  }
  const bool huge = value.is_number_unsigned() && value.get<std::uint64_t>() > INT64_MAX;
  if (huge || value.get<std::int64_t>() < least || value.get<std::int64_t>() > most) {
    refuse(key, expected, value.dump());
  }
  return value.get<std::int64_t>();
}

std::int64_t whole(const json& object, const char* key, std::int64_t least, std::int64_t most) {
  return whole(value_of(object, key), std::string(key), least, most);
}

double number(const json& value, const std::string& key, double least) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    refuse(key, "a finite number", value.type_name());
  }
  const auto result = value.get<double>();
  if (result < least) {
    refuse(key, "a number that is not negative", value.dump());
  }
  return result;
}

std::string text(const json& object, const char* key) {
  const json& value = value_of(object, key);
  if (!value.is_string()) {
    refuse(key, "a string", value.type_name());
  }
  return value.get<std::string>();
}

const json& array(const json& object, const char* key, std::size_t count) {
  const json& value = value_of(object, key);
  if (!value.is_array() || value.size() != count) {
    refuse(key, "an array of " + std::to_string(count),
           value.is_array() ? std::to_string(value.size()) : value.type_name());
  }
  return value;
}

TreeSettings settings_from(const json& header) {
  TreeSettings settings;
  try {
    settings.kind = tree_kind(text(header, "kind"));
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(std::string("header/kind: ") + error.what());
  }
  settings.depth = static_cast<int>(whole(header, "depth", 0, kGreatestTreeDepth));
  settings.branching =
      static_cast<int>(whole(header, "branching", kLeastBranching, kGreatestBranching));
  if (header.contains("built_depth")) {
    settings.built_depth = static_cast<int>(whole(header, "built_depth", 0, kGreatestTreeDepth));
  }
  return settings;
}

VoxelGrid grid_from(const json& value) {
  if (!value.is_object()) {
    refuse("grid", "an object", value.type_name());
  }
  VoxelGrid grid;
  const json& least = array(value, "least", 3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grid.least[static_cast<int>(axis)] =
        number(least[axis], "grid/least", -std::numeric_limits<double>::infinity());
  }
  grid.edge_m = number(value_of(value, "edge_m"), "grid/edge_m", 0.0);
  grid.divisions = static_cast<int>(whole(value, "divisions", 2, 1625));
  return grid;
}

json grid_json(const VoxelGrid& grid) {
  return {{"least", {grid.least.x(), grid.least.y(), grid.least.z()}},
          {"edge_m", grid.edge_m},
          {"divisions", grid.divisions}};
}

json quality_json(const LevelQuality& level) {
  return {{"nodes", level.nodes},
          {"worst_protrusion_m", level.worst_protrusion_m},
          {"mean_protrusion_m", level.mean_protrusion_m},
          {"outside_ratio", level.outside_ratio},
          {"largest_node_m", level.largest_node_m},
          {"bytes", level.bytes},
          {"uncovered_area_m2", level.uncovered_area_m2}};
}

LevelQuality quality_from(const json& value) {
  if (!value.is_object()) {
    refuse("quality", "objects", value.type_name());
  }
  const auto measure = [&](const char* key) {
    return number(value_of(value, key), std::string("quality/") + key, 0.0);
  };
  LevelQuality level;
  level.nodes = static_cast<std::int32_t>(whole(value, "nodes", 1, kMostNodes));
  level.worst_protrusion_m = measure("worst_protrusion_m");
  level.mean_protrusion_m = measure("mean_protrusion_m");
  level.outside_ratio = measure("outside_ratio");
  level.largest_node_m = measure("largest_node_m");
  level.bytes = static_cast<std::size_t>(whole(value, "bytes", 0, kMostElements));
  level.uncovered_area_m2 = measure("uncovered_area_m2");
  return level;
}

}  // namespace

TreeHeader header_of(const StoredTree& stored) {
  TreeHeader header;
  header.name = stored.name;
  header.settings = stored.settings;
  header.builder_version = stored.builder_version;
  header.mesh_hash = content_hash(stored.mesh);
  header.mesh = {stored.mesh.vertices.size(), stored.mesh.triangles.size()};
  header.nodes = stored.tree.node_count();
  for (int level = 0; level < stored.tree.level_count(); ++level) {
    header.level_starts.push_back(stored.tree.level_begin(level));
  }
  header.voxels = stored.tree.volumes().are_voxels();
  header.grid = stored.tree.volumes().grid();
  header.quality = stored.quality;
  return header;
}

std::string text_of(const TreeHeader& header) {
  json object{{"name", header.name},
              {"kind", name_of(header.settings.kind)},
              {"depth", header.settings.depth},
              {"branching", header.settings.branching},
              {"builder_version", header.builder_version},
              {"mesh_hash", header.mesh_hash},
              {"vertices", header.mesh.vertices},
              {"triangles", header.mesh.triangles},
              {"nodes", header.nodes},
              {"level_starts", header.level_starts},
              {"quality", json::array()}};
  if (header.settings.built_depth < kGreatestTreeDepth) {
    object["built_depth"] = header.settings.built_depth;
  }
  if (header.voxels) {
    object["grid"] = grid_json(header.grid);
  }
  for (const LevelQuality& level : header.quality) {
    object["quality"].push_back(quality_json(level));
  }
  // A file's name may hold any bytes: those that are no text are replaced.
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

TreeHeader tree_header_from(std::string_view given) {
  const json object = json::parse(given, nullptr, /*allow_exceptions=*/false);
  if (!object.is_object()) {
    throw std::runtime_error("expected a JSON object as header, got something else");
  }
  TreeHeader header;
  header.name = text(object, "name");
  header.settings = settings_from(object);
  header.builder_version = static_cast<int>(whole(object, "builder_version", 0, INT32_MAX));
  header.mesh_hash = text(object, "mesh_hash");
  header.mesh.vertices = static_cast<std::uint64_t>(whole(object, "vertices", 0, kMostElements));
  header.mesh.triangles = static_cast<std::uint64_t>(whole(object, "triangles", 0, kMostElements));
  header.nodes = static_cast<std::int32_t>(whole(object, "nodes", 1, kMostNodes));
  const json& starts = value_of(object, "level_starts");
  for (const json& start : array(object, "level_starts", starts.size())) {
    header.level_starts.push_back(
        static_cast<std::int32_t>(whole(start, std::string("level_starts"), 0, kMostNodes)));
  }
  header.voxels = object.contains("grid");
  if (header.voxels) {
    header.grid = grid_from(object["grid"]);
  }
  const json& quality = value_of(object, "quality");
  const std::size_t levels = quality.empty() ? 0 : header.level_starts.size();
  for (const json& level : array(object, "quality", levels)) {
    header.quality.push_back(quality_from(level));
  }
  return header;
}

}  // namespace impetus::inline models
