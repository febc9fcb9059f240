// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_loading.hpp"

#include <utility>

#include "experiments/viewing/replay_simulation.hpp"
#include "experiments/window/wait_screen.hpp"

namespace impetus::inline viewers {
namespace {

/// What takes less is not worth a word.
constexpr std::int64_t kUnnoticed_ns = 150'000'000;
constexpr std::int64_t kBetweenFrames_ns = 40'000'000;

/// Thrown out of the building of bodies by a key.
struct Left {
  ReplayCommand command;
};

class Waiting {
 public:
  Waiting(Canvas& canvas, std::string title, const Clock& clock)
      : canvas_(canvas), title_(std::move(title)), clock_(clock), began_ns_(clock.now_ns()) {}

  /// Shows how far `doing` is, now and then. Throws Left when that is not waited for.
  void tell(const char* doing, double share) {
    const std::int64_t now_ns = clock_.now_ns();
    if (now_ns - began_ns_ < kUnnoticed_ns || now_ns - shown_ns_ < kBetweenFrames_ns) {
      return;
    }
    show_wait(canvas_, title_, doing, share);
    shown_ns_ = clock_.now_ns();
    look_for_keys();
  }

 private:
  void look_for_keys() {
    for (const StampedEvent& event : canvas_.events.take()) {
      if (event.event.type != SDL_KEYDOWN) {
        continue;
      }
      const auto command = command_of(event.event.key.keysym);
      if (command == ReplayCommand::kClose || command == ReplayCommand::kPreviousTrial ||
          command == ReplayCommand::kNextTrial) {
        static_cast<void>(canvas_.events.take_pause_request());
        throw Left{*command};
      }
    }
    if (canvas_.events.closed()) {
      throw Left{ReplayCommand::kClose};
    }
  }

  Canvas& canvas_;
  std::string title_;
  const Clock& clock_;
  std::int64_t began_ns_;
  std::int64_t shown_ns_{0};
};

ReplayView simulated(const ViewedStimulus& stimulus, Waiting& waiting) {
  ReplaySimulation simulation(stimulus.scene, stimulus.steps, SimulatedDetail::kAsRecorded);
  while (!simulation.done()) {
    simulation.advance();
    waiting.tell("simulating the trial again", simulation.share());
  }
  ReplayView view = simulation.take();
  view.title = stimulus.title;
  view.facts = stimulus.facts;
  view.samples = stimulus.samples;
  view.marks.insert(view.marks.end(), stimulus.marks.begin(), stimulus.marks.end());
  end_with_last_step(view);
  return view;
}

}  // namespace

LoadingOutcome load_replay(Canvas& canvas, ViewedStimuli& stimuli, std::size_t index,
                           const Clock& clock) {
  Waiting waiting(canvas, stimuli.line(index).words, clock);
  try {
    ViewedStimulus stimulus = stimuli.load(
        index, [&waiting](double share) { waiting.tell("building the bodies", share); });
    ReplayView view = simulated(stimulus, waiting);
    return LoadedReplay{std::move(stimulus), std::move(view)};
  } catch (const Left& left) {
    return left.command;
  }
}

}  // namespace impetus::inline viewers
