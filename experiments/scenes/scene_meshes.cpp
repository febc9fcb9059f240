// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_meshes.hpp"

#include <exception>
#include <stdexcept>
#include <string_view>

#include "experiments/models/base64.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/models/mesh_file.hpp"
#include "experiments/models/mesh_report.hpp"
#include "experiments/models/readable_file.hpp"
#include "experiments/scenes/figures/figure_files.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

json content_of(const TriangleMesh& mesh) {
  std::string bytes;
  append_mesh(bytes, mesh);
  return {{"vertices", mesh.vertices.size()},
          {"triangles", mesh.triangles.size()},
          {"hash", content_hash(mesh)},
          {"base64", base64(bytes)}};
}

}  // namespace

bool is_mesh(const json& shape) { return shape["kind"].get_ref<const std::string&>() == "mesh"; }

std::vector<MeshFile> mesh_files_of(const json& scene) {
  std::vector<MeshFile> files;
  const auto add = [&](const json& shape, const std::string& place) {
    if (is_mesh(shape) && shape.contains("file")) {
      files.push_back({place + "/file", shape["file"].get<std::string>()});
    }
  };
  if (scene.contains("crowd")) {
    add(scene["crowd"]["shape"], "/crowd/shape");
  }
  const std::size_t bodies = scene.contains("bodies") ? scene["bodies"].size() : 0;
  for (std::size_t i = 0; i < bodies; ++i) {
    add(scene["bodies"][i]["shape"], "/bodies/" + std::to_string(i) + "/shape");
  }
  const json figures = scene.value("figure_files", json::object());
  for (auto figure = figures.begin(); figure != figures.end(); ++figure) {
    const json& parts = figure.value()["parts"];
    for (std::size_t i = 0; i < parts.size(); ++i) {
      add(parts[i]["shape"], part_place(figure.key(), i) + "/shape");
    }
  }
  return files;
}

std::string hold_mesh(json& scene, const std::string& file, const std::filesystem::path& folder) {
  if (scene.contains("meshes") && scene["meshes"].contains(file)) {
    return "";
  }
  std::string misplaced = problem_of_place(file, folder);
  if (!misplaced.empty()) {
    return misplaced;
  }
  try {
    const TriangleMesh mesh = load_mesh(folder / file);
    const std::string problem = refusal(report_mesh(mesh));
    if (!problem.empty()) {
      return "expected a closed mesh, but " + (folder / file).string() + " " + problem;
    }
    scene["meshes"][file] = content_of(mesh);
  } catch (const std::exception& error) {
    return std::string("expected a mesh file, but ") + error.what();
  }
  return "";
}

TriangleMesh mesh_content(const json& meshes, const std::string& file) {
  const json& content = meshes.at(file);
  const std::string bytes = bytes_from_base64(content["base64"].get_ref<const std::string&>());
  ByteReader reader(bytes);
  TriangleMesh mesh = take_mesh(reader, {content["vertices"].get<std::uint64_t>(),
                                         content["triangles"].get<std::uint64_t>()});
  const std::string hash = content_hash(mesh);
  const auto stated = content["hash"].get<std::string>();
  if (hash != stated || reader.left() > 0) {
    throw std::runtime_error("expected a mesh with the hash " + stated + ", got " + hash);
  }
  return mesh;
}

}  // namespace impetus::inline scenes
