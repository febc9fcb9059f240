// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_commands.hpp"

namespace impetus::inline viewers {
namespace {

/// N and P, by what is held with them.
ReplayCommand jump(bool next, Uint16 modifiers) {
  using Command = ReplayCommand;
  if ((modifiers & KMOD_CTRL) != 0) {
    return next ? Command::kNextClick : Command::kPreviousClick;
  }
  if ((modifiers & KMOD_SHIFT) != 0) {
    return next ? Command::kNextLateFrame : Command::kPreviousLateFrame;
  }
  if ((modifiers & KMOD_ALT) != 0) {
    return next ? Command::kNextAnswer : Command::kPreviousAnswer;
  }
  return next ? Command::kNextCollision : Command::kPreviousCollision;
}

}  // namespace

const std::vector<ReplayKey>& replay_keys() {
  static const std::vector<ReplayKey> keys{
      {"Space", "play, pause"},
      {"←  →   or   ,  .", "one step back, on"},
      {"↑  ↓", "faster, slower"},
      {"Home, End", "to the onset, to the end"},
      {"N, P", "next, previous collision"},
      {"Ctrl + N, P", "next, previous click"},
      {"Shift + N, P", "next, previous late frame"},
      {"Alt + N, P", "next, previous answer"},
      {"Drag the timeline", "to any time"},
      {"", ""},
      {"G", "gaze: where each step was told it is, and its last 300 ms"},
      {"C", "contacts with their normals, fading for ¼ s"},
      {"V", "volumes at the level that was used, for ¼ s after a collision"},
      {"L", "colours: own, by priority, by level"},
      {"F", "beside it: the same at the finest level"},
      {"Drag the picture, wheel", "look from elsewhere, closer"},
      {"R", "return to the participant's view"},
      {"", ""},
      {"S", "save the picture as PNG"},
      {"T, or a number", "list of trials, to go to one"},
      {"Page Up, Page Down", "previous, next trial"},
      {"F1, H or ?", "this help"},
      {"Esc", "close"}};
  return keys;
}

std::optional<ReplayCommand> command_of(const SDL_Keysym& key) {
  using Command = ReplayCommand;
  switch (key.sym) {
    case SDLK_SPACE:
      return Command::kPlay;
    case SDLK_LEFT:
    case SDLK_COMMA:
      return Command::kStepBack;
    case SDLK_RIGHT:
    case SDLK_PERIOD:
      return Command::kStepOn;
    case SDLK_UP:
      return Command::kFaster;
    case SDLK_DOWN:
      return Command::kSlower;
    case SDLK_HOME:
      return Command::kStart;
    case SDLK_END:
      return Command::kEnd;
    case SDLK_n:
    case SDLK_p:
      return jump(key.sym == SDLK_n, key.mod);
    case SDLK_g:
      return Command::kGaze;
    case SDLK_c:
      return Command::kContacts;
    case SDLK_v:
      return Command::kVolumes;
    case SDLK_l:
      return Command::kColours;
    case SDLK_f:
      return Command::kFinest;
    case SDLK_r:
      return Command::kOwnView;
    case SDLK_s:
      return Command::kPicture;
    case SDLK_t:
      return Command::kTrials;
    case SDLK_PAGEUP:
      return Command::kPreviousTrial;
    case SDLK_PAGEDOWN:
      return Command::kNextTrial;
    case SDLK_F1:
    case SDLK_h:
    case SDLK_QUESTION:
      return Command::kHelp;
    case SDLK_SLASH:
      return (key.mod & KMOD_SHIFT) != 0 ? std::optional(Command::kHelp) : std::nullopt;
    case SDLK_ESCAPE:
      return Command::kClose;
    default:
      return std::nullopt;
  }
}

}  // namespace impetus::inline viewers
