// Paints a picture: spheres, meshes and the walls round them in exact perspective, lit, on a
// neutral mid-grey ground.
//
//   eye ──── ray through a pixel of the glass ────> sphere      every pixel asks the sphere itself,
//                     |<- bounds of its image ->|               so it is round at any size
//
// The screen is the plane through the world's origin that faces the eye: a metre there is a metre
// on the glass. Edges of spheres are blended by the share of the pixel that is covered; a picture
// with straight edges (meshes, walls) is drawn with four samples per pixel, one without goes
// straight to the window. So does one of more than a hundred bodies, whose edges are then not
// blended: without a graphics card, four samples would take more than twice the time. The rule is
// the same with a card, for pictures must not depend on the machine.
//
// A picture with an appearance has lights of its own, shadows and perhaps a ground, and each of its
// painters knows them (scene_lights.hpp); one without is painted as ever, pixel by pixel.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "experiments/drawing/enclosure_painter.hpp"
#include "experiments/drawing/gl_parts.hpp"
#include "experiments/drawing/ground_painter.hpp"
#include "experiments/drawing/mesh_painter.hpp"
#include "experiments/drawing/scene_lights.hpp"
#include "experiments/drawing/sphere_painter.hpp"
#include "experiments/drawing/volume_painter.hpp"
#include "experiments/record/ports.hpp"

namespace impetus::inline drawing {

/// Paints pictures and what is drawn over them.
class ScenePainter {
 public:
  ScenePainter();

  /// Fills the area with a grey (sRGB, 0–1).
  void fill(const PixelArea& area, float grey);

  /// Paints ground, enclosure, bodies and fixation cross; the viewer's screen fills the area
  /// exactly. `volumes` are drawn over it, translucent, where nothing is in front of them.
  void paint(const Picture& picture, const PixelArea& area,
             const std::vector<ColouredVolume>& volumes = {});

  /// The same onto another framebuffer of OpenGL's, of the area's size, at 0, 0.
  void paint_onto(unsigned framebuffer, const Picture& picture, const PixelArea& area,
                  const std::vector<ColouredVolume>& volumes);

 private:
  void paint_multisampled(const Picture& picture, const std::vector<ColouredVolume>& volumes,
                          const PixelArea& area, unsigned framebuffer = 0);
  void paint_all(const Picture& picture, const std::vector<ColouredVolume>& volumes,
                 const PixelArea& area);
  void paint_plainly(const Picture& picture, const PixelArea& area);
  void prepare_lights(const Picture& picture, int height_px);
  void paint_lit_by_scene(const Picture& picture, const PixelArea& area);
  void paint_volumes(const Picture& picture, const std::vector<ColouredVolume>& volumes,
                     const PixelArea& area);
  void paint_fixation(const ScreenGeometry& screen, const PixelArea& area);

  SpherePainter balls_{BallKind::kOpaque};
  SpherePainter clear_balls_{BallKind::kClear};
  VolumePainter shells_;
  EnclosurePainter enclosure_{LitBy::kUsualLight};
  MeshPainter meshes_;
  CrowdPainter crowd_;
  MultisampledTarget target_;

  std::shared_ptr<const TriangleMesh> ball_;  ///< of radius 1: what casts the shadow of a sphere
  SceneLights lights_;
  BodyInstances lit_meshes_;
  BodyInstances casting_balls_;
  GroundPainter ground_;
  EnclosurePainter lit_enclosure_{LitBy::kSceneLights};
  SceneLitMeshPainter lit_mesh_painter_;
  SpherePainter lit_balls_{BallKind::kSceneLit};
};

}  // namespace impetus::inline drawing
