// Everything that can be asked of the viewer of replays: its keys, its help, and what each command
// does to where a replay stands and to what is shown of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <SDL.h>

#include <optional>
#include <string>

#include "experiments/drawing/body_colours.hpp"
#include "experiments/viewing/orbit_camera.hpp"
#include "experiments/viewing/replay_playback.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

/// What a key or a button asks for, each as it is called.
enum class ReplayCommand {
  kPlay,
  kStepBack,
  kStepOn,
  kStart,
  kEnd,
  kSlower,
  kFaster,
  kPreviousCollision,
  kNextCollision,
  kPreviousClick,
  kNextClick,
  kPreviousLateFrame,
  kNextLateFrame,
  kPreviousAnswer,
  kNextAnswer,
  kGaze,
  kContacts,
  kVolumes,
  kColours,
  kFinest,
  kOwnView,
  kPicture,
  kTrials,
  kPreviousTrial,
  kNextTrial,
  kHelp,
  kClose
};

/// What a key asks for, if anything.
std::optional<ReplayCommand> command_of(const SDL_Keysym& key);

/// Draws all keys, over everything else, into the current ImGui window.
void draw_replay_help(const Gui& gui);

/// Plays, steps, jumps and changes speed. None: the command is about something else; otherwise what
/// is to be said, such as that there is no later collision, or "".
std::optional<std::string> steer(ReplayPlayback& playback, const ReplayView& replay,
                                 ReplayCommand command);

/// What the viewer of replays shows, as its keys have it: kept from one trial to the next.
struct ReplayLook {
  bool gaze{true};
  bool contacts{false};
  bool volumes{false};
  bool finest{false};  ///< beside it
  BodyColours colours{BodyColours::kOwn};
  OrbitCamera camera;
};

/// Does what a command asks of it; false: it is about something else.
bool change_look(ReplayLook& look, ReplayCommand command);

}  // namespace impetus::inline viewers
