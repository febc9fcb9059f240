// One condition's scene, ready to step and to draw.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/scheduling/metrics.hpp"
#include "engine/scheduling/viewer.hpp"
#include "engine/shapes/triangle_mesh.hpp"
#include "engine/world/world.hpp"
#include "experiments/design/design.hpp"
#include "experiments/record/appearance.hpp"
#include "experiments/record/gaze.hpp"
#include "experiments/record/sound.hpp"

namespace impetus::inline record {

/// Which bodies flash while a stimulus is still, so that everybody knows which ones are meant: how
/// often, and until when. It is drawing: no step of the world looks at it.
///
///     own | other | own | other | own      half a period each, from onset on
struct Flashing {
  std::vector<std::size_t> bodies;
  double hz{1.0};       ///< times a second that the other colour is shown
  Colour colour{};      ///< that other colour
  double until_s{0.0};  ///< from onset

  /// Whether the other colour is shown.
  [[nodiscard]] bool is_lit_at(double time_s) const {
    constexpr double kOfAPeriod = 1e-9;  // a frame that falls on a change shows it
    const double periods = time_s * hz + kOfAPeriod;
    return time_s < until_s && periods - std::floor(periods) >= 0.5;
  }
};

/// Gives those of `shown`, a scene's bodies by their places, the colour that they have at the time.
template <typename ShownBodies>
void flash(const Flashing& flashing, double time_s, ShownBodies& shown) {
  if (flashing.is_lit_at(time_s)) {
    for (const std::size_t body : flashing.bodies) {
      shown[body].look.colour = flashing.colour;
    }
  }
}

/// A viewer who goes round the scene: the eye turns about the vertical at a constant rate, and
/// looks at the world's origin all the time (Dingliana 2002, eq. 5.1: camera motion). The eye's
/// velocity is ω × eye, ω being the rate about y.
struct ViewerTurn {
  double azimuth_deg{0.0};    ///< at time zero
  double rate_deg_s{0.0};     ///< anticlockwise from above; 0: the viewer stays
  double elevation_deg{0.0};  ///< at all times
};

/// The viewer `time_s` after `start`, which is as it was when nothing turns. The same bits on every
/// machine: a step's viewer follows from its number.
Viewer turned_viewer(const Viewer& start, const ViewerTurn& turn, double time_s);

// How finely a body of a crowd is drawn: by the coarsest mesh that nobody could tell from its own.
//
//   mesh ──reduced──> level ──reduced──> level ...      each with its deviation in metres
//                       │
//    deviation, as seen from the eye, of half a pixel at most? ── yes ──> try the next
//
// Only crowds are drawn more coarsely than they are simulated: a picture of few bodies shows their
// own meshes, triangle by triangle.

/// A picture of more bodies is a crowd's.
inline constexpr std::size_t kFewBodies = 20;

/// How far from its place the surface of one of a crowd may be drawn, on average, in pixels.
inline constexpr double kMostDeviation_px = 0.5;

/// A mesh that stands for a finer one.
struct DrawnLevel {
  std::shared_ptr<const TriangleMesh> mesh;
  /// Of either surface from the other: the root of the mean squared distance, the greater of both.
  double deviation_m{0.0};
};

/// From the finest to the coarsest, deviations rising.
using DrawnLevels = std::vector<DrawnLevel>;

[[nodiscard]] inline bool is_crowd(std::size_t bodies) { return bodies > kFewBodies; }

/// The mesh to draw of a body that has `mesh` and perhaps `coarser` ones, where a metre across the
/// line of sight takes `px_per_metre` pixels.
[[nodiscard]] const std::shared_ptr<const TriangleMesh>& mesh_as_seen(
    const std::shared_ptr<const TriangleMesh>& mesh, const DrawnLevels* coarser,
    double px_per_metre);

/// How a body looks: a mesh in the body's frame, or a sphere of this radius (metres) when there is
/// none.
struct DrawnBody {
  std::string name;
  double radius_m{0.0};  ///< of the sphere, or of a ball about the origin that holds the mesh
  Colour colour{0.8F, 0.8F, 0.8F};
  std::shared_ptr<const TriangleMesh> mesh{};
  /// Meshes to draw instead where the body is one of a crowd; none: always its own.
  std::shared_ptr<const DrawnLevels> coarser{};
  std::optional<SurfaceTexture> texture{};  ///< its own; none: the appearance's
  double from_s{0.0};                       ///< it is not seen before

  /// So long after onset: a sphere of nothing while it is not seen.
  [[nodiscard]] DrawnBody at(double time_s) const {
    return time_s < from_s ? DrawnBody{name, 0.0, colour} : *this;
  }
};

/// Of the world's bodies, in its order.
std::vector<std::string> body_names(const World& world);

/// Where collisions are of high priority, for schedules by region.
enum class RegionKind {
  kNone,      ///< the schedule is not by region
  kAllGood,   ///< everywhere
  kAllBad,    ///< nowhere
  kTracked,   ///< about the gaze
  kRandom,    ///< about places drawn within the enclosure's image
  kFixed,     ///< about a point of the screen
  kRecorded,  ///< about another participant's recorded gaze
};

/// Which region a schedule has, with what each kind of it needs.
struct RegionRule {
  RegionKind kind{RegionKind::kNone};
  double radius_deg{0.0};
  std::int64_t renewal_steps{0};  ///< of kRandom: how long a place lasts
  ScreenPoint point{};            ///< of kFixed

