// Draws the bodies of a crowd that have a mesh: each as coarsely as its distance allows, all of one
// mesh in one call.
//
//   bodies ──by distance──> mesh as seen (session/drawn_levels.hpp) ──> one call per mesh
//
// The nearest come first, so that what is hidden behind them costs next to nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <unordered_map>
#include <vector>

#include "experiments/drawing/uploaded_meshes.hpp"
#include "experiments/record/ports.hpp"

namespace impetus::inline drawing {

class CrowdPainter {
 public:
  /// Needs a current OpenGL 3.3 context, now and for every call.
  CrowdPainter();
  ~CrowdPainter();
  CrowdPainter(const CrowdPainter&) = delete;
  CrowdPainter& operator=(const CrowdPainter&) = delete;

  /// As MeshPainter::paint(), into a viewport that is `height_px` high.
  void paint(const Picture& picture, int height_px);

 private:
  /// What the vertex shader takes for each body.
  struct Instance {
    float place[3];
    float turn[4];
    float colour[3];
  };
  /// The bodies that one mesh stands for.
  struct Alike {
    const UploadedMesh* mesh{nullptr};
    std::vector<Instance> instances;
  };

  void describe_instances() const;
  void sort(const Picture& picture, int height_px);

  unsigned program_{0};
  unsigned instances_{0};
  int glass_{-1};
  UploadedMeshes meshes_;
  std::vector<Alike> groups_;                           ///< of the picture, the nearest first
  std::unordered_map<unsigned, std::size_t> group_of_;  ///< by the mesh's arrangement
};

}  // namespace impetus::inline drawing
