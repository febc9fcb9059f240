// What a glTF file claims to hold, and which files it names.
//
//   scene ─> nodes, a tree ─> meshes ─> primitives ─> accessors ─> buffers, each a file or text
//
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "experiments/files/mesh_claims.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/models/readable_file.hpp"

namespace impetus::inline files {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// assimp's reader calls itself once per level.
constexpr int kMostLevels = 64;
/// Of the triangles of all nodes, as many as a mesh of any use could have.
constexpr double kMostCorners = 6e7;

/// Of a GLB: the magic, its version and length, then the length and kind of the chunk of JSON.
std::string_view json_text(std::string_view bytes) {
  constexpr std::string_view kMagic = "glTF";
  constexpr std::size_t kHead = 12;
  if (!bytes.starts_with(kMagic)) {
    return bytes;
  }
  ByteReader reader(bytes);
  try {
    reader.take_bytes(kHead);
    const auto length = reader.take<std::uint32_t>();
    reader.take_bytes(sizeof(std::uint32_t));
    return reader.take_bytes(length);
  } catch (const std::out_of_range&) {
    throw FalseClaim("its JSON is longer than the file, which has " + std::to_string(bytes.size()) +
                     " bytes");
  }
}

/// Of brackets that are open at once, outside of strings.
int levels_of(std::string_view text) {
  int open = 0;
  int most = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') {
      in_string = !in_string;
    } else if (in_string) {
      i += text[i] == '\\' ? 1 : 0;
    } else if (text[i] == '[' || text[i] == '{') {
      most = std::max(most, ++open);
    } else if (text[i] == ']' || text[i] == '}') {
      --open;
    }
  }
  return most;
}

json parsed(std::string_view text) {
  if (levels_of(text) > kMostLevels) {
    throw FalseClaim("its JSON has more than " + std::to_string(kMostLevels) +
                     " levels of nesting");
  }
  json value = json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (value.is_discarded()) {
    throw FalseClaim("its JSON is malformed");
  }
  return value;
}

/// The value of a key; null where there is none.
const json& part(const json& value, const char* key) {
  static const json nothing;
  const auto found = value.is_object() ? value.find(key) : value.end();
  return value.is_object() && found != value.end() ? *found : nothing;
}

/// What a whole number names in a list; null where it names nothing.
const json& named(const json& list, const json& index) {
  static const json nothing;
  const bool is_there =
      list.is_array() && index.is_number_unsigned() && index.get<std::uint64_t>() < list.size();
  return is_there ? list[index.get<std::size_t>()] : nothing;
}

std::uint64_t count_of(const json& accessor) {
  const json& count = part(accessor, "count");
  return count.is_number_unsigned() ? count.get<std::uint64_t>() : 0;
}

/// "https:", "file:"; a path has none.
bool has_scheme(const std::string& uri) {
  const std::size_t end = uri.find_first_of(":/");
  return end != std::string::npos && uri[end] == ':';
}

/// The size of the buffer's file; none for one that the text itself holds.
std::uintmax_t bytes_of_buffer(const std::string& uri, const std::string& place,
                               const fs::path& folder) {
  if (uri.starts_with("data:")) {
    return 0;
  }
  const std::string name = decoded_uri(uri);
  const bool leaves =
      has_scheme(uri) || has_scheme(name) || !problem_of_place(name, folder).empty();
  std::string problem = problem_of_place(uri, folder, "mesh");
  if (problem.empty() && leaves) {
    problem = "expected a path within the mesh's folder, got " + json(uri).dump();
  }
  const fs::path file = folder / name;
  if (problem.empty() && !(problem = reading_problem(file)).empty()) {
    problem = "expected a file of the mesh's, but " + file.string() + ": " + problem;
  }
  if (!problem.empty()) {
    throw FalseClaim(place + ": " + problem);
  }
  return fs::file_size(file);
}

/// What all buffers hold, at most.
std::uintmax_t bytes_of_buffers(const json& gltf, const fs::path& folder) {
  std::uintmax_t bytes = 0;
  const json& buffers = part(gltf, "buffers");  // of glTF 1.0 an object
  if (!buffers.is_structured()) {
    return bytes;
  }
  for (const auto& buffer : buffers.items()) {
    if (const json& uri = part(buffer.value(), "uri"); uri.is_string()) {
      bytes += bytes_of_buffer(uri.get<std::string>(), "/buffers/" + buffer.key() + "/uri", folder);
    }
  }
  return bytes;
}

