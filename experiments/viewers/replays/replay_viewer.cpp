// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_viewer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/tables/number_text.hpp"
#include "experiments/viewers/picture_overlays.hpp"
#include "experiments/viewers/replays/replay_controls.hpp"
#include "experiments/viewers/replays/replay_list.hpp"
#include "experiments/viewers/replays/replay_loading.hpp"
#include "experiments/viewers/replays/replay_picture.hpp"
#include "experiments/viewers/viewer_screen.hpp"
#include "experiments/viewing/replay_simulation.hpp"
#include "experiments/window/display.hpp"
#include "experiments/window/pages/widgets.hpp"
#include "experiments/window/pixels.hpp"

namespace impetus::inline viewers {
namespace {

using Command = ReplayCommand;

constexpr std::int64_t kSaidFor_ns = 6'000'000'000;
constexpr double kDegreesPerPixel = 0.3;

bool may_repeat(Command command) {
  return command == Command::kStepBack || command == Command::kStepOn ||
         command == Command::kNextCollision || command == Command::kPreviousCollision;
}

/// One stimulus: its panes, its keys and buttons, its timeline.
class ReplayScreen final : public ViewerScreen {
 public:
  /// `look` is what is shown, and is changed by keys. All but `loaded` must outlive this. `speed`
  /// is a power of two.
  ReplayScreen(Canvas& canvas, LoadedReplay loaded, ViewedStimuli& stimuli, std::size_t index,
               ReplayLook& look, int speed, const Clock& clock)
      : ViewerScreen(canvas),
        loaded_(std::move(loaded)),
        index_(index),
        count_(stimuli.count()),
        look_(look),
        clock_(clock),
        playback_(loaded_.view),
        finest_(loaded_.stimulus.scene, loaded_.stimulus.steps, clock),
        list_(stimuli, index),
        recorded_picture_(canvas),
        finest_picture_(canvas) {
    playback_.set_speed(speed);
    canvas_.gui.forget_input();
    canvas_.gui.begin();
    draw_header();  // to know how high it is
    canvas_.gui.discard();
  }

  /// Which was asked for; none: the viewer was closed.
  [[nodiscard]] std::optional<std::size_t> next() const { return next_; }
  [[nodiscard]] int speed() const { return playback_.speed(); }

 private:
  void take(const SDL_Event& event) override {
    if (event.type == SDL_KEYDOWN) {
      press(event.key.keysym, event.key.repeat != 0);
    } else if (!list_.is_open()) {
      drag(event);
    }
  }

  void press(const SDL_Keysym& key, bool repeats) {
    if (list_.press(key)) {
      help_shown_ = false;
      return;
    }
    const auto asked = command_of(key);
    if (asked && (!repeats || may_repeat(*asked))) {
      command(*asked);
    }
  }

  void drag(const SDL_Event& event) {
    if (event.type == SDL_MOUSEBUTTONDOWN) {
      drags_ = event.button.button == SDL_BUTTON_LEFT && in_a_pane(event.button.x, event.button.y);
    } else if (event.type == SDL_MOUSEBUTTONUP) {
      drags_ = false;
    } else if (event.type == SDL_MOUSEMOTION && drags_) {
      look_.camera.turn(-kDegreesPerPixel * event.motion.xrel,
                        kDegreesPerPixel * event.motion.yrel);
    } else if (event.type == SDL_MOUSEWHEEL) {
      int x_px = 0;
      int y_px = 0;
      SDL_GetMouseState(&x_px, &y_px);
      if (in_a_pane(x_px, y_px)) {
        look_.camera.zoom(event.wheel.y);
      }
    }
  }

  [[nodiscard]] bool in_a_pane(int x_px, int y_px) const {
    const std::vector<PixelArea> panes = areas();
    const int y_up_px = canvas_.window.height_px() - y_px;
    return std::any_of(panes.begin(), panes.end(), [&](const PixelArea& area) {
      return x_px >= area.left && x_px < area.left + area.width && y_up_px > area.bottom &&
             y_up_px <= area.bottom + area.height;
    });
  }

  void command(Command command) {
    said_until_ns_ = 0;
    if (command == Command::kHelp || (help_shown_ && command == Command::kClose)) {
      help_shown_ = !help_shown_;
      return;
    }
    if (change_look(look_, command)) {
      return;
    }
    if (const auto steered = steer(playback_, loaded_.view, command)) {
      if (!steered->empty()) {
        say(*steered);
      }
      return;
    }
    switch (command) {
      case Command::kPicture:
        saves_ = true;
        break;
      case Command::kTrials:
        list_.open();
        break;
      case Command::kPreviousTrial:
        index_ > 0 ? go_to(index_ - 1) : say("this is the first");
        break;
      case Command::kNextTrial:
        index_ + 1 < count_ ? go_to(index_ + 1) : say("this is the last");
        break;
      default:
        leave();
    }
  }

