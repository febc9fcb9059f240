// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_meshes.hpp"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string_view>

#include "experiments/models/base64.hpp"
#include "experiments/models/file_place.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/models/mesh_file.hpp"
#include "experiments/models/mesh_report.hpp"

namespace impetus {
namespace {

using nlohmann::json;

bool leaves_the_folder(const std::filesystem::path& file) {
  return file.is_absolute() || std::find(file.begin(), file.end(), "..") != file.end();
}

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
  return files;
}

std::string hold_mesh(json& scene, const std::string& file, const std::filesystem::path& folder) {
  if (scene.contains("meshes") && scene["meshes"].contains(file)) {
    return "";
  }
  if (leaves_the_folder(file)) {
    return "expected a path within the scene's folder, got " + json(file).dump();
  }
  const std::filesystem::path own = folder.empty() ? "." : folder;
  if (std::filesystem::exists(own / file) && !is_really_within(own / file, own)) {
    return "expected a file within the scene's folder, got " + json(file).dump() +
           ", which is a link out of it";
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

}  // namespace impetus