void check_accessors(const json& gltf, std::uintmax_t bytes) {
  const json& accessors = part(gltf, "accessors");
  for (std::size_t i = 0; accessors.is_array() && i < accessors.size(); ++i) {
    if (const std::uint64_t count = count_of(accessors[i]); count > bytes) {
      throw FalseClaim("/accessors/" + std::to_string(i) + "/count: expected at most the " +
                       std::to_string(bytes) + " bytes of the files, got " + std::to_string(count));
    }
  }
}

double corners_of(const json& gltf, const json& mesh) {
  double corners = 0.0;
  const json& primitives = part(mesh, "primitives");
  for (std::size_t i = 0; primitives.is_array() && i < primitives.size(); ++i) {
    const json& accessors = part(gltf, "accessors");
    const json& places = named(accessors, part(part(primitives[i], "attributes"), "POSITION"));
    const json& indices = named(accessors, part(primitives[i], "indices"));
    corners += static_cast<double>(std::max(count_of(places), count_of(indices)));
  }
  return corners;
}

std::vector<std::uint64_t> nodes_in(const json& list) {
  std::vector<std::uint64_t> nodes;
  for (std::size_t i = 0; list.is_array() && i < list.size(); ++i) {
    nodes.push_back(list[i].is_number_unsigned() ? list[i].get<std::uint64_t>() : UINT64_MAX);
  }
  return nodes;
}

/// Takes note of nodes in a list, of which none may be noted yet.
void note(const std::vector<std::uint64_t>& nodes, const std::string& list,
          std::vector<bool>& noted) {
  for (const std::uint64_t node : nodes) {
    if (node < noted.size() && noted[node]) {
      throw FalseClaim(list + ": expected each node once and in one list, got " +
                       std::to_string(node) + " again");
    }
    if (node < noted.size()) {
      noted[node] = true;
    }
  }
}

/// That they are trees, as glTF has them, and not too deep: each has one parent at most, and is one
/// root of a scene at most.
void check_nodes(const json& nodes, const json& scenes) {
  constexpr int kMostGenerations = 1000;
  for (std::size_t i = 0; scenes.is_array() && i < scenes.size(); ++i) {
    std::vector<bool> roots(nodes.size());
    note(nodes_in(part(scenes[i], "nodes")), "/scenes/" + std::to_string(i) + "/nodes", roots);
  }
  std::vector<bool> has_parent(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    note(nodes_in(part(nodes[i], "children")), "/nodes/" + std::to_string(i) + "/children",
         has_parent);
  }
  std::vector<std::uint64_t> generation;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!has_parent[i]) {
      generation.push_back(i);
    }
  }
  for (int number = 1; !generation.empty(); ++number) {
    if (number > kMostGenerations) {
      throw FalseClaim("/nodes: expected at most " + std::to_string(kMostGenerations) +
                       " nodes one within another, got more");
    }
    std::vector<std::uint64_t> next;
    for (const std::uint64_t node : generation) {
      const std::vector<std::uint64_t> children = nodes_in(part(named(nodes, node), "children"));
      next.insert(next.end(), children.begin(), children.end());
    }
    generation = std::move(next);
  }
}

/// What the nodes place, a mesh as often as they name it.
void check_corners(const json& gltf, const json& nodes) {
  const json& meshes = part(gltf, "meshes");
  std::vector<double> corners_of_mesh;
  for (std::size_t i = 0; meshes.is_array() && i < meshes.size(); ++i) {
    corners_of_mesh.push_back(corners_of(gltf, meshes[i]));
  }
  double corners = 0.0;
  for (const json& node : nodes) {
    const json& mesh = part(node, "mesh");
    if (mesh.is_number_unsigned() && mesh.get<std::uint64_t>() < corners_of_mesh.size()) {
      corners += corners_of_mesh[mesh.get<std::size_t>()];
    }
  }
  if (corners > kMostCorners) {
    throw FalseClaim("/nodes: expected meshes of at most " +
                     std::to_string(static_cast<std::uint64_t>(kMostCorners / 3.0)) +
                     " triangles together, got " +
                     std::to_string(static_cast<std::uint64_t>(corners / 3.0)));
  }
}

}  // namespace

void check_gltf(std::string_view bytes, const fs::path& folder) {
  const json gltf = parsed(json_text(bytes));
  check_accessors(gltf, bytes.size() + bytes_of_buffers(gltf, folder));
  if (const json& nodes = part(gltf, "nodes"); nodes.is_array()) {
    check_nodes(nodes, part(gltf, "scenes"));
    check_corners(gltf, nodes);
  }
}

}  // namespace impetus::inline files
