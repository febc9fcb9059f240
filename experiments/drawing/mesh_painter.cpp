// SPDX-License-Identifier: MIT
#include "experiments/drawing/mesh_painter.hpp"

#include <algorithm>
#include <cstddef>

#include "experiments/drawing/gl.hpp"
#include "experiments/drawing/picture_map.hpp"
#include "experiments/drawing/shaded_mesh.hpp"

namespace impetus::inline drawing {
namespace {

/// Follows kLightingShader; lengths in metres, the eye at the origin.
constexpr const char* kMeshVertexShader = R"(
layout(location = 0) in vec3 vertex;  // in the body's frame
layout(location = 1) in vec3 normal;
uniform vec3 glass;                   // width, height, distance
uniform mat3 turn;                    // from the body's frame to the viewer's
uniform vec3 place;                   // of the body, from the eye
out vec3 from_eye;
centroid out vec3 upright;

void main() {
  from_eye = turn * vertex + place;
  upright = turn * normal;
  float ahead = -from_eye.z;
  gl_Position = vec4(2.0 * glass.z * from_eye.xy / glass.xy, ahead - 2.0 * kNear, ahead);
}
)";

/// Follows kLightingShader.
constexpr const char* kMeshFragmentShader = R"(
in vec3 from_eye;
centroid in vec3 upright;
uniform vec3 colour;  // sRGB
out vec4 seen;

void main() {
  seen = vec4(light(normalize(upright), -normalize(from_eye), colour), 1.0);
}
)";

/// Follows kLightingShader, in the perspective and the depth of kMeshVertexShader. Each instance
/// brings its place, turn and colour; light is found at the corners, for a crowd's triangles are a
/// few pixels wide.
constexpr const char* kCrowdVertexShader = R"(
layout(location = 0) in vec3 vertex;  // in the body's frame
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 place;   // of the body, from the eye
layout(location = 3) in vec4 turn;    // from the body's frame to the viewer's, a unit quaternion
layout(location = 4) in vec3 colour;  // sRGB
uniform vec3 glass;                   // width, height, distance
centroid out vec3 lit;

vec3 turned(vec3 v) {
  return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v);
}

void main() {
  vec3 from_eye = turned(vertex) + place;
  lit = light(turned(normal), -normalize(from_eye), colour);
  float ahead = -from_eye.z;
  gl_Position = vec4(2.0 * glass.z * from_eye.xy / glass.xy, ahead - 2.0 * kNear, ahead);
}
)";

constexpr const char* kCrowdFragmentShader = R"(
centroid in vec3 lit;
out vec4 seen;

void main() { seen = vec4(lit, 1.0); }
)";

/// Where few triangles stand for a round surface, they meet at greater angles.
constexpr double kHardCoarseEdgeDeg = 60.0;

/// Follows kSceneLightShader: as kCrowdVertexShader, and lit at every pixel.
constexpr const char* kSceneLitVertexShader = R"(
layout(location = 0) in vec3 vertex;   // in the body's frame
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 place;    // of the body, from the eye
layout(location = 3) in vec4 turn;     // from the body's frame to the viewer's, a unit quaternion
layout(location = 4) in vec3 colour;   // sRGB
layout(location = 5) in vec3 surface;  // texture, number, radius
uniform vec3 glass;                    // width, height, distance
out vec3 from_eye;
out vec3 on_body;
centroid out vec3 upright;
flat out vec3 paint;
flat out vec3 made_of;

void main() {
  from_eye = turned(turn, vertex) + place;
  on_body = vertex;
  upright = turned(turn, normal);
  paint = colour;
  made_of = surface;
  float ahead = -from_eye.z;
  gl_Position = vec4(2.0 * glass.z * from_eye.xy / glass.xy, ahead - 2.0 * kNear, ahead);
}
)";

/// Follows kSceneLightShader.
constexpr const char* kSceneLitFragmentShader = R"(
in vec3 from_eye;
in vec3 on_body;
centroid in vec3 upright;
flat in vec3 paint;
flat in vec3 made_of;
out vec4 seen;

