// Draws the bodies of a picture that have a mesh; each mesh is handed to the graphics card once.
//
//   few bodies   one call for each
//   a crowd      bodies ──by distance──> mesh as seen (record/staged_scene.hpp) ──> one call per
//   mesh
//
// Of a crowd the nearest come first, so that what is hidden behind them costs next to nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "experiments/drawing/gl_parts.hpp"
#include "experiments/drawing/scene_lights.hpp"
#include "experiments/record/ports.hpp"

namespace impetus::inline drawing {

/// A mesh on the graphics card. While its owner lasts, no other mesh can have its address.
struct UploadedMesh {
  std::weak_ptr<const TriangleMesh> owner;
  GlName arrangement{GlName::Kind::kVertexArray};  ///< positions at 0, normals at 1
  GlName vertices{GlName::Kind::kBuffer};
  GlName corners{GlName::Kind::kBuffer};  ///< of triangles, as indices of 32 bits
  int indices{0};
};

/// Meshes on the graphics card: each is handed over once, and forgotten after its end.
class UploadedMeshes {
 public:
  /// `describe` adds what a painter needs beside corners to each arrangement, which is bound then.
  explicit UploadedMeshes(std::function<void()> describe = {}) : describe_(std::move(describe)) {}

  /// A mesh must not change while anything owns it. The answer lasts as long as its mesh does.
  const UploadedMesh& of(const std::shared_ptr<const TriangleMesh>& mesh, double hard_edge_deg);

  /// Forgets the meshes that nobody owns any more; call it before a picture.
  void forget_ended();

 private:
  std::function<void()> describe_;
  /// By mesh and hard edges.
  std::map<std::pair<const TriangleMesh*, double>, std::unique_ptr<UploadedMesh>> meshes_;
};

/// The bodies of a picture that have a mesh, or stand for what has none, all of one mesh together.
class BodyInstances {
 public:
  /// What a vertex shader takes for each body, from place 2 on in this order.
  struct Instance {
    float place[3];  ///< from the eye, metres
    float turn[4];   ///< from the body's frame to the viewer's, a unit quaternion: x y z w
    float colour[3];
    float surface[3];  ///< texture (SurfaceTexture), its number among the bodies, and its radius
    float size{1.0F};  ///< of which its mesh is drawn
  };

  BodyInstances();

  /// Takes the picture's bodies with a mesh, the nearest first, each as coarsely as its distance
  /// allows in a viewport that is `height_px` high.
  void take_meshes(const Picture& picture, int height_px, double hard_edge_deg);

  /// Takes the picture's bodies without one, as this mesh of a ball of radius 1.
  void take_balls(const Picture& picture, const std::shared_ptr<const TriangleMesh>& ball);

  /// Draws all of one mesh in one call, with the program in use.
  void draw() const;

 private:
  /// The bodies that one mesh stands for.
  struct Alike {
    const UploadedMesh* mesh{nullptr};
    std::vector<Instance> instances;
  };

  void forget();
  void take(const UploadedMesh& mesh, const Instance& instance);

  GlName instances_{GlName::Kind::kBuffer};
  UploadedMeshes meshes_;
  std::vector<Alike> groups_;                           ///< of the picture, the nearest first
  std::unordered_map<unsigned, std::size_t> group_of_;  ///< by the mesh's arrangement
};

/// Draws each body by itself, lit at every pixel.
class MeshPainter {
 public:
  MeshPainter();

  /// Draws into the current target and viewport, which the viewer's screen fills exactly, with
  /// the depths of the ray-cast spheres. Bodies without a mesh are passed over. A mesh must not
  /// change while anything owns it; it is forgotten at the first call after its end.
  void paint(const Picture& picture);

 private:
  ShaderProgram program_;
  UploadedMeshes meshes_;
};

/// Draws a crowd: each body as coarsely as its distance allows, all of one mesh in one call.
class CrowdPainter {
 public:
  CrowdPainter();

  /// As MeshPainter::paint(), into a viewport that is `height_px` high.
  void paint(const Picture& picture, int height_px);

 private:
  ShaderProgram program_;
  BodyInstances bodies_;
};

/// Draws bodies under a scene's own lights, few or a crowd: each is lit at every pixel.
class SceneLitMeshPainter {
 public:
  SceneLitMeshPainter();

  /// As MeshPainter::paint(), of bodies that were taken from its picture.
  void paint(const BodyInstances& bodies, const Viewer& viewer, const SceneLights& lights);

 private:
  ShaderProgram program_;
};

}  // namespace impetus::inline drawing