  void go_to(std::size_t index) {
    next_ = index;
    leave();
  }

  void say(std::string words) {
    said_ = std::move(words);
    said_until_ns_ = clock_.now_ns() + kSaidFor_ns;
  }

  void go_on_with_finest() {
    if (!look_.finest || !finest_.go_on()) {
      return;
    }
    parting_step_ = parting_step(loaded_.view, *finest_.view());
    if (parting_step_) {
      const double at_s = static_cast<double>(*parting_step_) / loaded_.view.step_hz;
      loaded_.view.marks.push_back({TimelineMark::Kind::kParting, at_s, at_s, ""});
    }
  }

  [[nodiscard]] std::string words_of_finest() const {
    if (finest_.view() == nullptr) {
      return "simulating at the finest level  " +
             std::to_string(static_cast<int>(100.0 * finest_.share())) + " %";
    }
    return parting_step_ ? printed("at the finest level  ·  seen to part at %.0f ms",
                                   1e3 * static_cast<double>(*parting_step_) / loaded_.view.step_hz)
                         : "at the finest level  ·  never seen to part";
  }

  [[nodiscard]] std::string words_of_recorded() const {
    std::string words = look_.finest ? "as recorded" : "";
    if (!look_.camera.is_participants()) {
      const double right_deg = look_.camera.right_deg();
      const double up_deg = look_.camera.up_deg();
      const std::string text = printed(
          "%sseen from %.0f° %s, %.0f° %s, ×%.1f  (R returns)", words.empty() ? "" : "  ·  ",
          std::abs(right_deg), right_deg < 0.0 ? "left" : "right", std::abs(up_deg),
          up_deg < 0.0 ? "below" : "above", look_.camera.magnification());
      words += text;
    }
    return words;
  }

  [[nodiscard]] std::vector<PixelArea> areas() const {
    return pane_areas({look_.finest ? 2 : 1, header_px_, footer_height()}, canvas_.gui,
                      loaded_.view.viewer.screen);
  }

  void paint() override {
    go_on_with_finest();
    const std::vector<PixelArea> panes = areas();
    shown_ = {{&loaded_.view, playback_.time_s(), panes[0], words_of_recorded()}};
    recorded_picture_.paint(shown_[0], look_);
    if (look_.finest) {
      shown_.push_back({finest_.view(), playback_.time_s(), panes[1], words_of_finest()});
      if (finest_.view() != nullptr) {
        finest_picture_.paint(shown_[1], look_);
      }
    }
  }

  void draw() override {
    draw_panes();
    draw_header();
    draw_footer();
    saving_ = std::exchange(saves_, false);
    if (!saving_) {
      draw_over_all();
    }
  }

  void end_frame() override {
    if (saving_) {
      save();
    }
  }

  void go_on(double frame_s) override { playback_.advance(frame_s); }

  void draw_panes() {
    recorded_picture_.draw_over(shown_[0], look_);
    if (shown_.size() < 2) {
      return;
    }
    if (shown_[1].replay != nullptr) {
      ReplayLook without_gaze = look_;  // it looked at the other
      without_gaze.gaze = false;
      finest_picture_.draw_over(shown_[1], without_gaze);
    } else {
      draw_badge(canvas_.gui, shown_[1].area, shown_[1].words);
    }
  }

  void draw_over_all() {
    if (help_shown_) {
      draw_replay_help(canvas_.gui);
    }
    if (list_.is_open()) {
      const auto chosen = list_.draw(canvas_.gui);
      if (chosen && *chosen != index_) {
        go_to(*chosen);
      }
    }
  }

  void draw_header() {
    const Gui& gui = canvas_.gui;
    std::string facts;
    for (const std::string& fact : loaded_.view.facts) {
      facts += (facts.empty() ? "" : "  ·  ") + fact;
    }
    ImGui::SetCursorScreenPos(ImVec2(screen_margin(gui), screen_margin(gui)));
    draw_text(loaded_.view.title, gui.fonts().title[2], palette::kText, content_width(gui),
              Align::kLeft);
    draw_text(facts, gui.fonts().small, palette::kQuietText, content_width(gui), Align::kLeft);
    header_px_ = ImGui::GetCursorScreenPos().y + 0.5F * screen_margin(gui);
  }