void main() {
  seen = vec4(lit_body(from_eye, normalize(upright), on_body, paint, made_of), 1.0);
}
)";

/// A body, and where it is from the eye.
struct SeenBody {
  const PosedBody* body{nullptr};
  Vector3 from_eye{Vector3::Zero()};

  /// Along the line of sight; never behind the eye's own plane.
  [[nodiscard]] double ahead_m() const { return std::max(-from_eye.z(), 1e-6); }
};

std::vector<SeenBody> nearest_first(const Picture& picture) {
  std::vector<SeenBody> bodies;
  for (const PosedBody& body : picture.bodies) {
    if (body.look.mesh) {
      bodies.push_back({&body, seen_from_eye(picture.viewer, body.pose.position)});
    }
  }
  std::stable_sort(bodies.begin(), bodies.end(), [](const SeenBody& one, const SeenBody& other) {
    return one.ahead_m() < other.ahead_m();
  });
  return bodies;
}

/// Poses are combined in double precision: the card sees only numbers near the eye.
BodyInstances::Instance instance_of(const Picture& picture, const SeenBody& seen) {
  const DrawnBody& look = seen.body->look;
  const Eigen::Vector3f at = seen.from_eye.cast<float>();
  const Eigen::Quaternionf turn =
      (Quaternion(rotation_to_eye(picture.viewer)) * seen.body->pose.orientation)
          .normalized()
          .cast<float>();
  return {{at.x(), at.y(), at.z()},
          {turn.x(), turn.y(), turn.z(), turn.w()},
          {look.colour[0], look.colour[1], look.colour[2]},
          {texture_number(picture, look), static_cast<float>(seen.body - picture.bodies.data()),
           static_cast<float>(look.radius_m)}};
}

void begin_meshes() {
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
}

