// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_meeting.hpp"

#include <string>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/run/collision_truth.hpp"
#include "experiments/run/meeting.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene_enclosure.hpp"

namespace impetus::inline scenes {
namespace {

/// At contact the bodies overlap by this share of their distance: far below a pixel, far above what
/// rounding could make of the way there, so contact falls on its step on every machine.
constexpr double kTouchingOverlap = 1e-9;

/// Both bodies where they touch, about the world's origin.
struct Touching {
  MeetingPlaces along_x;
  Quaternion turn_a;
  Quaternion turn_b;
  Vector3 aside;  ///< b's line from a's
};

Vector3 aside_of(const MeetingSettings& meeting, double m_per_deg) {
  const auto offset = meeting.offset_deg.value_or(std::array<double, 2>{});
  return m_per_deg * Vector3(0.0, offset[0], offset[1]);
}

/// The level at which they touch.
int meeting_level(const EngineSettings& engine) {
  return engine.level.value_or(engine.finest_level());
}

Touching touching_of(const Scene& scene, const SceneBodies& bodies, double m_per_deg) {
  Touching touching;
  touching.turn_a = (*scene.bodies)[0].orientation;
  touching.turn_b = (*scene.bodies)[1].orientation;
  touching.aside = aside_of(*scene.meeting, m_per_deg);
  touching.along_x = meeting_places(*bodies.models[0].tree, touching.turn_a, *bodies.models[1].tree,
                                    touching.turn_b, meeting_level(scene.engine), touching.aside);
  return touching;
}

/// Where the meeting point is in the world.
Vector3 place_of(const MeetingSettings& meeting, const Viewer& viewer, double m_per_deg) {
  return meeting.at_deg ? on_screen(viewer, screen_point_of(*meeting.at_deg, m_per_deg))
                        : Vector3(Vector3::Zero());
}

double mass_of(const BodySettings& body, const BodyShape& shape) {
  return body.density_kg_m3 * shape.unit_mass.mass_kg;
}

/// Starts a body `way_m` before the place where it touches, moving there along x.
BodyState on_its_way(double mass_kg, const Quaternion& orientation, double touch_m, double way_m,
                     double speed_m_s) {
  const double side = touch_m < 0.0 ? -1.0 : 1.0;
  BodyState state;
  state.pose = {Vector3(touch_m * (1.0 - kTouchingOverlap) + side * way_m, 0.0, 0.0), orientation};
  state.linear_momentum = Vector3(-side * speed_m_s * mass_kg, 0.0, 0.0);
  return state;
}

void set_shells(double gap_m, SceneBodies& bodies) {
  for (std::size_t body = 0; body < 2; ++body) {
    const double radius_m = bodies.shapes[body]->radius_m + 0.5 * gap_m;
    bodies.models[body].tree =
        std::make_shared<const VolumeTree>(single_node_tree(Sphere{Vector3::Zero(), radius_m}));
  }
}

/// The gap between the drawn spheres where their shells touch, as the viewer sees it.
double seen_gap_arcmin(const Scene& scene, const Viewer& viewer, const SceneBodies& bodies) {
  const double m_per_deg = metres_per_degree(viewer.screen.viewing_distance_m);
  const Touching touching = touching_of(scene, bodies, m_per_deg);
  const Vector3 middle = place_of(*scene.meeting, viewer, m_per_deg);
  const Vector3 a = middle + Vector3(touching.along_x.a_m, 0, 0) - 0.5 * touching.aside;
  const Vector3 b = middle + Vector3(touching.along_x.b_m, 0, 0) + 0.5 * touching.aside;
  const Vector3 a_to_b = (b - a).normalized();
  return kArcminPerDegree * visual_angle_deg(viewer, a + bodies.shapes[0]->radius_m * a_to_b,
                                             b - bodies.shapes[1]->radius_m * a_to_b);
}

/// Sets the shells by false position: the angle is nearly proportional to the gap. False when no
/// gap of a few bodies' length is seen under so large an angle.
bool find_shells(const Scene& scene, const Viewer& viewer, SceneBodies& bodies) {
  constexpr int kSteps = 12;
  const double wanted_arcmin = scene.meeting->gap_arcmin;
  const double most_m = 10.0 * (bodies.shapes[0]->radius_m + bodies.shapes[1]->radius_m);
  double gap_m =
      metres_per_degree(viewer.screen.viewing_distance_m) * wanted_arcmin / kArcminPerDegree;
  for (int step = 0; step < kSteps && gap_m < most_m; ++step) {
    set_shells(gap_m, bodies);
    gap_m *= wanted_arcmin / seen_gap_arcmin(scene, viewer, bodies);
  }
  if (!(gap_m < most_m)) {
    return false;
  }
  set_shells(gap_m, bodies);
  return true;
}

}  // namespace

void add_shells(const Scene& scene, const Viewer& viewer, SceneBodies& bodies) {
  if (scene.meeting->gap_arcmin > 0.0) {
    static_cast<void>(find_shells(scene, viewer, bodies));
  }
}

std::vector<BodyState> meeting_states(const Scene& scene, const Viewer& viewer,
                                      const SceneBodies& bodies) {
  const MeetingSettings& meeting = *scene.meeting;
  const std::vector<BodySettings>& named = *scene.bodies;
  const double m_per_deg = metres_per_degree(viewer.screen.viewing_distance_m);
  const Touching touching = touching_of(scene, bodies, m_per_deg);
  const double speed_m_s = meeting.speed_deg_s * meeting.speed_percent / 100.0 * m_per_deg;
  const double way_m = speed_m_s * meeting.lead_s;
  BodyState a = on_its_way(mass_of(named[0], *bodies.shapes[0]), touching.turn_a,
                           touching.along_x.a_m, way_m, speed_m_s);
  BodyState b =
      on_its_way(mass_of(named[1], *bodies.shapes[1]), touching.turn_b, touching.along_x.b_m,
                 meeting.second_rests ? 0.0 : way_m, meeting.second_rests ? 0.0 : speed_m_s);
  const Vector3 middle = place_of(meeting, viewer, m_per_deg);
  a.pose.position += middle - 0.5 * touching.aside;
  b.pose.position += middle + 0.5 * touching.aside;
  return {a, b};
}

void add_touching_problems(const Scene& scene, ShapeLibrary& library, SceneProblems& problems) {
  const std::vector<BodySettings>& named = *scene.bodies;
  const MeetingSettings& meeting = *scene.meeting;
  const bool has_gap = meeting.gap_arcmin > 0.0;
  const std::string gap = "/meeting/gap_arcmin";
  if (has_gap &&
      !(named[0].shape.kind == ShapeKind::kSphere && named[1].shape.kind == ShapeKind::kSphere)) {
    problems.add_got(gap, "expected none where a body is no sphere");
    return;
  }
  if (!has_gap && !meeting.offset_deg) {
    return;
  }
  const ScreenGeometry screen = screen_for_checks();
  const Viewer viewer = scene.viewer_on(screen);
  const double m_per_deg = metres_per_degree(screen.viewing_distance_m);
  SceneBodies bodies = bodies_of(scene, m_per_deg, library);
  if (!can_meet(*bodies.models[0].tree, named[0].orientation, *bodies.models[1].tree,
                named[1].orientation, meeting_level(scene.engine), aside_of(meeting, m_per_deg))) {
    problems.add_got("/meeting/offset_deg", "expected bodies that touch, but they pass by");
    return;
  }
  if (has_gap && !find_shells(scene, viewer, bodies)) {
    problems.add_got(gap, "expected a gap that can be seen so large from azimuth " +
                              problems.written("/viewer/azimuth_deg"));
  }
}

}  // namespace impetus::inline scenes
