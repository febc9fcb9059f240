// SPDX-License-Identifier: MIT
#include "experiments/drawing/ground_painter.hpp"

#include "experiments/drawing/gl.hpp"
#include "experiments/drawing/palette.hpp"
#include "experiments/drawing/picture_map.hpp"

namespace impetus::inline drawing {
namespace {

/// Follows kSceneLightShader: four corners about the place below the world's origin.
constexpr const char* kGroundVertexShader = R"(
const float kHalfSide = 30.0;  // metres, further than it is seen
uniform vec3 glass;            // width, height, distance
uniform vec3 middle;           // below the origin, from the eye
uniform vec3 right;            // along the world's x axis
uniform vec3 back;             // along its z axis
out vec3 from_eye;
out vec2 on_ground;            // metres along the world's x and z axes

void main() {
  on_ground = kHalfSide * (2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0);
  from_eye = middle + on_ground.x * right + on_ground.y * back;
  float ahead = -from_eye.z;
  gl_Position = vec4(2.0 * glass.z * from_eye.xy / glass.xy, ahead - 2.0 * kNear, ahead);
}
)";

/// Follows kSceneLightShader. The fields are averaged over the pixel, so that there is no moiré.
/// (Quilez, filtered checkers)
constexpr const char* kGroundFragmentShader = R"(
const float kDarkField = 0.85;  // of the colour
in vec3 from_eye;
in vec2 on_ground;
uniform vec3 colour;      // sRGB
uniform float field;      // metres; 0: none
uniform float far_grey;   // sRGB
uniform vec2 fading;      // metres from the middle: where it begins, where nothing is left
out vec4 seen;

// Of every second stripe of width 1, the share of the pixel that it takes, from -1 to 1.
vec2 stripes(vec2 at, vec2 pixel) {
  return 2.0 * (abs(fract((at - 0.5 * pixel) / 2.0) - 0.5) -
                abs(fract((at + 0.5 * pixel) / 2.0) - 0.5)) / pixel;
}

void main() {
  vec3 own = colour;
  if (field > 0.0) {
    vec2 at = on_ground / field;
    vec2 share = stripes(at, max(fwidth(at), vec2(1e-4)));
    own *= mix(1.0, kDarkField, 0.5 - 0.5 * share.x * share.y);
  }
  vec3 lit = lit_floor(from_eye, world_up, own);
  float gone = smoothstep(fading.x, fading.y, length(on_ground));
  seen = vec4(mix(lit, vec3(far_grey), gone), 1.0);
}
)";

/// In viewing distances: near enough that the ground's end is no line, far enough that what lies
/// about the bodies is all there.
constexpr double kFadingBegins = 1.5;
constexpr double kFadingEnds = 6.0;

void set_vector(int place, const Vector3& vector) {
  const Eigen::Vector3f numbers = vector.cast<float>();
  glUniform3fv(place, 1, numbers.data());
}

}  // namespace

GroundPainter::GroundPainter()
    : program_({kLightingShader, kSceneLightShader, kGroundVertexShader},
               {kLightingShader, kSceneLightShader, kGroundFragmentShader}) {}

void GroundPainter::paint(const Appearance& appearance, const Viewer& viewer,
                          const SceneLights& lights) {
  if (viewer.eye.y() <= *appearance.floor_m) {
    return;
  }
  const double distance_m = viewer.screen.viewing_distance_m;
  program_.use(viewer);
  lights.shine_on(program_);
  set_vector(program_.uniform("middle"),
             seen_from_eye(viewer, *appearance.floor_m * Vector3::UnitY()));
  set_vector(program_.uniform("right"), seen_direction(viewer, Vector3::UnitX()));
  set_vector(program_.uniform("back"), seen_direction(viewer, Vector3::UnitZ()));
  glUniform3fv(program_.uniform("colour"), 1, appearance.ground_colour.data());
  glUniform1f(program_.uniform("field"), appearance.ground == GroundPattern::kChecks
                                             ? static_cast<float>(appearance.check_m)
                                             : 0.0F);
  glUniform1f(program_.uniform("far_grey"), palette::kPictureGrey);
  glUniform2f(program_.uniform("fading"), static_cast<float>(kFadingBegins * distance_m),
              static_cast<float>(kFadingEnds * distance_m));
  glEnable(GL_DEPTH_TEST);
  glBindVertexArray(arrangement_);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindVertexArray(0);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace impetus::inline drawing
