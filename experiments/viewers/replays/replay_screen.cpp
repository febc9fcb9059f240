// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_screen.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "experiments/drawing/palette.hpp"
#include "experiments/viewers/picture_badge.hpp"
#include "experiments/viewers/replays/replay_help.hpp"
#include "experiments/viewers/replays/replay_panes.hpp"
#include "experiments/viewers/replays/replay_steering.hpp"
#include "experiments/viewers/replays/replay_timeline.hpp"
#include "experiments/viewers/replays/replay_toolbar.hpp"
#include "experiments/window/pages/widgets.hpp"
#include "experiments/window/window_pixels.hpp"

namespace impetus::inline viewers {
namespace {

using Command = ReplayCommand;

constexpr std::int64_t kSaidFor_ns = 6'000'000'000;
constexpr double kDegreesPerPixel = 0.3;

std::string joined(const std::vector<std::string>& facts) {
  std::string line;
  for (const std::string& fact : facts) {
    line += (line.empty() ? "" : "  ·  ") + fact;
  }
  return line;
}

bool may_repeat(Command command) {
  return command == Command::kStepBack || command == Command::kStepOn ||
         command == Command::kNextCollision || command == Command::kPreviousCollision;
}

/// The smallest that holds them all.
PixelArea around(const std::vector<ReplayMoment>& moments) {
  PixelArea whole = moments.front().area;
  whole.width = moments.back().area.left + moments.back().area.width - whole.left;
  return whole;
}

}  // namespace

ReplayScreen::ReplayScreen(Canvas& canvas, LoadedReplay loaded, ViewedStimuli& stimuli,
                           std::size_t index, ReplayLook& look, const Clock& clock)
    : canvas_(canvas),
      loaded_(std::move(loaded)),
      index_(index),
      count_(stimuli.count()),
      look_(look),
      clock_(clock),
      playback_(loaded_.view),
      finest_(loaded_.stimulus.scene, loaded_.stimulus.steps, clock),
      list_(stimuli, index),
      recorded_picture_(canvas),
      finest_picture_(canvas) {}

std::optional<std::size_t> ReplayScreen::run() {
  canvas_.gui.forget_input();
  canvas_.gui.begin();
  draw_header();
  canvas_.gui.discard();
  canvas_.pacer.restart();
  std::int64_t flipped_ns = draw_and_flip();
  canvas_.events.discard();
  while (!canvas_.events.closed() && !closed_ && !next_) {
    take_events();
    go_on_with_finest();
    const std::int64_t now_ns = draw_and_flip();
    playback_.advance(static_cast<double>(now_ns - flipped_ns) / 1e9);
    flipped_ns = now_ns;
  }
  static_cast<void>(canvas_.events.take_pause_request());
  return next_;
}

void ReplayScreen::take_events() {
  for (const StampedEvent& event : canvas_.events.take()) {
    canvas_.gui.feed(event.event);
    take(event.event);
  }
}

void ReplayScreen::take(const SDL_Event& event) {
  if (event.type == SDL_KEYDOWN) {
    press(event.key.keysym, event.key.repeat != 0);
  } else if (!list_.is_open()) {
    drag(event);
  }
}

void ReplayScreen::press(const SDL_Keysym& key, bool repeats) {
  if (list_.press(key)) {
    help_shown_ = false;
    return;
  }
  const auto asked = command_of(key);
  if (asked && (!repeats || may_repeat(*asked))) {
    command(*asked);
  }
}

void ReplayScreen::drag(const SDL_Event& event) {
  switch (event.type) {
    case SDL_MOUSEBUTTONDOWN:
      drags_ = event.button.button == SDL_BUTTON_LEFT && in_a_pane(event.button.x, event.button.y);
      break;
    case SDL_MOUSEBUTTONUP:
      drags_ = false;
      break;
    case SDL_MOUSEMOTION:
      if (drags_) {
        look_.camera.turn(-kDegreesPerPixel * event.motion.xrel,
                          kDegreesPerPixel * event.motion.yrel);
      }
      break;
    case SDL_MOUSEWHEEL: {
      int x_px = 0;
      int y_px = 0;
      SDL_GetMouseState(&x_px, &y_px);
      if (in_a_pane(x_px, y_px)) {
        look_.camera.zoom(event.wheel.y);
      }
      break;
    }
    default:
      break;
  }
}

bool ReplayScreen::in_a_pane(int x_px, int y_px) const {
  const std::vector<PixelArea> areas = pane_areas();
  const int y_up_px = canvas_.window.height_px() - y_px;
  return std::any_of(areas.begin(), areas.end(), [&](const PixelArea& area) {
    return x_px >= area.left && x_px < area.left + area.width && y_up_px > area.bottom &&
           y_up_px <= area.bottom + area.height;
  });
}

void ReplayScreen::command(Command command) {
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
      closed_ = true;
  }
}

