// The pictures of the stage gallery: balls, blocks and cubes, plainly and with a ground, lights and
// shadows.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/window/window.hpp"
#include "tests/gallery_pages.hpp"

namespace impetus {

inline constexpr double kDistanceM = 0.57;
inline constexpr double kPi = 3.14159265358979323846;
inline const double kRadiusM = kDistanceM * std::tan(kPi / 180.0);  // 1° at the screen

inline ScreenGeometry lab_screen(const Window& window) {
  const double width_m = 0.376;
  return {width_m, width_m * window.height_px() / window.width_px(), window.width_px(),
          window.height_px(), kDistanceM};
}

/// Two balls of 1° on a line, `apart` radii between their centres.
inline Picture two_balls(const Window& window, double apart, double azimuth_deg) {
  Picture picture;
  picture.viewer = viewer_at(lab_screen(window), azimuth_deg);
  picture.progress = kSome;
  const double half_m = 0.5 * apart * kRadiusM;
  picture.bodies = {
      {{Vector3(-half_m, 0, 0), Quaternion::Identity()}, {"left", kRadiusM, {0.75F, 0.36F, 0.28F}}},
      {{Vector3(half_m, 0, 0), Quaternion::Identity()}, {"right", kRadiusM, {0.34F, 0.5F, 0.72F}}}};
  return picture;
}

/// Many bodies in depth, some behind others.
inline Picture crowd(const Window& window, double time_s) {
  Picture picture = two_balls(window, 2.0, 20.0);
  for (int i = 0; i < 60; ++i) {
    const double angle = 2.399963 * i + time_s;
    const double ring_m = 0.012 * std::sqrt(i);
    const Vector3 centre(ring_m * std::cos(angle), 0.6 * ring_m * std::sin(angle), -0.004 * i);
    const auto shade = static_cast<float>(0.3 + 0.01 * i);
    picture.bodies.push_back(
        {{centre, Quaternion::Identity()}, {"", 0.008, {shade, 0.5F, 0.8F - 0.5F * shade}}});
  }
  return picture;
}

using Mesh = std::shared_ptr<const TriangleMesh>;

inline Mesh shared(TriangleMesh mesh) {
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

inline Mesh box(double width_m, double height_m, double depth_m) {
  return shared(box_mesh(Vector3(width_m, height_m, depth_m)));
}

inline Picture meshes_of(const Window& window, double azimuth_deg, std::vector<PosedBody> bodies) {
  Picture picture;
  picture.viewer = viewer_at(lab_screen(window), azimuth_deg);
  picture.progress = kSome;
  picture.bodies = std::move(bodies);
  return picture;
}

inline Quaternion turned(double deg, const Vector3& axis) {
  return Quaternion(Eigen::AngleAxisd(deg * kPi / 180.0, axis.normalized()));
}

inline constexpr std::array<float, 3> kRed{0.75F, 0.36F, 0.28F};
inline constexpr std::array<float, 3> kBlue{0.34F, 0.5F, 0.72F};

/// Two boxes, each 40 mm wide, whose faces meet in the plane x = 0.
inline Picture two_boxes(const Window& window, double azimuth_deg) {
  static const Mesh mesh = box(0.04, 0.03, 0.03);
  return meshes_of(window, azimuth_deg,
                   {{{Vector3(-0.02, 0, 0), Quaternion::Identity()}, {"", 0.03, kRed, mesh}},
                    {{Vector3(0.02, 0, 0), Quaternion::Identity()}, {"", 0.03, kBlue, mesh}}});
}

/// Two L-blocks that interlock, turned about the x axis as time goes by.
inline Picture two_l_blocks(const Window& window, double azimuth_deg, double tilt_deg) {
  static const Mesh mesh = shared(l_block_mesh(0.06, 0.02));
  const Quaternion tilt = turned(tilt_deg, Vector3::UnitX());
  const Quaternion half = tilt * turned(180.0, Vector3::UnitZ());
  return meshes_of(window, azimuth_deg,
                   {{{tilt * Vector3(-0.04, -0.03, 0), tilt}, {"", 0.07, kRed, mesh}},
                    {{tilt * Vector3(0.04, 0.03, 0), half}, {"", 0.07, kBlue, mesh}}});
}

/// Balls and meshes behind, before and within each other; left a ball, right the same as a mesh.
inline Picture balls_and_meshes(const Window& window, double time_s) {
  static const Mesh cube = box(0.04, 0.04, 0.04);
  static const Mesh ball = shared(icosphere_mesh(0.02, 4));
  static const Mesh slab = box(0.16, 0.004, 0.05);
  const Quaternion turn = turned(30.0 * time_s + 30.0, Vector3(1, 2, 0.5));
  return meshes_of(window, 0.0,
                   {{{Vector3(0, 0, 0), turn}, {"", 0.035, kBlue, cube}},
                    {{Vector3(0.012, 0.01, 0.012), Quaternion::Identity()}, {"", 0.015, kRed}},
                    {{Vector3(0.035, -0.01, -0.03), Quaternion::Identity()}, {"", 0.02, kRed}},
                    {{Vector3(-0.035, 0.01, 0.03), Quaternion::Identity()}, {"", 0.01, kRed}},
                    {{Vector3(0, -0.04, 0), turned(10.0, Vector3::UnitZ())},
                     {"", 0.085, {0.6F, 0.6F, 0.6F}, slab}},
                    {{Vector3(-0.08, 0.05, 0), Quaternion::Identity()}, {"", 0.02, kBlue}},
                    {{Vector3(0.08, 0.05, 0), Quaternion::Identity()}, {"", 0.02, kBlue, ball}}});
}

/// A ball in each corner and three L-blocks within a closed cube; one ball sunk into a wall.
inline Picture enclosed(const Window& window, double azimuth_deg, double half_edge_m) {
  static const Mesh mesh = shared(l_block_mesh(0.06, 0.02));
  Picture picture = meshes_of(
      window, azimuth_deg,
      {{{Vector3(-0.04, 0.02, 0), turned(30.0, Vector3(1, 1, 0))}, {"", 0.07, kRed, mesh}},
       {{Vector3(0.05, -0.03, -0.06), turned(80.0, Vector3(0, 1, 1))}, {"", 0.07, kBlue, mesh}},
       {{Vector3(0, 0, 0.06), turned(10.0, Vector3::UnitY())}, {"", 0.07, kBlue, mesh}},
       {{Vector3(0, 0, -half_edge_m), Quaternion::Identity()}, {"", 0.015, kBlue}}});
  constexpr double kRadius = 0.012;
  for (int corner = 0; corner < 8; ++corner) {
    const double place = half_edge_m - kRadius;
    const Vector3 centre((corner & 1) != 0 ? place : -place, (corner & 2) != 0 ? place : -place,
                         (corner & 4) != 0 ? place : -place);
    picture.bodies.push_back({{centre, Quaternion::Identity()}, {"", kRadius, kRed}});
  }
  picture.enclosure = ClosedCube{half_edge_m};
  picture.pointer = true;
  return picture;
}

/// Two lights, shadows, and a texture on every body.
inline Appearance all_lit(double floor_m, SurfaceTexture texture) {
  Appearance appearance;
  appearance.ground_colour = {0.62F, 0.62F, 0.6F};
  appearance.check_m = 0.02;
  appearance.floor_m = floor_m;
  appearance.lights = {{Vector3(-0.5, 1.0, 0.4).normalized(), 0.8},
                       {Vector3(0.8, 0.6, 0.5).normalized(), 0.4}};
  appearance.cast_shadows = appearance.contact_shadows = 0.6;
  appearance.contact_reach_m = kRadiusM;
  appearance.shadow_reach_m = 0.3;
  appearance.texture = texture;
  return appearance;
}

/// Two balls on a ground, seen from above.
inline Picture on_ground(const Window& window, double time_s) {
  constexpr double kRaised_deg = 15.0;
  Picture picture = two_balls(window, 2.0 + time_s, 0.0);
  picture.viewer = viewer_at(lab_screen(window), 0.0, kRaised_deg);
  Appearance appearance = all_lit(-kRadiusM, SurfaceTexture::kMarble);
  appearance.ground = GroundPattern::kChecks;
  picture.appearance = std::make_shared<const Appearance>(appearance);
  return picture;
}

/// The closed cube, its bodies of wood and with their shadows.
inline Picture enclosed_and_lit(const Window& window, double azimuth_deg) {
  constexpr double kHalfEdge_m = 0.12;
  Picture picture = enclosed(window, azimuth_deg, kHalfEdge_m);
  picture.appearance =
      std::make_shared<const Appearance>(all_lit(-kHalfEdge_m, SurfaceTexture::kWood));
  return picture;
}

}  // namespace impetus