  friend bool operator==(const RegionRule&, const RegionRule&) = default;
};

/// A line that a body may cross, across the world's axis 0 (x) or 1 (y), which ends the stimulus
/// before its time.
struct Goal {
  std::size_t body{0};
  int axis{0};
  double sense{1.0};  ///< 1: it is through beyond the line along the axis; −1: before it
  double line_m{0.0};
  std::vector<std::size_t> missed_at;  ///< bodies by which it is sent back, and has missed
  double follow_s{0.0};                ///< the stimulus goes on for so long

  [[nodiscard]] bool is_passed_at(const Vector3& centre) const {
    return sense * (centre[axis] - line_m) > 0.0;
  }
  /// Two bodies touched; the goal's moves on as `momentum` says.
  [[nodiscard]] bool is_missed_by(const BodyPair& touching, const Vector3& momentum) const {
    const auto mine = static_cast<std::int32_t>(body);
    const std::int32_t other = touching.a == mine ? touching.b : touching.a;
    return (touching.a == mine || touching.b == mine) && sense * momentum[axis] < 0.0 &&
           std::find(missed_at.begin(), missed_at.end(), static_cast<std::size_t>(other)) !=
               missed_at.end();
  }
};

/// A body that moves on as nothing in the world makes it: not physics.
struct ImposedMotion {
  std::size_t body{0};
  std::int64_t after_step{0};  ///< 0: from onset on
  Vector3 velocity_m_s{Vector3::Zero()};
};

/// One body that stops at another, which then moves off: what is imposed, as it is seen.
struct Launch {
  std::size_t first{0};
  std::size_t second{0};
  Vector3 along{Vector3::UnitX()};  ///< the way of both
  double speed_deg_s{0.0};          ///< of the first
  Pose stops;                       ///< the first, then; the second is where it starts
  double gap_deg{0.0};           ///< between their outlines then, along the way; below 0: over it
  double second_width_deg{0.0};  ///< of the second's outline along the way
  double hold_s{0.0};            ///< until the second moves off
};

/// How much a step may do; at most one of the two limits.
struct WorkBudget {
  std::int64_t tests_per_step{kUnlimitedTests};  ///< units of work: see WorldSettings::costs
  std::int64_t ns_per_step{0};                   ///< by the clock; 0: none
};

/// The world at its start, and all that decides how it goes on and how it looks.
struct StagedScene {
  World world;
  Viewer viewer;
  std::vector<DrawnBody> looks;  ///< one per body of the world
  double step_hz{240.0};
  double duration_s{0.0};      ///< from onset to the end of the stimulus, an imposed hold included
  double still_s{0.0};         ///< from onset: the world stands still for so long
  double unseen_s{0.0};        ///< after duration_s: what would happen then is hidden
  Flashing flashing{};         ///< while it is still
  std::optional<Goal> goal{};  ///< which may end it sooner
  std::optional<Launch> launch{};
  std::vector<ImposedMotion> imposed_motions{};
  std::vector<BodyState> start{};  ///< of the bodies at onset, whatever becomes of the world
  double contact_s{0.0};           ///< when two bodies are to meet, from onset; 0: nothing is to
  double intended_hold_s{0.0};     ///< the freeze at contact that the condition asks for
  bool no_spin{false};             ///< imposed: nothing turns
  double realised_hold_s{0.0};     ///< differs only when rounding to whole frames was allowed
  RegionRule region{};
  WorkBudget budget{};
  bool depends_on_gaze{false};  ///< the gaze decides the detail of collisions
  /// As they were asked for, for controls that show them; "": not known by name.
  std::string scheduler{};
  MetricOptions metric_options{};
  std::string reduction{};
  ViewerTurn turn{};           ///< `viewer` is where it starts
  double gaze_latency_s{0.0};  ///< imposed, all in all: samples younger than this are not used yet
  std::shared_ptr<const GazePath> recorded_gaze{};  ///< of a region of kind kRecorded
  /// How bodies and what is about them are painted; none: as a scene that says nothing of it.
  std::shared_ptr<const Appearance> appearance{};
  std::optional<SoundTask> sound{};  ///< none: nothing is to be heard
  Condition condition{};  ///< that it was staged for; a simulated participant may go by it

  /// From onset to the scene's end, what is hidden of it included.
  [[nodiscard]] double whole_s() const { return duration_s + unseen_s; }

  [[nodiscard]] Viewer viewer_at_time(double time_s) const {
    return turned_viewer(viewer, turn, time_s);
  }
};

}  // namespace impetus::inline record
