// SPDX-License-Identifier: MIT
#include "experiments/drawing/sphere_painter.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>

#include "experiments/drawing/lighting_shader.hpp"
#include "experiments/drawing/shader_program.hpp"
#include "experiments/drawing/sphere_image.hpp"
#include "experiments/drawing/sphere_shader.hpp"

namespace impetus::inline drawing {
namespace {

/// What the vertex shader takes for each sphere.
struct SphereInstance {
  float bounds[4];
  float sphere[4];
  float colour[3];
};

void describe_sphere(unsigned place, int numbers, std::size_t offset) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, numbers, GL_FLOAT, GL_FALSE, sizeof(SphereInstance),
                        reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(place, 1);
}

/// The spheres that can be seen, farthest first: a blended edge needs what is behind it.
std::vector<SphereInstance> instances_of(const std::vector<ColouredSphere>& spheres,
                                         const Viewer& viewer) {
  struct Seen {
    double distance_m;
    SphereInstance instance;
  };
  std::vector<Seen> seen;
  for (const ColouredSphere& each : spheres) {
    const double radius_m = each.sphere.radius_m;
    const Vector3 centre = seen_from_eye(viewer, each.sphere.centre);
    const auto bounds = image_of_sphere(centre, radius_m, viewer.screen.viewing_distance_m);
    if (!bounds) {
      continue;
    }
    const auto as_float = [](double value) { return static_cast<float>(value); };
    seen.push_back(
        {centre.norm(),
         {{as_float(bounds->left), as_float(bounds->right), as_float(bounds->bottom),
           as_float(bounds->top)},
          {as_float(centre.x()), as_float(centre.y()), as_float(centre.z()), as_float(radius_m)},
          {each.colour[0], each.colour[1], each.colour[2]}}});
  }
  std::stable_sort(seen.begin(), seen.end(), [](const Seen& one, const Seen& other) {
    return one.distance_m > other.distance_m;
  });
  std::vector<SphereInstance> instances;
  instances.reserve(seen.size());
  for (const Seen& sphere : seen) {
    instances.push_back(sphere.instance);
  }
  return instances;
}

}  // namespace

SpherePainter::SpherePainter(const char* fragment_shader, HidesOthers hides)
    : hides_(hides),
      program_(link_program({kSphereVertexShader}, {kLightingShader, fragment_shader})) {
  glGenVertexArrays(1, &arrangement_);
  glGenBuffers(1, &instances_);
  glBindVertexArray(arrangement_);
  glBindBuffer(GL_ARRAY_BUFFER, instances_);
  describe_sphere(0, 4, offsetof(SphereInstance, bounds));
  describe_sphere(1, 4, offsetof(SphereInstance, sphere));
  describe_sphere(2, 3, offsetof(SphereInstance, colour));
  glBindVertexArray(0);
}

SpherePainter::~SpherePainter() {
  glDeleteBuffers(1, &instances_);
  glDeleteVertexArrays(1, &arrangement_);
  glDeleteProgram(program_);
}

void SpherePainter::paint(const std::vector<ColouredSphere>& spheres, const Viewer& viewer,
                          const PixelArea& area) {
  glViewport(area.left, area.bottom, area.width, area.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(area.left, area.bottom, area.width, area.height);
  const ScreenGeometry& screen = viewer.screen;
  glUseProgram(program_);
  glUniform3f(glGetUniformLocation(program_, "glass"), static_cast<float>(screen.width_m),
              static_cast<float>(screen.height_m), static_cast<float>(screen.viewing_distance_m));
  glUniform2f(glGetUniformLocation(program_, "margin"),
              static_cast<float>(2.0 * screen.width_m / area.width),
              static_cast<float>(2.0 * screen.height_m / area.height));
  const std::vector<SphereInstance> instances = instances_of(spheres, viewer);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(hides_ == HidesOthers::kYes ? GL_TRUE : GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(arrangement_);
  glBindBuffer(GL_ARRAY_BUFFER, instances_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(SphereInstance)),
               instances.data(), GL_STREAM_DRAW);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
  glBindVertexArray(0);
  glDepthMask(GL_TRUE);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace impetus::inline drawing