void end_meshes() {
  glBindVertexArray(0);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace

void UploadedMeshes::forget_ended() {
  std::erase_if(meshes_, [](const auto& entry) { return entry.second->owner.expired(); });
}

const UploadedMesh& UploadedMeshes::of(const std::shared_ptr<const TriangleMesh>& mesh,
                                       double hard_edge_deg) {
  std::unique_ptr<UploadedMesh>& place = meshes_[{mesh.get(), hard_edge_deg}];
  if (!place) {
    const ShadedMesh ready = shaded_mesh(*mesh, hard_edge_deg);
    place = std::make_unique<UploadedMesh>();
    place->owner = mesh;
    place->indices = static_cast<int>(ready.indices.size());
    glBindVertexArray(place->arrangement);
    fill_buffer(GL_ARRAY_BUFFER, place->vertices, ready.vertices, GL_STATIC_DRAW);
    fill_buffer(GL_ELEMENT_ARRAY_BUFFER, place->corners, ready.indices, GL_STATIC_DRAW);
    describe_records(
        RecordOf::kVertex, sizeof(ShadedVertex),
        {{0, 3, offsetof(ShadedVertex, position)}, {1, 3, offsetof(ShadedVertex, normal)}});
    if (describe_) {
      describe_();
    }
    glBindVertexArray(0);
  }
  return *place;
}

MeshPainter::MeshPainter()
    : program_({kLightingShader, kMeshVertexShader}, {kLightingShader, kMeshFragmentShader}) {}

// Poses are combined in double precision: the card sees only numbers near the eye.
void MeshPainter::paint(const Picture& picture) {
  const Matrix3 R_EW = rotation_to_eye(picture.viewer);
  meshes_.forget_ended();
  program_.use(picture.viewer);
  const int turn_at = program_.uniform("turn");
  const int place_at = program_.uniform("place");
  const int colour_at = program_.uniform("colour");
  begin_meshes();
  for (const PosedBody& body : picture.bodies) {
    if (!body.look.mesh) {
      continue;
    }
    const Eigen::Matrix3f turn =
        (R_EW * body.pose.orientation.normalized().toRotationMatrix()).cast<float>();
    const Eigen::Vector3f place = seen_from_eye(picture.viewer, body.pose.position).cast<float>();
    const UploadedMesh& mesh = meshes_.of(body.look.mesh, kUsualSmoothing_deg);
    glUniformMatrix3fv(turn_at, 1, GL_FALSE, turn.data());
    glUniform3fv(place_at, 1, place.data());
    glUniform3fv(colour_at, 1, body.look.colour.data());
    glBindVertexArray(mesh.arrangement);
    glDrawElements(GL_TRIANGLES, mesh.indices, GL_UNSIGNED_INT, nullptr);
  }
  end_meshes();
}

BodyInstances::BodyInstances()
    : meshes_([this] {
        glBindBuffer(GL_ARRAY_BUFFER, instances_);
        describe_records(RecordOf::kInstance, sizeof(Instance),
                         {{2, 3, offsetof(Instance, place)},
                          {3, 4, offsetof(Instance, turn)},
                          {4, 3, offsetof(Instance, colour)},
                          {5, 3, offsetof(Instance, surface)},
                          {6, 1, offsetof(Instance, size)}});
      }) {}

void BodyInstances::forget() {
  meshes_.forget_ended();
  groups_.clear();
  group_of_.clear();
}

void BodyInstances::take(const UploadedMesh& mesh, const Instance& instance) {
  const auto [place, is_new] = group_of_.try_emplace(mesh.arrangement, groups_.size());
  if (is_new) {
    groups_.push_back({&mesh, {}});
  }
  groups_[place->second].instances.push_back(instance);
}

void BodyInstances::take_meshes(const Picture& picture, int height_px, double hard_edge_deg) {
  const ScreenGeometry& screen = picture.viewer.screen;
  const double px_at_a_metre = height_px * screen.viewing_distance_m / screen.height_m;
  forget();
  for (const SeenBody& seen : nearest_first(picture)) {
    const DrawnBody& look = seen.body->look;
    const double nearest_m = std::max(seen.ahead_m() - look.radius_m, 1e-6);
    const auto& chosen = mesh_as_seen(look.mesh, look.coarser.get(), px_at_a_metre / nearest_m);
    const double hard_deg =
        chosen == look.mesh ? hard_edge_deg : std::max(hard_edge_deg, kHardCoarseEdgeDeg);
    take(meshes_.of(chosen, hard_deg), instance_of(picture, seen));
  }
}

void BodyInstances::take_balls(const Picture& picture,
                               const std::shared_ptr<const TriangleMesh>& ball) {
  forget();
  for (const PosedBody& body : picture.bodies) {
    if (!body.look.mesh) {
      Instance instance =
          instance_of(picture, {&body, seen_from_eye(picture.viewer, body.pose.position)});
      instance.size = static_cast<float>(body.look.radius_m);
      take(meshes_.of(ball, kUsualSmoothing_deg), instance);
    }
  }
}

void BodyInstances::draw() const {
  for (const Alike& alike : groups_) {
    glBindVertexArray(alike.mesh->arrangement);
    fill_buffer(GL_ARRAY_BUFFER, instances_, alike.instances, GL_STREAM_DRAW);
    glDrawElementsInstanced(GL_TRIANGLES, alike.mesh->indices, GL_UNSIGNED_INT, nullptr,
                            static_cast<GLsizei>(alike.instances.size()));
  }
  glBindVertexArray(0);
}

CrowdPainter::CrowdPainter()
    : program_({kLightingShader, kCrowdVertexShader}, {kCrowdFragmentShader}) {}

void CrowdPainter::paint(const Picture& picture, int height_px) {
  bodies_.take_meshes(picture, height_px, kUsualSmoothing_deg);
  program_.use(picture.viewer);
  begin_meshes();
  bodies_.draw();
  end_meshes();
}

SceneLitMeshPainter::SceneLitMeshPainter()
    : program_({kLightingShader, kSceneLightShader, kSceneLitVertexShader},
               {kLightingShader, kSceneLightShader, kSceneLitFragmentShader}) {}

void SceneLitMeshPainter::paint(const BodyInstances& bodies, const Viewer& viewer,
                                const SceneLights& lights) {
  program_.use(viewer);
  lights.shine_on(program_);
  begin_meshes();
  bodies.draw();
  end_meshes();
}

}  // namespace impetus::inline drawing
