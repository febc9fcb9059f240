// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_meshes.hpp"

#include <stdexcept>

#include "experiments/models/base64.hpp"
#include "experiments/models/mesh_bytes.hpp"

namespace impetus::inline scenes {

std::vector<MeshFile> named_mesh_files(const Scene& scene) {
  std::vector<MeshFile> files;
  const auto add = [&](const ShapeSettings& shape, const std::string& place) {
    if (shape.kind == ShapeKind::kMesh && shape.file) {
      files.push_back({place + "/file", *shape.file});
    }
  };
  if (scene.crowd) {
    add(scene.crowd->shape, "/crowd/shape");
  }
  const auto bodies = scene.named_bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    add(bodies[i].shape, "/bodies/" + std::to_string(i) + "/shape");
  }
  for (const auto& [file, figure] : scene.figure_files) {
    for (std::size_t i = 0; i < figure.parts.size(); ++i) {
      add(figure.parts[i].shape, part_place(file, i) + "/shape");
    }
  }
  return files;
}

TriangleMesh mesh_content(const Meshes& meshes, const std::string& file) {
  const MeshSettings& content = meshes.at(file);
  const std::string bytes = bytes_from_base64(content.base64);
  ByteReader reader(bytes);
  TriangleMesh mesh = take_mesh(reader, {content.vertices, content.triangles});
  const std::string hash = content_hash(mesh);
  if (hash != content.hash || reader.left() > 0) {
    throw std::runtime_error("expected a mesh with the hash " + content.hash + ", got " + hash);
  }
  return mesh;
}

}  // namespace impetus::inline scenes
