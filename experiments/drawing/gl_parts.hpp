// What every painter of this room is made of: buffers, shaders, how any surface is lit, and a
// target with four samples per pixel.
//
// All of this room needs a current OpenGL 3.3 context, when a thing is made, used, and when it
// ends.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <initializer_list>
#include <vector>

#include "engine/scheduling/viewer.hpp"
#include "experiments/drawing/picture_map.hpp"

namespace impetus::inline drawing {

/// A thing on the graphics card, which goes when this does.
class GlName {
 public:
  /// What is named, in OpenGL's words.
  enum class Kind { kBuffer, kVertexArray, kFramebuffer, kRenderbuffer, kTexture };

  explicit GlName(Kind kind);
  ~GlName();
  GlName(const GlName&) = delete;
  GlName& operator=(const GlName&) = delete;

  operator unsigned() const { return name_; }

 private:
  Kind kind_;
  unsigned name_{0};
};

/// The two shaders of a painter, compiled and linked.
class ShaderProgram {
 public:
  /// Each text is given in parts, without the version of the language. Throws std::runtime_error
  /// with the driver's words when it refuses.
  ShaderProgram(std::initializer_list<const char*> vertex,
                std::initializer_list<const char*> fragment);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  /// What is drawn from now on is drawn by it; its uniform `glass` is the viewer's screen.
  void use(const Viewer& viewer) const;

  /// Where a uniform is.
  [[nodiscard]] int uniform(const char* name) const;

 private:
  unsigned name_;
};

/// An input of a vertex shader: so many floats of a record, from this byte on.
struct VertexField {
  unsigned place{0};
  int numbers{0};
  std::size_t offset{0};
};

/// What a record belongs to: a vertex, or a whole body or volume, drawn as one of many alike.
enum class RecordOf { kVertex, kInstance };

/// Tells the arrangement that is bound how the records of the buffer that is bound are made up.
void describe_records(RecordOf what, std::size_t record_bytes,
                      std::initializer_list<VertexField> fields);

/// Binds the buffer as this kind (OpenGL's word) and hands it these bytes, for this usage.
void fill_buffer(unsigned kind, unsigned buffer, const void* bytes, std::size_t count,
                 unsigned usage);

template <typename T>
void fill_buffer(unsigned kind, unsigned buffer, const std::vector<T>& values, unsigned usage) {
  fill_buffer(kind, buffer, values.data(), values.size() * sizeof(T), usage);
}

/// What light falls on a painter's surfaces: the usual one (kLightingShader), or a scene's own,
/// with shadows and textures (kSceneLightShader of scene_lights.hpp, which follows the other).
enum class LitBy { kUsualLight, kSceneLights };

/// How any surface is lit, in the shaders' own language: put in front of a shader's text.
/// light(normal, towards_eye, colour): unit vectors as the viewer sees them, colour and result
/// sRGB. kNear and the depth 1 − kNear / distance are the same for every kind of body.
inline constexpr const char* kLightingShader = R"(
const vec3 kKeyLight = normalize(vec3(-0.55, 0.75, 0.60));  // from the viewer's upper left
const vec3 kSky = vec3(0.34);
const vec3 kFloor = vec3(0.17);
const float kNear = 0.01;

vec3 linear_from_srgb(vec3 c) {
  return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}
vec3 srgb_from_linear(vec3 c) {
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

vec3 light(vec3 normal, vec3 towards_eye, vec3 colour) {
  float facing = max(dot(normal, kKeyLight), 0.0);
  vec3 ambient = mix(kFloor, kSky, 0.5 + 0.5 * normal.y);
  vec3 diffuse = linear_from_srgb(colour) * (ambient + 0.85 * facing);
  float gloss = pow(max(dot(normal, normalize(kKeyLight + towards_eye)), 0.0), 48.0);
  return srgb_from_linear(min(diffuse + 0.10 * gloss, 1.0));
}
)";

/// A picture off the window with four samples per pixel, averaged onto the window when it is done;
/// takes no memory until begin().
class MultisampledTarget {
 public:
  /// Everything is drawn here from now on, at 0, 0 and in the given size (pixels). The memory is
  /// kept for the next picture of this size. Throws std::runtime_error when the driver refuses.
  void begin(int width, int height);

  /// Averages the picture onto the area of the window, or of another framebuffer of OpenGL's, which
  /// must have the size given to begin(), and draws to the window again.
  void end_onto(const PixelArea& area, unsigned framebuffer = 0);

 private:
  void allocate(int width, int height);

  GlName framebuffer_{GlName::Kind::kFramebuffer};
  GlName colour_{GlName::Kind::kRenderbuffer};
  GlName depth_{GlName::Kind::kRenderbuffer};
  int width_{0};
  int height_{0};
};

}  // namespace impetus::inline drawing
