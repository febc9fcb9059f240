// One stimulus in the viewer of replays: its panes, its keys and buttons, its timeline.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/viewers/replays/replay_list.hpp"
#include "experiments/viewers/replays/replay_loading.hpp"
#include "experiments/viewers/replays/replay_picture.hpp"
#include "experiments/viewing/finest_beside.hpp"
#include "experiments/viewing/replay_playback.hpp"

namespace impetus::inline viewers {

class ReplayScreen {
 public:
  /// `look` is what is shown, and is changed by keys. All but `loaded` must outlive this.
  ReplayScreen(Canvas& canvas, LoadedReplay loaded, ViewedStimuli& stimuli, std::size_t index,
               ReplayLook& look, const Clock& clock);

  /// Shows it until another is asked for: which; or until the viewer is closed: none.
  std::optional<std::size_t> run();

  /// A power of two.
  [[nodiscard]] int speed() const { return playback_.speed(); }
  void set_speed(int speed) { playback_.set_speed(speed); }

 private:
  void take_events();
  void take(const SDL_Event& event);
  void press(const SDL_Keysym& key, bool repeats);
  void drag(const SDL_Event& event);
  void command(ReplayCommand command);
  void go_to(std::size_t index);

  std::int64_t draw_and_flip();
  void draw_panes(const std::vector<ReplayMoment>& moments);
  void draw_header();
  void draw_footer();
  void draw_state() const;
  void draw_over_all();
  void save(const std::vector<ReplayMoment>& moments);
  void say(std::string words);
  void go_on_with_finest();

  [[nodiscard]] std::vector<ReplayMoment> moments() const;
  [[nodiscard]] std::vector<PixelArea> pane_areas() const;
  [[nodiscard]] std::string words_of_recorded() const;
  [[nodiscard]] std::string words_of_finest() const;
  [[nodiscard]] bool in_a_pane(int x_px, int y_px) const;
  [[nodiscard]] float footer_height() const;

  Canvas& canvas_;
  LoadedReplay loaded_;
  std::size_t index_;
  std::size_t count_;
  ReplayLook& look_;
  const Clock& clock_;
  ReplayPlayback playback_;
  FinestBeside finest_;
  ReplayList list_;
  ReplayPicture recorded_picture_;
  ReplayPicture finest_picture_;
  std::optional<std::int64_t> parting_step_;
  float header_px_{0.0F};
  bool help_shown_{false};
  bool drags_{false};
  bool saves_{false};
  bool closed_{false};
  std::optional<std::size_t> next_;
  std::string said_;
  std::int64_t said_until_ns_{0};
};

}  // namespace impetus::inline viewers
