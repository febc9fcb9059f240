// Meshes on the graphics card: each is handed over once, and forgotten after its end.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <unordered_map>

#include "experiments/drawing/shaded_mesh.hpp"

namespace impetus::inline drawing {

/// Corners as triangles, in OpenGL's names.
struct UploadedMesh {
  unsigned arrangement{0};  ///< a vertex array: positions at 0, normals at 1
  int indices{0};           ///< of 32 bits
};

class UploadedMeshes {
 public:
  /// `describe` adds what a painter needs beside corners to each arrangement, which is bound then.
  /// Needs a current OpenGL 3.3 context, for every call but this.
  explicit UploadedMeshes(std::function<void()> describe = {});
  ~UploadedMeshes();
  UploadedMeshes(const UploadedMeshes&) = delete;
  UploadedMeshes& operator=(const UploadedMeshes&) = delete;

  /// A mesh must not change while anything owns it; its hard edges are those of its first picture.
  /// The answer lasts as long as its mesh does.
  const UploadedMesh& of(const std::shared_ptr<const TriangleMesh>& mesh,
                         double hard_edge_deg = kHardEdgeDeg);

  /// Forgets the meshes that nobody owns any more; call it before a picture.
  void forget_ended();

 private:
  struct Buffers;

  std::function<void()> describe_;
  std::unordered_map<const TriangleMesh*, std::unique_ptr<Buffers>> meshes_;
};

}  // namespace impetus::inline drawing