void ReplayScreen::go_to(std::size_t index) { next_ = index; }

void ReplayScreen::say(std::string words) {
  said_ = std::move(words);
  said_until_ns_ = clock_.now_ns() + kSaidFor_ns;
}

void ReplayScreen::go_on_with_finest() {
  if (!look_.finest || !finest_.go_on()) {
    return;
  }
  parting_step_ = parting_step(loaded_.view, *finest_.view());
  if (parting_step_) {
    const double at_s = static_cast<double>(*parting_step_) / loaded_.view.step_hz;
    loaded_.view.marks.push_back({TimelineMark::Kind::kParting, at_s, at_s, ""});
  }
}

std::string ReplayScreen::words_of_finest() const {
  if (finest_.view() == nullptr) {
    return "simulating at the finest level  " +
           std::to_string(static_cast<int>(100.0 * finest_.share())) + " %";
  }
  char parts[80];
  if (parting_step_) {
    std::snprintf(parts, sizeof parts, "  ·  seen to part at %.0f ms",
                  1e3 * static_cast<double>(*parting_step_) / loaded_.view.step_hz);
  } else {
    std::snprintf(parts, sizeof parts, "  ·  never seen to part");
  }
  return std::string("at the finest level") + parts;
}

std::string ReplayScreen::words_of_recorded() const {
  std::string words = look_.finest ? "as recorded" : "";
  if (!look_.camera.is_participants()) {
    const double right_deg = look_.camera.right_deg();
    const double up_deg = look_.camera.up_deg();
    char text[120];
    std::snprintf(text, sizeof text, "%sseen from %.0f° %s, %.0f° %s, ×%.1f  (R returns)",
                  words.empty() ? "" : "  ·  ", std::abs(right_deg),
                  right_deg < 0.0 ? "left" : "right", std::abs(up_deg),
                  up_deg < 0.0 ? "below" : "above", look_.camera.magnification());
    words += text;
  }
  return words;
}

std::vector<PixelArea> ReplayScreen::pane_areas() const {
  const Panes panes{look_.finest ? 2 : 1, header_px_, footer_height()};
  return areas_of(panes, canvas_.gui, loaded_.view.viewer.screen);
}

std::vector<ReplayMoment> ReplayScreen::moments() const {
  const std::vector<PixelArea> areas = pane_areas();
  std::vector<ReplayMoment> moments{
      {&loaded_.view, playback_.time_s(), areas[0], words_of_recorded()}};
  if (look_.finest) {
    moments.push_back({finest_.view(), playback_.time_s(), areas[1], words_of_finest()});
  }
  return moments;
}

std::int64_t ReplayScreen::draw_and_flip() {
  const std::vector<ReplayMoment> shown = moments();
  canvas_.painter.fill(canvas_.whole(), palette::kPageGrey);
  recorded_picture_.paint(shown[0], look_);
  if (shown.size() > 1 && shown[1].replay != nullptr) {
    finest_picture_.paint(shown[1], look_);
  }
  canvas_.gui.begin();
  draw_panes(shown);
  draw_header();
  draw_footer();
  if (!saves_) {
    draw_over_all();
  }
  canvas_.gui.end();
  if (saves_) {
    saves_ = false;
    save(shown);
  }
  return canvas_.pacer.flip().flipped_ns;
}

