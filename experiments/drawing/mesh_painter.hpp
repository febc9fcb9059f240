// Draws the bodies of a picture that have a mesh; each mesh is handed to the graphics card once.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/drawing/uploaded_meshes.hpp"
#include "experiments/record/ports.hpp"

namespace impetus::inline drawing {

class MeshPainter {
 public:
  /// Needs a current OpenGL 3.3 context, now and for every call.
  MeshPainter();
  ~MeshPainter();
  MeshPainter(const MeshPainter&) = delete;
  MeshPainter& operator=(const MeshPainter&) = delete;

  /// Draws into the current target and viewport, which the viewer's screen fills exactly, with
  /// the depths of the ray-cast spheres. Bodies without a mesh are passed over. A mesh must not
  /// change while anything owns it; it is forgotten at the first call after its end.
  void paint(const Picture& picture);

 private:
  void paint_body(const Viewer& viewer, const PosedBody& body);

  unsigned program_{0};
  int glass_{-1};
  int turn_{-1};
  int place_{-1};
  int colour_{-1};
  UploadedMeshes meshes_;
};

}  // namespace impetus::inline drawing
