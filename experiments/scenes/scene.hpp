// What a scene file says, as structs: read once from JSON that is valid, then passed on.
//
//   scene.json ─schema─> JSON, with a trial's levels put in ──> Scene ──> scene_problems(),
//   build_scene()
//
//   meeting   two bodies that approach along x and touch at the centre
//   launch    in a plane, one body that stops at another, which moves off
//   crowd     bodies alike, or figures alike, at random places within walls
//   neither   bodies and figures with places and velocities of their own, within walls or without
//
// Each member is a row of scene.cpp (see settings/setting_rows.hpp). What a file may leave out, and
// what is asked whether it was said, is optional. Lengths are degrees at the screen's centre.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/figures/figure.hpp"
#include "engine/scheduling/viewer.hpp"
#include "experiments/scenes/appearance_settings.hpp"
#include "experiments/scenes/engine_settings.hpp"
#include "experiments/scenes/figures/figure_settings.hpp"
#include "experiments/scenes/shape_settings.hpp"
#include "experiments/scenes/showing/showing_settings.hpp"
#include "experiments/scenes/showing/sound_settings.hpp"

namespace impetus::inline scenes {

/// A plane that faces the viewer, in pixels of its own: to the right and up.
struct PlaneSettings {
  double px_per_deg{1.0};
  std::array<double, 2> origin_px{};  ///< what is at the screen's centre

  /// In degrees from the centre.
  [[nodiscard]] Vector3 place_deg(const std::array<double, 2>& px) const {
    return Vector3(px[0] - origin_px[0], px[1] - origin_px[1], 0.0) / px_per_deg;
  }
};

/// A line that a body may cross, which ends the stimulus before its time, as what else is named.
struct GoalSettings {
  /// Where the goal is, seen from the line.
  enum class Side { kLeft, kRight, kBelow, kAbove };
  std::string body;
  Side side{Side::kLeft};
  double line_px{0.0};
  std::vector<std::string> missed_at;
  double follow_s{0.0};
};

/// One body stops at another, which moves off: imposed, not physics.
struct LaunchSettings {
  std::string first;
  std::string second;
  double speed_px_s{0.0};
  double direction_deg{0.0};
  double gap_px{0.0};
  std::optional<double> second_speed_px_s;
  std::optional<double> appears_px;
  double lead_s{0.0};
  double follow_s{0.0};
};

/// Where the viewer looks from.
struct ViewerSettings {
  double azimuth_deg{0.0};
  double elevation_deg{0.0};
  double turn_deg_s{0.0};
};

/// A body that is named.
struct BodySettings {
  std::string name;
  ShapeSettings shape;
  Quaternion orientation{Quaternion::Identity()};
  std::optional<Vector3> position_deg;
  std::optional<Vector3> velocity_deg_s;
  std::optional<Vector3> spin_deg_s;
  /// In the plane, in place of position and velocity in degrees, which follow from them.
  std::optional<std::array<double, 2>> position_px;
  std::optional<std::array<double, 2>> velocity_px_s;
  double density_kg_m3{1000.0};
  std::optional<bool> fixed;
  bool passes_through{false};
  std::string material;  ///< "": none
  Colour colour{};
  std::optional<SurfaceTexture> texture;
};

/// What crowds of bodies and of figures have alike.
struct CrowdSettings {
  std::size_t count{1};
  double density_kg_m3{1000.0};
  std::string material;
  std::vector<Colour> colours;
  double speed_deg_s{0.0};
  double spin_deg_s{0.0};
  std::uint64_t start{1};
};

/// A crowd of bodies alike.
struct BodyCrowd : CrowdSettings {
  ShapeSettings shape;
};

/// Which figure it is, and how it is made.
struct FigureMaking {
  std::string figure;  ///< its file
  double height_deg{1.0};
  std::optional<bool> sphere_first;  ///< "coarsest" of its swept parts
  SelfCollision self_collision{};
};

/// A crowd of figures alike.
struct FigureCrowd : CrowdSettings {
  FigureMaking making;
};

/// A figure that is named.
struct NamedFigure {
  std::string name;
  FigureMaking making;
  double density_kg_m3{1000.0};
  std::string material;
  std::vector<Colour> colours;
  Vector3 position_deg{Vector3::Zero()};
  Quaternion orientation{Quaternion::Identity()};
  std::optional<Vector3> velocity_deg_s;
  std::optional<Vector3> spin_deg_s;
  AnglesByJoint angles_deg;
  std::optional<std::string> motion;
  std::optional<Vector3> path_deg_s;
};

/// What keeps the bodies of a scene together.
enum class EnclosureKind {
  kClosedCube,   ///< about the origin
  kViewFrustum,  ///< what the viewer sees through the screen
};

/// The walls about a scene.
struct EnclosureSettings {
  EnclosureKind kind{EnclosureKind::kClosedCube};
  std::string material;
  std::optional<double> front_deg;
  std::optional<double> back_deg;
  std::optional<double> edge_deg;
  std::optional<double> edge_at_count;
};

/// How two bodies meet: how fast, where, and how long before and after is shown.
struct MeetingSettings {
  double speed_deg_s{0.0};
  double speed_percent{100.0};
  std::optional<std::array<double, 2>> offset_deg;
  std::optional<ScreenPlace> at_deg;
  double gap_arcmin{0.0};
  bool second_rests{false};
  double lead_s{0.0};
  double follow_s{0.0};
};

/// Further bodies beside the two that meet.
struct DistractorSettings {
  std::size_t count{0};
  double apart_deg{0.0};
  std::array<double, 2> within_deg{};
};

/// Between which a spin is drawn, component by component.
struct SpinLimits {
  Vector3 least_rad_s{Vector3::Zero()};
  Vector3 most_rad_s{Vector3::Zero()};
};

/// An imposed change of spin at contact, drawn within limits for each body.
struct RandomSpin {
  bool on{false};
  int at_level{0};
  SpinLimits a;
  SpinLimits b;
};

/// An imposed change of how two bodies part after they met.
struct ReboundSettings {
  /// Of what: the angle between their ways, or both speeds.
  enum class Change { kWider, kNarrower, kFaster, kSlower };

