// SPDX-License-Identifier: MIT
#include "experiments/stage/scene_painter.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/numerics/trigonometry.hpp"
#include "experiments/stage/lighting_shader.hpp"
#include "experiments/stage/palette.hpp"
#include "experiments/stage/shader_program.hpp"
#include "experiments/stage/sphere_image.hpp"
#include "experiments/stage/sphere_shader.hpp"

namespace impetus {
namespace {

constexpr float kCrossGrey = 0.13F;
constexpr double kCrossArmDeg = 0.6;
constexpr double kCrossThicknessDeg = 0.08;

/// What the vertex shader takes for each sphere.
struct Instance {
  float bounds[4];
  float sphere[4];
  float colour[3];
};

void describe_attribute(unsigned place, int numbers, std::size_t offset) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, numbers, GL_FLOAT, GL_FALSE, sizeof(Instance),
                        reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(place, 1);
}

bool has_mesh(const PosedBody& body) { return body.look.mesh != nullptr; }

/// The spheres that can be seen, farthest first: a blended edge needs what is behind it.
std::vector<Instance> instances_of(const Picture& picture) {
  struct Seen {
    double distance_m;
    Instance instance;
  };
  std::vector<Seen> seen;
  const double glass_m = picture.viewer.screen.viewing_distance_m;
  for (const PosedBody& body : picture.bodies) {
    if (has_mesh(body)) {
      continue;
    }
    const Vector3 centre = seen_from_eye(picture.viewer, body.pose.position);
    const auto bounds = image_of_sphere(centre, body.look.radius_m, glass_m);
    if (!bounds) {
      continue;
    }
    const auto as_float = [](double value) { return static_cast<float>(value); };
    seen.push_back({centre.norm(),
                    {{as_float(bounds->left), as_float(bounds->right), as_float(bounds->bottom),
                      as_float(bounds->top)},
                     {as_float(centre.x()), as_float(centre.y()), as_float(centre.z()),
                      as_float(body.look.radius_m)},
                     {body.look.colour[0], body.look.colour[1], body.look.colour[2]}}});
  }
  std::stable_sort(seen.begin(), seen.end(), [](const Seen& one, const Seen& other) {
    return one.distance_m > other.distance_m;
  });
  std::vector<Instance> instances;
  instances.reserve(seen.size());
  for (const Seen& body : seen) {
    instances.push_back(body.instance);
  }
  return instances;
}

}  // namespace

ScenePainter::ScenePainter()
    : program_(link_program({kSphereVertexShader}, {kLightingShader, kSphereFragmentShader})) {
  glGenVertexArrays(1, &arrangement_);
  glGenBuffers(1, &instances_);
  glBindVertexArray(arrangement_);
  glBindBuffer(GL_ARRAY_BUFFER, instances_);
  describe_attribute(0, 4, offsetof(Instance, bounds));
  describe_attribute(1, 4, offsetof(Instance, sphere));
  describe_attribute(2, 3, offsetof(Instance, colour));
  glBindVertexArray(0);
}

ScenePainter::~ScenePainter() {
  glDeleteBuffers(1, &instances_);
  glDeleteVertexArrays(1, &arrangement_);
  glDeleteProgram(program_);
}

void ScenePainter::fill(const PixelArea& area, float grey) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(area.left, area.bottom, area.width, area.height);
  glClearColor(grey, grey, grey, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

void ScenePainter::paint(const Picture& picture, const PixelArea& area) {
  const bool straight_edges =
      picture.enclosure || std::any_of(picture.bodies.begin(), picture.bodies.end(), has_mesh);
  if (straight_edges) {
    paint_multisampled(picture, area);
  } else {
    fill(area, palette::kPictureGrey);
    paint_spheres(picture, area);
  }
  if (picture.fixation_cross) {
    paint_fixation(picture.viewer.screen, area);
  }
}

// Walls and meshes first: a sphere's blended edge needs what is behind it, and each of a pixel's
// samples knows whether one of them is in front.
void ScenePainter::paint_multisampled(const Picture& picture, const PixelArea& area) {
  const PixelArea all{0, 0, area.width, area.height};
  target_.begin(area.width, area.height);
  fill(all, palette::kPictureGrey);
  glViewport(0, 0, area.width, area.height);
  if (picture.enclosure) {
    enclosure_.paint(*picture.enclosure, picture.viewer);
  }
  meshes_.paint(picture);
  paint_spheres(picture, all);
  target_.end_onto(area);
}

void ScenePainter::paint_spheres(const Picture& picture, const PixelArea& area) {
  glViewport(area.left, area.bottom, area.width, area.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(area.left, area.bottom, area.width, area.height);
  const ScreenGeometry& screen = picture.viewer.screen;
  glUseProgram(program_);
  glUniform3f(glGetUniformLocation(program_, "glass"), static_cast<float>(screen.width_m),
              static_cast<float>(screen.height_m), static_cast<float>(screen.viewing_distance_m));
  glUniform2f(glGetUniformLocation(program_, "margin"),
              static_cast<float>(2.0 * screen.width_m / area.width),
              static_cast<float>(2.0 * screen.height_m / area.height));
  const std::vector<Instance> instances = instances_of(picture);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(arrangement_);
  glBindBuffer(GL_ARRAY_BUFFER, instances_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)),
               instances.data(), GL_STREAM_DRAW);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
  glBindVertexArray(0);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
}

// Filled rectangles of whole pixels: a cross of even thickness is sharp on a screen of even size.
void ScenePainter::paint_fixation(const ScreenGeometry& screen, const PixelArea& area) {
  const auto pixels = [&](double deg) {
    const SineCosine angle = sine_cosine_deg(deg);
    const double length_m = screen.viewing_distance_m * angle.sine / angle.cosine;
    return static_cast<int>(std::lround(length_m / screen.width_m * area.width));
  };
  const int arm = std::max(4, pixels(kCrossArmDeg));
  const int half = std::max(1, pixels(kCrossThicknessDeg / 2.0));
  const int x = area.left + area.width / 2;
  const int y = area.bottom + area.height / 2;
  fill({x - arm, y - half, 2 * arm, 2 * half}, kCrossGrey);
  fill({x - half, y - arm, 2 * half, 2 * arm}, kCrossGrey);
}

}  // namespace impetus