void ReplayScreen::draw_panes(const std::vector<ReplayMoment>& shown) {
  recorded_picture_.draw_over(shown[0], look_);
  if (shown.size() < 2) {
    return;
  }
  if (shown[1].replay != nullptr) {
    ReplayLook without_gaze = look_;  // it looked at the other
    without_gaze.gaze = false;
    finest_picture_.draw_over(shown[1], without_gaze);
  } else {
    draw_badge(canvas_.gui, shown[1].area, shown[1].words);
  }
}

void ReplayScreen::draw_over_all() {
  if (help_shown_) {
    draw_replay_help(canvas_.gui);
  }
  if (list_.is_open()) {
    if (const auto chosen = list_.draw(canvas_.gui)) {
      if (*chosen != index_) {
        go_to(*chosen);
      }
    }
  }
}

void ReplayScreen::draw_header() {
  const Fonts& fonts = canvas_.gui.fonts();
  ImGui::SetCursorScreenPos(ImVec2(screen_margin(canvas_.gui), screen_margin(canvas_.gui)));
  draw_text(loaded_.view.title, fonts.title[2], palette::kText, content_width(canvas_.gui),
            Align::kLeft);
  draw_text(joined(loaded_.view.facts), fonts.small, palette::kQuietText,
            content_width(canvas_.gui), Align::kLeft);
  header_px_ = ImGui::GetCursorScreenPos().y + 0.5F * screen_margin(canvas_.gui);
}

void ReplayScreen::draw_footer() {
  const Gui& gui = canvas_.gui;
  ImGui::SetCursorScreenPos(ImVec2(screen_margin(canvas_.gui), gui.height() - footer_height()));
  draw_state();
  const auto clicked =
      draw_toolbar(gui, playback_, loaded_.view.marks, look_, content_width(canvas_.gui));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const auto sought =
      draw_timeline(gui, loaded_.view.marks,
                    {ImVec2(screen_margin(canvas_.gui), at.y), content_width(canvas_.gui),
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

void ReplayScreen::draw_state() const {
  char text[200];
  std::snprintf(text, sizeof text, "%s  ·  %.1f ms  ·  step %lld of %lld  ·  speed %s",
                playback_.playing() ? "playing" : "paused", 1e3 * playback_.time_s(),
                static_cast<long long>(playback_.step_number()),
                static_cast<long long>(playback_.last_step()), playback_.speed_words().c_str());
  ImFont* font = canvas_.gui.fonts().body[2];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text(text, font, palette::kText, content_width(canvas_.gui), Align::kLeft);
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(at);
  const bool says = clock_.now_ns() < said_until_ns_;
  const bool agrees = loaded_.view.agrees;
  const std::string right = says     ? said_
                            : agrees ? "every step agrees with the recording"
                                     : "differs from the recording";
  draw_text(right, font,
            says     ? palette::kAccent
            : agrees ? palette::kResponse
                     : palette::kWarning,
            content_width(canvas_.gui), Align::kRight);
  ImGui::SetCursorScreenPos(ImVec2(below.x, below.y + 0.3F * canvas_.gui.fonts().small->FontSize));
}

void ReplayScreen::save(const std::vector<ReplayMoment>& shown) {
  PictureOf picture = loaded_.stimulus.picture;
  picture.step = playback_.step_number();
  const std::string file =
      picture_name(picture, [](const std::string& name) { return std::filesystem::exists(name); });
  try {
    write_png(window_pixels(around(shown)), file);
    say("saved as " + file);
    std::printf("saved as %s\n", std::filesystem::absolute(file).c_str());
    std::fflush(stdout);
  } catch (const std::runtime_error& error) {
    say(error.what());
  }
}

float ReplayScreen::footer_height() const {
  const Gui& gui = canvas_.gui;
  return std::round(0.5F * screen_margin(canvas_.gui) + timeline_height(gui) + toolbar_height(gui) +
                    1.35F * gui.fonts().body[2]->FontSize + 0.3F * gui.fonts().small->FontSize);
}

}  // namespace impetus::inline viewers
