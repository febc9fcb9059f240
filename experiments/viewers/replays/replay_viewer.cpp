// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_viewer.hpp"

#include <algorithm>
#include <utility>

#include "experiments/viewers/replays/replay_screen.hpp"
#include "experiments/window/display_loss.hpp"

namespace impetus::inline viewers {
namespace {

std::size_t neighbour(std::size_t index, ReplayCommand command, std::size_t count) {
  return command == ReplayCommand::kNextTrial ? std::min(index + 1, count - 1)
                                              : index - (index > 0 ? 1 : 0);
}

void view_all(Canvas& canvas, ViewedStimuli& stimuli, const Clock& clock) {
  ReplayLook look;
  int speed = 0;
  std::size_t index = 0;
  canvas.window.show_cursor(true);
  while (true) {
    canvas.pacer.restart();
    LoadingOutcome outcome = load_replay(canvas, stimuli, index, clock);
    if (const auto* command = std::get_if<ReplayCommand>(&outcome)) {
      if (*command == ReplayCommand::kClose) {
        return;
      }
      index = neighbour(index, *command, stimuli.count());
      continue;
    }
    ReplayScreen screen(canvas, std::get<LoadedReplay>(std::move(outcome)), stimuli, index, look,
                        clock);
    screen.set_speed(speed);
    const auto next = screen.run();
    if (!next) {
      return;
    }
    speed = screen.speed();
    index = *next;
  }
}

}  // namespace

void view_replays(Window& window, ViewedStimuli& stimuli, const Clock& clock) {
  while_display_lasts([&] { view_all(window.canvas(), stimuli, clock); });
}

}  // namespace impetus::inline viewers
