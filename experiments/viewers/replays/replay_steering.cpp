// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_steering.hpp"

#include "experiments/viewing/timeline_jumps.hpp"

namespace impetus::inline viewers {
namespace {

using Command = ReplayCommand;

struct Jump {
  JumpTarget target;
  int direction;
};

std::optional<Jump> jump_of(Command command) {
  switch (command) {
    case Command::kPreviousCollision:
      return Jump{JumpTarget::kCollision, -1};
    case Command::kNextCollision:
      return Jump{JumpTarget::kCollision, 1};
    case Command::kPreviousClick:
      return Jump{JumpTarget::kClick, -1};
    case Command::kNextClick:
      return Jump{JumpTarget::kClick, 1};
    case Command::kPreviousLateFrame:
      return Jump{JumpTarget::kLateFrame, -1};
    case Command::kNextLateFrame:
      return Jump{JumpTarget::kLateFrame, 1};
    case Command::kPreviousAnswer:
      return Jump{JumpTarget::kResponse, -1};
    case Command::kNextAnswer:
      return Jump{JumpTarget::kResponse, 1};
    default:
      return std::nullopt;
  }
}

std::string take(const Jump& jump, ReplayPlayback& playback, const ReplayView& replay) {
  const auto to_s =
      jump_from(replay.marks, jump.target, playback.time_s(), jump.direction, replay.step_hz);
  if (!to_s) {
    return std::string("no ") + word_of(jump.target) +
           (jump.direction > 0 ? " after this" : " before this");
  }
  playback.seek(*to_s);
  return "";
}

}  // namespace

std::optional<std::string> steer(ReplayPlayback& playback, const ReplayView& replay,
                                 Command command) {
  if (const auto jump = jump_of(command)) {
    return take(*jump, playback, replay);
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

}  // namespace impetus::inline viewers
