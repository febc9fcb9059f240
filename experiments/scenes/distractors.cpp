// SPDX-License-Identifier: MIT
#include "experiments/scenes/distractors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/numerics/random_stream.hpp"
#include "experiments/scenes/random_places.hpp"
#include "experiments/scenes/scene_enclosure.hpp"
#include "experiments/scenes/scene_meeting.hpp"

namespace impetus::inline scenes {
namespace {

constexpr std::size_t kMeeting = 2;

std::size_t count_of(const Scene& scene) {
  return scene.distractors ? scene.distractors->count : 0;
}

/// A body that moves at one velocity for some time.
struct Leg {
  double start_s{0.0};
  double end_s{0.0};
  Vector3 place{Vector3::Zero()};  ///< at start_s
  Vector3 velocity{Vector3::Zero()};
};

/// Where a body is during the stimulus, leg by leg, and how large it is.
struct Path {
  double radius_m{0.0};
  std::vector<Leg> legs;
};

Vector3 place_at(const Leg& leg, double time_s) {
  return leg.place + (time_s - leg.start_s) * leg.velocity;
}

/// The least distance of two legs' bodies while both last; infinite when they never both do.
double least_distance_m(const Leg& a, const Leg& b) {
  const double start_s = std::max(a.start_s, b.start_s);
  const double end_s = std::min(a.end_s, b.end_s);
  if (start_s > end_s) {
    return std::numeric_limits<double>::infinity();
  }
  const Vector3 apart = place_at(b, start_s) - place_at(a, start_s);
  const Vector3 relative = b.velocity - a.velocity;
  const double square = relative.squaredNorm();
  const double nearest_s =
      square > 0.0 ? std::clamp(-apart.dot(relative) / square, 0.0, end_s - start_s) : 0.0;
  return (apart + nearest_s * relative).norm();
}

bool keep_apart(const Path& a, const Path& b, double apart_m) {
  return std::all_of(a.legs.begin(), a.legs.end(), [&](const Leg& leg_a) {
    return std::all_of(b.legs.begin(), b.legs.end(), [&](const Leg& leg_b) {
      return least_distance_m(leg_a, leg_b) >= a.radius_m + b.radius_m + apart_m;
    });
  });
}

/// One of the two: there, held, and straight back.
Path there_and_back(const MeetingSettings& meeting, const BodyState& start, const Vector3& velocity,
                    double radius_m, double hold_s) {
  const double lead_s = meeting.lead_s;
  const double release_s = lead_s + hold_s;
  const Vector3 turn = start.pose.position + lead_s * velocity;
  return {radius_m,
          {{0.0, lead_s, start.pose.position, velocity},
           {lead_s, release_s, turn, Vector3::Zero()},
           {release_s, release_s + meeting.follow_s, turn, -velocity}}};
}

/// What a distractor may do.
struct DistractorBounds {
  double half_width_m{0.0};
  double half_height_m{0.0};
  double apart_m{0.0};
  double speed_m_s{0.0};
  double duration_s{0.0};
};

/// A straight way within the bounds, or none when the draw left it.
std::optional<Leg> drawn_leg(const DistractorBounds& bounds, const Viewer& viewer,
                             RandomStream& stream) {
  const double x = bounds.half_width_m * draw_symmetric(stream);
  const double y = bounds.half_height_m * draw_symmetric(stream);
  const double right = draw_symmetric(stream);
  const double up = draw_symmetric(stream);
  const double square = right * right + up * up;
  if (square > 1.0 || square < 1e-4) {
    return std::nullopt;  // a direction uniform over the circle, by rejection
  }
  const double speed_m_s = bounds.speed_m_s / std::sqrt(square);
  const double end_x = x + bounds.duration_s * speed_m_s * right;
  const double end_y = y + bounds.duration_s * speed_m_s * up;
  if (std::abs(end_x) > bounds.half_width_m || std::abs(end_y) > bounds.half_height_m) {
    return std::nullopt;
  }
  return Leg{0.0, bounds.duration_s, on_screen(viewer, {x, y}),
             speed_m_s * (right * viewer.right + up * viewer.up)};
}

/// Draws paths one after the other, each apart from all before it.
bool draw_paths(const DistractorBounds& bounds, const Viewer& viewer,
                const std::vector<double>& radii_m, std::vector<Path>& paths,
                RandomStream& stream) {
  constexpr int kMostDraws = 10'000;
  for (const double radius_m : radii_m) {
    bool found = false;
    for (int draw = 0; draw < kMostDraws && !found; ++draw) {
      const auto leg = drawn_leg(bounds, viewer, stream);
      if (!leg) {
        continue;
      }
      const Path path{radius_m, {*leg}};
      found = std::all_of(paths.begin(), paths.end(), [&](const Path& other) {
        return keep_apart(path, other, bounds.apart_m);
      });
      if (found) {
        paths.push_back(path);
      }
    }
    if (!found) {
      return false;
    }
  }
  return true;
}

std::vector<BodyState> states_of(const std::vector<Path>& paths, const SceneBodies& bodies) {
  std::vector<BodyState> states;
  for (std::size_t i = kMeeting; i < paths.size(); ++i) {
    BodyState state;
    state.pose = {paths[i].legs.front().place, Quaternion::Identity()};
    state.linear_momentum = paths[i].legs.front().velocity / bodies.models[i].inverse_mass;
    states.push_back(state);
  }
  return states;
}

DistractorBounds distractor_bounds(const Scene& scene, double m_per_deg, double speed_m_s,
                                   double hold_s) {
  const DistractorSettings& distractors = *scene.distractors;
  return {m_per_deg * distractors.within_deg[0], m_per_deg * distractors.within_deg[1],
          m_per_deg * distractors.apart_deg, speed_m_s, scene.moving_s(hold_s)};
}

/// Whether the two turn straight back, so that their paths are known before they meet.
bool turn_straight_back(const Scene& scene) {
  const BodySettings& a = (*scene.bodies)[0];
  const BodySettings& b = (*scene.bodies)[1];
  const EngineSettings& engine = scene.engine;
  return a.shape.kind == ShapeKind::kSphere && a.shape == b.shape &&
         a.density_kg_m3 == b.density_kg_m3 && !scene.meeting->offset_deg &&
         !scene.meeting->second_rests && engine.world.restitution == 1.0 && !engine.materials &&
         !engine.gravity_m_s2;
}

}  // namespace

void add_distractors(const Scene& scene, SceneBodies& bodies) {
  for (std::size_t i = 0; i < count_of(scene); ++i) {
    const std::string name = "distractor " + std::to_string(i + 1);
    bodies.models.push_back(bodies.models[i % kMeeting]);
    bodies.models.back().name = name;
    bodies.looks.push_back(bodies.looks[i % kMeeting]);
    bodies.looks.back().name = name;
    bodies.shapes.push_back(bodies.shapes[i % kMeeting]);
  }
}

std::optional<std::vector<BodyState>> distractor_states(const Scene& scene,
                                                        const SceneBodies& bodies,
                                                        const std::vector<BodyState>& meeting,
                                                        const Viewer& viewer, double hold_s,
                                                        std::uint64_t seed) {
  if (count_of(scene) == 0) {
    return std::vector<BodyState>{};
  }
  std::vector<Path> pair;
  std::vector<double> radii_m;
  for (std::size_t body = 0; body < bodies.models.size(); ++body) {
    const double radius_m = bodies.models[body].tree->bounding_radius_m();
    if (body >= kMeeting) {
      radii_m.push_back(radius_m);
      continue;
    }
    pair.push_back(there_and_back(*scene.meeting, meeting[body],
                                  velocity(bodies.models[body], meeting[body]), radius_m, hold_s));
  }
  const double m_per_deg = metres_per_degree(viewer.screen.viewing_distance_m);
  const DistractorBounds bounds =
      distractor_bounds(scene, m_per_deg, velocity(bodies.models[0], meeting[0]).norm(), hold_s);
  RandomStream stream(seed, "distractors");
  constexpr int kMostTries = 100;
  for (int attempt = 0; attempt < kMostTries; ++attempt) {
    std::vector<Path> paths = pair;
    if (draw_paths(bounds, viewer, radii_m, paths, stream)) {
      return states_of(paths, bodies);
    }
  }
  return std::nullopt;
}

void add_distractor_problems(const Scene& scene, ShapeLibrary& library, SceneProblems& problems) {
  if (count_of(scene) == 0) {
    return;
  }
  const std::string place = "/distractors/count";
  if (!turn_straight_back(scene)) {
    problems.add_got(place,
                     "expected 0 unless two equal spheres meet head-on, without loss, and turn "
                     "straight back");
    return;
  }
  const ScreenGeometry screen = screen_for_checks();
  const Viewer viewer = scene.viewer_on(screen);
  SceneBodies bodies = bodies_of(scene, metres_per_degree(screen.viewing_distance_m), library);
  add_distractors(scene, bodies);
  add_shells(scene, viewer, bodies);
  const auto meeting = meeting_states(scene, viewer, bodies);
  constexpr std::uint64_t kTries = 5;
  for (std::uint64_t seed = 1; seed <= kTries; ++seed) {
    if (!distractor_states(scene, bodies, meeting, viewer, scene.intended_hold_s(), seed)) {
      problems.add_got(place, "expected as many as there is room for beside the two");
      return;
    }
  }
}

}  // namespace impetus::inline scenes
