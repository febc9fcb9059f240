// The lights of a scene that has an appearance, and the shadows of its bodies.
//
//   bodies ──seen from each light──> depths of their far sides ──> who is in the light's way (cast)
//   bodies ──seen from below──> heights above the floor ──blurred──> how closed it is (contact)
//
// A cast shadow is soft by looking at sixteen places of the light's map (Williams 1978; Reeves,
// Salesin and Cook 1987). A map has the sides of the bodies that are turned from its light: those
// that are lit are not in it and cannot shadow themselves, as all meshes are closed. Maps lie still
// about the world's origin, so that shadows do not crawl while bodies move.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>

#include "experiments/drawing/gl_parts.hpp"
#include "experiments/drawing/scene_light_shader.hpp"
#include "experiments/record/ports.hpp"

namespace impetus::inline drawing {

/// The texture of a body as shaders have it.
float texture_number(const Picture& picture, const DrawnBody& look);

/// Lights and shadows of one picture after the other. Takes no memory for shadows until a picture
/// has some.
class SceneLights {
 public:
  SceneLights();

  /// Finds the shadows of a picture that has an appearance. `draw_bodies` draws them all, as
  /// BodyInstances does, with the program that is in use then. Afterwards the window is drawn to.
  void prepare(const Picture& picture, const std::function<void()>& draw_bodies);

  /// Hands lights and shadows to a program that is in use and has kSceneLightShader.
  void shine_on(const ShaderProgram& program) const;

 private:
  /// What is seen along one direction.
  struct MapView {
    Eigen::Matrix4f from_eye{Eigen::Matrix4f::Identity()};  ///< to 0–1 on the map and in depth
    Eigen::AlignedBox2f bodies;                             ///< the part of the map with bodies
  };

  void reserve_maps(std::size_t lights);
  void cast(const Picture& picture, const std::function<void()>& draw_bodies);
  void touch(const Picture& picture, const std::function<void()>& draw_bodies);
  void draw_depths(const MapView& view, int side_px,
                   const std::function<void()>& draw_bodies) const;
  void blur_floor() const;

  ShaderProgram caster_;
  ShaderProgram blur_;
  GlName depths_{GlName::Kind::kFramebuffer};  ///< draws onto a map
  GlName blurs_{GlName::Kind::kFramebuffer};
  GlName maps_{GlName::Kind::kTexture};  ///< one layer for each light
  GlName floor_map_{GlName::Kind::kTexture};
  GlName half_blurred_{GlName::Kind::kTexture};
  GlName closed_{GlName::Kind::kTexture};
  GlName nothing_{GlName::Kind::kVertexArray};
  std::size_t layers_{0};  ///< for which there is memory

  Viewer viewer_;
  Appearance appearance_;
  std::array<MapView, kMostLights> views_{};  ///< of the lights
  MapView floor_;
};

}  // namespace impetus::inline drawing