  Change change{Change::kWider};
  double amount{0.0};  ///< degrees of wider and narrower, percent of faster and slower
};

/// Manipulations that are not physics.
struct ImposedSettings {
  std::optional<double> contact_hold_ms;
  std::optional<RandomSpin> random_spin;
  std::optional<ReboundSettings> rebound;
  double gaze_latency_ms{0.0};
  std::optional<bool> no_spin;
};

/// All that a scene's file says.
struct Scene {
  Scene() = default;
  /// Precondition: valid by the schemas of scenes and of figures.
  Scene(const nlohmann::json& valid);  // NOLINT(google-explicit-constructor)

  EngineSettings engine;
  Meshes meshes;
  ViewerSettings viewer;
  std::optional<PlaneSettings> plane;
  AppearanceSettings appearance;
  std::optional<std::vector<BodySettings>> bodies;
  std::optional<BodyCrowd> crowd;
  std::optional<std::vector<NamedFigure>> figures;
  std::optional<FigureCrowd> figure_crowd;
  std::map<std::string, FigureSettings> figure_files;
  std::optional<EnclosureSettings> enclosure;
  std::optional<double> duration_s;
  ShowingSettings showing;
  std::optional<GoalSettings> goal;
  std::optional<MeetingSettings> meeting;
  std::optional<LaunchSettings> launch;
  std::optional<DistractorSettings> distractors;
  std::optional<ImposedSettings> imposed;
  std::optional<SoundTask> sound;
  std::map<std::string, SoundContent> sound_files;

  [[nodiscard]] bool has_crowd() const { return crowd || figure_crowd; }
  [[nodiscard]] bool has_figures() const { return figures || figure_crowd; }
  /// The crowd, of bodies or of figures. Precondition: has_crowd().
  [[nodiscard]] const CrowdSettings& any_crowd() const {
    return crowd ? static_cast<const CrowdSettings&>(*crowd) : *figure_crowd;
  }
  /// Who looks at it on this screen, at the onset.
  [[nodiscard]] Viewer viewer_on(const ScreenGeometry& screen) const {
    return viewer_at(screen, viewer.azimuth_deg, viewer.elevation_deg);
  }
  /// None where there are none.
  [[nodiscard]] std::span<const BodySettings> named_bodies() const {
    return bodies ? std::span(*bodies) : std::span<const BodySettings>();
  }
  [[nodiscard]] std::span<const NamedFigure> named_figures() const {
    return figures ? std::span(*figures) : std::span<const NamedFigure>();
  }
  [[nodiscard]] bool no_spin() const { return imposed && imposed->no_spin.value_or(false); }
  /// For how long two bodies are held at contact, seconds.
  [[nodiscard]] double intended_hold_s() const {
    return imposed ? imposed->contact_hold_ms.value_or(0.0) / 1e3 : 0.0;
  }
  /// From the first step of the world until two bodies are to meet, seconds; 0: nothing is to.
  [[nodiscard]] double meeting_s() const {
    return meeting ? meeting->lead_s : launch ? launch->lead_s : 0.0;
  }
  /// From the first step of the world to the scene's end, seconds, with a hold of `hold_s`.
  [[nodiscard]] double moving_s(double hold_s) const {
    return meeting  ? meeting->lead_s + hold_s + meeting->follow_s
           : launch ? launch->lead_s + hold_s + launch->follow_s
                    : *duration_s;
  }
  /// From onset to the end of the stimulus: still, then as much of the moving as is not hidden.
  [[nodiscard]] double lasting_s(double hold_s) const {
    return showing.still_s + showing.hidden_after_s.value_or(moving_s(hold_s));
  }
};

/// The scene's JSON Schema: stimuli/scene.schema.json, as an output of the rows.
OrderedJson scene_file_schema();
/// The same, for validation.
const nlohmann::json& scene_schema();

/// All settings that `replay --with` may change, by their pointers into a scene, in the rows'
/// order.
const std::vector<WithKey>& scene_with_keys();

/// A place of the scene that names a figure file.
struct FigureFile {
  std::string pointer;  ///< to "figure"
  std::string file;
};

/// Those that the scene names, in its order.
std::vector<FigureFile> named_figure_files(const Scene& scene);

/// A turn about one of the world's axes: 0 is x, 1 y, 2 z.
Quaternion turn_about(int axis, double angle_deg);

/// The word for an enclosure's kind.
const std::string& name_of(EnclosureKind kind);

}  // namespace impetus::inline scenes
