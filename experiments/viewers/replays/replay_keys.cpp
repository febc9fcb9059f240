// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_keys.hpp"

#include <algorithm>
#include <array>

#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline viewers {
namespace {

using Command = ReplayCommand;

/// A key, what has to be held with it, and what that asks for.
struct KeyOfCommand {
  SDL_Keycode key;
  int held;
  Command command;
};
/// The first that fits counts.
constexpr std::array<KeyOfCommand, 32> kCommandKeys{
    {{SDLK_SPACE, 0, Command::kPlay},
     {SDLK_LEFT, 0, Command::kStepBack},
     {SDLK_COMMA, 0, Command::kStepBack},
     {SDLK_RIGHT, 0, Command::kStepOn},
     {SDLK_PERIOD, 0, Command::kStepOn},
     {SDLK_UP, 0, Command::kFaster},
     {SDLK_DOWN, 0, Command::kSlower},
     {SDLK_HOME, 0, Command::kStart},
     {SDLK_END, 0, Command::kEnd},
     {SDLK_n, KMOD_CTRL, Command::kNextClick},
     {SDLK_n, KMOD_SHIFT, Command::kNextLateFrame},
     {SDLK_n, KMOD_ALT, Command::kNextAnswer},
     {SDLK_n, 0, Command::kNextCollision},
     {SDLK_p, KMOD_CTRL, Command::kPreviousClick},
     {SDLK_p, KMOD_SHIFT, Command::kPreviousLateFrame},
     {SDLK_p, KMOD_ALT, Command::kPreviousAnswer},
     {SDLK_p, 0, Command::kPreviousCollision},
     {SDLK_g, 0, Command::kGaze},
     {SDLK_c, 0, Command::kContacts},
     {SDLK_v, 0, Command::kVolumes},
     {SDLK_l, 0, Command::kColours},
     {SDLK_f, 0, Command::kFinest},
     {SDLK_r, 0, Command::kOwnView},
     {SDLK_s, 0, Command::kPicture},
     {SDLK_t, 0, Command::kTrials},
     {SDLK_PAGEUP, 0, Command::kPreviousTrial},
     {SDLK_PAGEDOWN, 0, Command::kNextTrial},
     {SDLK_F1, 0, Command::kHelp},
     {SDLK_h, 0, Command::kHelp},
     {SDLK_QUESTION, 0, Command::kHelp},
     {SDLK_SLASH, KMOD_SHIFT, Command::kHelp},
     {SDLK_ESCAPE, 0, Command::kClose}}};

/// A line of the help.
struct HelpLine {
  const char* keys;
  const char* meaning;
};
constexpr std::array<HelpLine, 23> kHelp{
    {{"Space", "play, pause"},
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
     {"Esc", "close"}}};

/// Where a command jumps to: the next (1) or the last (−1) of these.
struct Jump {
  Command command;
  JumpTarget target;
  int direction;
};
constexpr std::array<Jump, 8> kJumps{{{Command::kPreviousCollision, JumpTarget::kCollision, -1},
                                      {Command::kNextCollision, JumpTarget::kCollision, 1},
                                      {Command::kPreviousClick, JumpTarget::kClick, -1},
                                      {Command::kNextClick, JumpTarget::kClick, 1},
                                      {Command::kPreviousLateFrame, JumpTarget::kLateFrame, -1},
                                      {Command::kNextLateFrame, JumpTarget::kLateFrame, 1},
                                      {Command::kPreviousAnswer, JumpTarget::kResponse, -1},
                                      {Command::kNextAnswer, JumpTarget::kResponse, 1}}};

/// What a command shows or hides.
struct Toggle {
  Command command;
  bool ReplayLook::*shown;
};
constexpr std::array<Toggle, 4> kToggles{{{Command::kGaze, &ReplayLook::gaze},
                                          {Command::kContacts, &ReplayLook::contacts},
                                          {Command::kVolumes, &ReplayLook::volumes},
                                          {Command::kFinest, &ReplayLook::finest}}};

}  // namespace

std::optional<ReplayCommand> command_of(const SDL_Keysym& key) {
  for (const KeyOfCommand& each : kCommandKeys) {
    if (each.key == key.sym && (each.held == 0 || (key.mod & each.held) != 0)) {
      return each.command;
    }
  }
  return std::nullopt;
}

void draw_replay_help(const Gui& gui) {
  constexpr float kLine = 1.5F;  // of the font's size
  ImFont* font = gui.fonts().small;
  float keys_px = 0.0F;
  float meanings_px = 0.0F;
  float lines = 0.0F;
  for (const HelpLine& line : kHelp) {
    keys_px = std::max(keys_px, width_of(line.keys, *font));
    meanings_px = std::max(meanings_px, width_of(line.meaning, *font));
    lines += *line.keys != '\0' ? 1.0F : 0.5F;
  }
  const float inset = 1.5F * font->FontSize;
  const ImVec2 from = draw_card(gui, ImVec2(keys_px + meanings_px + 4.0F * inset,
                                            lines * kLine * font->FontSize + 2.0F * inset));
  float y = from.y + inset;
  for (const HelpLine& line : kHelp) {
    write_at(ImVec2(from.x + inset, y), line.keys, font, palette::kAccent);
    write_at(ImVec2(from.x + 3.0F * inset + keys_px, y), line.meaning, font, palette::kText);
    y += (*line.keys != '\0' ? kLine : 0.5F * kLine) * font->FontSize;
  }
}

std::optional<std::string> steer(ReplayPlayback& playback, const ReplayView& replay,
                                 Command command) {
  for (const Jump& jump : kJumps) {
    if (jump.command != command) {
      continue;
    }
    const auto to_s =
        jump_from(replay.marks, jump.target, playback.time_s(), jump.direction, replay.step_hz);
    if (!to_s) {
      return std::string("no ") + word_of(jump.target) +
             (jump.direction > 0 ? " after this" : " before this");
    }
    playback.seek(*to_s);
    return "";
  }
  switch (command) {
    case Command::kPlay:
      playback.toggle();
      return "";
    case Command::kStepBack:
    case Command::kStepOn:
      playback.step(command == Command::kStepOn ? 1 : -1);
      return "";
    case Command::kStart:
    case Command::kEnd:
      playback.seek(command == Command::kEnd ? playback.span_s() : 0.0);
      return "";
    case Command::kSlower:
    case Command::kFaster:
      playback.change_speed(command == Command::kFaster ? 1 : -1);
      return "";
    default:
      return std::nullopt;
  }
}

bool change_look(ReplayLook& look, ReplayCommand command) {
  for (const Toggle& toggle : kToggles) {
    if (toggle.command == command) {
      look.*toggle.shown = !(look.*toggle.shown);
      return true;
    }
  }
  if (command == Command::kColours) {
    look.colours = next_colours(look.colours);
  } else if (command == Command::kOwnView) {
    look.camera.reset();
  }
  return command == Command::kColours || command == Command::kOwnView;
}

}  // namespace impetus::inline viewers