  void draw_footer() {
    const Gui& gui = canvas_.gui;
    ImGui::SetCursorScreenPos(ImVec2(screen_margin(gui), gui.height() - footer_height()));
    draw_state();
    const float top_px = ImGui::GetCursorScreenPos().y;
    const auto clicked =
        draw_toolbar(gui, playback_, loaded_.view.marks, look_, content_width(gui));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    toolbar_px_ = at.y - top_px;
    const auto sought = draw_timeline(gui, loaded_.view.marks,
                                      {ImVec2(screen_margin(gui), at.y), content_width(gui),
                                       playback_.span_s(), playback_.time_s()});
    if (list_.is_open()) {
      return;
    }
    if (sought) {
      playback_.seek(*sought);
    }
    if (clicked) {
      command(*clicked);
    }
  }

  void draw_state() const {
    const std::string text =
        printed("%s  ·  %.1f ms  ·  step %lld of %lld  ·  speed %s",
                playback_.playing() ? "playing" : "paused", 1e3 * playback_.time_s(),
                static_cast<long long>(playback_.step_number()),
                static_cast<long long>(playback_.last_step()), playback_.speed_words().c_str());
    ImFont* font = canvas_.gui.fonts().body[2];
    const float width_px = content_width(canvas_.gui);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text(text, font, palette::kText, width_px, Align::kLeft);
    const ImVec2 below = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos(at);
    if (clock_.now_ns() < said_until_ns_) {
      draw_text(said_, font, palette::kAccent, width_px, Align::kRight);
    } else if (loaded_.view.agrees) {
      draw_text("every step agrees with the recording", font, palette::kResponse, width_px,
                Align::kRight);
    } else {
      draw_text("differs from the recording", font, palette::kWarning, width_px, Align::kRight);
    }
    ImGui::SetCursorScreenPos(below + ImVec2(0.0F, 0.3F * canvas_.gui.fonts().small->FontSize));
  }

  /// The smallest area that holds all panes, as a file.
  void save() {
    PixelArea whole = shown_.front().area;
    whole.width = shown_.back().area.left + shown_.back().area.width - whole.left;
    PictureOf picture = loaded_.stimulus.picture;
    picture.step = playback_.step_number();
    const std::string file = picture_name(
        picture, [](const std::string& name) { return std::filesystem::exists(name); });
    try {
      write_png(window_pixels(whole), file);
      say("saved as " + file);
      std::printf("saved as %s\n", std::filesystem::absolute(file).c_str());
      std::fflush(stdout);
    } catch (const std::runtime_error& error) {
      say(error.what());
    }
  }

  [[nodiscard]] float footer_height() const {
    const Gui& gui = canvas_.gui;
    return std::round(0.5F * screen_margin(gui) + timeline_height(gui) + toolbar_px_ +
                      1.35F * gui.fonts().body[2]->FontSize + 0.3F * gui.fonts().small->FontSize);
  }

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
  std::vector<ReplayMoment> shown_;  ///< in the panes of this frame
  std::optional<std::int64_t> parting_step_;
  float header_px_{0.0F};   ///< as drawn last
  float toolbar_px_{0.0F};  ///< the same
  bool help_shown_{false};
  bool drags_{false};
  bool saves_{false};   ///< a picture was asked for
  bool saving_{false};  ///< this frame is it, without what lies over all
  std::optional<std::size_t> next_;
  std::string said_;
  std::int64_t said_until_ns_{0};
};

std::size_t neighbour(std::size_t index, Command command, std::size_t count) {
  return command == Command::kNextTrial ? std::min(index + 1, count - 1)
                                        : index - (index > 0 ? 1 : 0);
}

void view_all(Canvas& canvas, ViewedStimuli& stimuli, const Clock& clock) {
  ReplayLook look;
  int speed = 0;
  std::size_t index = 0;
  canvas.window.show_cursor(true);
  while (true) {
    canvas.deadlines.restart();
    try {
      ReplayScreen screen(canvas, load_replay(canvas, stimuli, index, clock), stimuli, index, look,
                          speed, clock);
      screen.run();
      if (!screen.next()) {
        return;
      }
      speed = screen.speed();
      index = *screen.next();
    } catch (const Left& left) {
      if (left.command == Command::kClose) {
        return;
      }
      index = neighbour(index, left.command, stimuli.count());
    }
  }
}

}  // namespace

void view_replays(Window& window, ViewedStimuli& stimuli, const Clock& clock) {
  while_display_lasts([&] { view_all(window.canvas(), stimuli, clock); });
}

}  // namespace impetus::inline viewers
