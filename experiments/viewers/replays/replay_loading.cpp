// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_loading.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "experiments/viewing/replay_simulation.hpp"
#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline viewers {
namespace {

using Command = ReplayCommand;

/// What takes less is not worth a word.
constexpr std::int64_t kUnnoticed_ns = 150'000'000;
constexpr std::int64_t kBetweenFrames_ns = 40'000'000;

/// While bodies are built and the trial is simulated again: a screen that says how far it is.
class Waiting {
 public:
  Waiting(Canvas& canvas, std::string title, const Clock& clock)
      : canvas_(canvas), title_(std::move(title)), clock_(clock), began_ns_(clock.now_ns()) {}

  /// Shows how far `doing` is, now and then. Throws Left when that is not waited for.
  void tell(const std::string& doing, double share) {
    const std::int64_t now_ns = clock_.now_ns();
    if (now_ns - began_ns_ < kUnnoticed_ns || now_ns - shown_ns_ < kBetweenFrames_ns) {
      return;
    }
    show(doing, static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0)));
    shown_ns_ = clock_.now_ns();
    look_for_keys();
  }

 private:
  void show(const std::string& doing, int percent) {
    const Gui& gui = canvas_.gui;
    const float width = std::round(0.5F * gui.width());
    const float left = std::round(0.5F * (gui.width() - width));
    canvas_.fill_page();
    canvas_.gui.begin();
    ImGui::SetCursorScreenPos(ImVec2(left, std::round(0.4F * gui.height())));
    draw_text(title_, gui.fonts().title[2], palette::kText, width, Align::kLeft);
    draw_text(doing + "  " + std::to_string(percent) + " %", gui.fonts().body[2], palette::kText,
              width, Align::kLeft);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float bottom = from.y + std::round(0.4F * gui.fonts().small->FontSize);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(from, ImVec2(from.x + width, bottom), palette::kSurface, 3.0F);
    draw.AddRectFilled(from, ImVec2(from.x + width * static_cast<float>(0.01 * percent), bottom),
                       palette::kAccent, 3.0F);
    canvas_.gui.end();
    static_cast<void>(canvas_.deadlines.flip());
  }

  void look_for_keys() {
    for (const StampedEvent& event : canvas_.events.take()) {
      if (event.event.type != SDL_KEYDOWN) {
        continue;
      }
      const auto command = command_of(event.event.key.keysym);
      if (command == Command::kClose || command == Command::kPreviousTrial ||
          command == Command::kNextTrial) {
        static_cast<void>(canvas_.events.take_pause_request());
        throw Left{*command};
      }
    }
    if (canvas_.events.closed()) {
      throw Left{Command::kClose};
    }
  }

  Canvas& canvas_;
  std::string title_;
  const Clock& clock_;
  std::int64_t began_ns_;
  std::int64_t shown_ns_{0};
};

}  // namespace

LoadedReplay load_replay(Canvas& canvas, ViewedStimuli& stimuli, std::size_t index,
                         const Clock& clock) {
  Waiting waiting(canvas, stimuli.line(index).words, clock);
  ViewedStimulus stimulus =
      stimuli.load(index, [&waiting](double share) { waiting.tell("building the bodies", share); });
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
  return {std::move(stimulus), std::move(view)};
}

}  // namespace impetus::inline viewers
