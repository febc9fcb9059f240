// Everything that can be asked of the viewer of replays: its keys, its buttons, its help.
// SPDX-License-Identifier: MIT
#pragma once

#include <SDL.h>

#include <optional>
#include <vector>

namespace impetus::inline viewers {

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

/// A line of the help.
struct ReplayKey {
  const char* keys;
  const char* meaning;
};
const std::vector<ReplayKey>& replay_keys();

/// What a key asks for, if anything.
std::optional<ReplayCommand> command_of(const SDL_Keysym& key);

}  // namespace impetus::inline viewers
