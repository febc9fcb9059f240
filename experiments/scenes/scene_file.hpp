// From a scene's settings to the world that is on show.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "experiments/record/staged_scene.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/scene_checks.hpp"
#include "experiments/scenes/shape_library.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline scenes {

/// Values that must be whole numbers of the display's frames, by JSON Pointer, and the seconds in
/// their unit. An imposed hold may be rounded to the grid where that is allowed; a lead may not.
/// A scene need not have them all.
struct FrameBoundValue {
  std::string pointer;
  double unit_s;
  bool may_round;
};
const std::vector<FrameBoundValue>& frame_bound_values();

/// Of build_scene(): a hold keeps its length, whatever the display.
inline constexpr double kUnroundedHold = 0.0;

/// The bodies find no places in which to start, on the screen and in the start that are asked for:
/// checks try another screen and ten starts.
class NoRoom : public InputError {
 public:
  NoRoom(std::string pointer, const std::string& message)
      : InputError(message), pointer_(std::move(pointer)) {}

  /// Where the scene says how many there are.
  [[nodiscard]] const std::string& pointer() const { return pointer_; }

 private:
  std::string pointer_;
};

/// Builds the scene for a screen, with shapes from `library`. `round_hold_to_hz` > 0 rounds an
/// imposed hold to whole frames of that rate. `start` names a crowd's random start: the same name,
/// the same start. `seed` is the trial's: random spin and distractors are drawn with it. No tree is
/// built beyond `deepest_level`, for whoever knows that nothing will reach it.
/// Precondition: scene_problems() is empty. Throws NoRoom.
StagedScene build_scene(const Scene& scene, const ScreenGeometry& screen, double round_hold_to_hz,
                        ShapeLibrary& library, const std::string& start = "preview",
                        std::uint64_t seed = 1, int deepest_level = kGreatestTreeDepth);

/// What keeps a crowd, of figures too, from starting.
enum class CrowdProblem {
  kNone,
  kNoRoom,     ///< there is no place left for one of them
  kNoPosture,  ///< a figure's own parts overlap, however its joints are turned
};

/// What keeps the scene's crowd from starting in one of ten starts. Precondition: it has a crowd
/// and an enclosure.
CrowdProblem problem_of_crowd(const Scene& scene, ShapeLibrary& library);

/// What a scene's start has that it should not have.
struct StartingOverlaps {
  std::vector<BodyPair> pairs;       ///< of bodies, and bodies and walls, that overlap
  std::vector<std::int32_t> folded;  ///< parts folded onto the neighbours from which they hang
  std::vector<std::string> names;    ///< of all bodies
  std::vector<Figure> figures;
};

/// The pairs of named bodies and figures' parts, and of these and walls, that overlap at the start,
/// at the coarsest level at which the schedule may leave them; not those that a figure's own rules
/// leave out. Precondition: as for build_scene().
StartingOverlaps starting_overlaps_of(const Scene& scene, ShapeLibrary& library);

}  // namespace impetus::inline scenes
