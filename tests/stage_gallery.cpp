// Shows one screen of the stage at a time, so that it can be looked at and driven by xdotool.
//
//   stage_gallery <screen> [width height]     answers are printed when the screen is left
//
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/viewers/preview_view.hpp"
#include "experiments/viewers/replays/replay_viewer.hpp"
#include "experiments/viewers/screen_setup.hpp"
#include "experiments/window/window.hpp"
#include "tests/engine/builders.hpp"
#include "tests/gallery_pages.hpp"
#include "tests/gallery_pictures.hpp"

namespace impetus {
namespace {

void print(const Answer& answer) {
  std::printf("interruption %d choice %zu device '%s' after %.3f ms ± %.3f ms, %lld late; fields:",
              static_cast<int>(answer.interruption), answer.choice, answer.device.c_str(),
              static_cast<double>(answer.arrived_ns - answer.shown_ns) / 1e6,
              static_cast<double>(answer.arrival_uncertainty_ns) / 1e6,
              static_cast<long long>(answer.late_frames));
  for (const std::string& field : answer.fields) {
    std::printf(" [%s]", field.c_str());
  }
  std::printf("\n");
}

/// Shows a picture that `at` gives for each frame until Esc or `seconds` have gone by.
void show_until_escape(Window& window, double seconds, const std::function<Picture(double)>& at) {
  window.restart_grid();
  std::int64_t late = 0;
  double worst_ms = 0.0;
  Interruption interruption = Interruption::kNone;
  const auto frames = static_cast<int>(seconds * window.refresh_hz());
  for (int frame = 0; frame < frames && interruption == Interruption::kNone; ++frame) {
    const Flip flip = window.show(at(frame / window.refresh_hz()));
    late += flip.missed_slots;
    worst_ms = std::max(worst_ms, static_cast<double>(flip.lateness_ns()) / 1e6);
    interruption = window.interruption();
  }
  std::printf("left with interruption %d; %lld slots missed, worst lateness %.2f ms\n",
              static_cast<int>(interruption), static_cast<long long>(late), worst_ms);
}

/// 27 tumbling L-blocks in a closed cube, at a size that fits the screen.
StagedScene preview_scene(const Window& window) {
  constexpr double kHalfEdgeM = 0.11;
  constexpr int kDepth = 4;
  const TriangleMesh block = about_centre_of_mass(l_block_mesh(0.036, 0.0126));
  const Mesh mesh = shared(block);
  const BodyModel model = solid_body(block, kDepth);
  RandomStream random(3, "preview");
  std::vector<BodyState> states;
  std::vector<DrawnBody> looks;
  for (int i = 0; i < 27; ++i) {
    const Vector3 place(0.066 * (i % 3 - 1), 0.066 * (i / 3 % 3 - 1), 0.066 * (i / 9 % 3 - 1));
    states.push_back(moving(model, place, random_in_cube(random, 0.08)));
    states.back().pose.orientation = random_turn(random);
    states.back().angular_momentum = model.inverse_inertia.inverse() * random_in_cube(random, 3.0);
    looks.push_back({"block", 0.03, i % 2 == 0 ? kRed : kBlue, mesh});
  }
  WorldSettings settings;
  settings.enclosure = ClosedCube{kHalfEdgeM};
  return {World(std::vector<BodyModel>(states.size(), model), states, settings),
          viewer_at(lab_screen(window), 0.0), looks};
}

/// The tumbling blocks as two recorded trials, looked at in circles.
class MadeUpTrials final : public ViewedStimuli {
 public:
  explicit MadeUpTrials(StagedScene scene) : scene_(std::move(scene)) {}

  [[nodiscard]] std::size_t count() const override { return 2; }
  [[nodiscard]] StimulusLine line(std::size_t index) override {
    const std::string number = std::to_string(37 + index);
    return {37 + static_cast<std::int64_t>(index), "P01 · trial " + number + " of 87 · main"};
  }
  [[nodiscard]] ViewedStimulus load(std::size_t index, const Progress& /*progress*/) override {
    using Kind = TimelineMark::Kind;
    LiveRun live(scene_, 1);
    std::vector<TimedGaze> samples;
    for (int frame = 0; frame <= 120; ++frame) {
      const double time_s = frame / 60.0;
      const ScreenPoint place{0.04 * std::cos(3.0 * time_s), 0.03 * std::sin(3.0 * time_s)};
      const bool blinks = frame >= 60 && frame < 72;
      samples.push_back({time_s, blinks ? Fixation() : Fixation(place),
                         blinks ? GazeLoss::kBlink : GazeLoss::kNone});
      live.look_at({place, frame + 1, 0, {}});
      static_cast<void>(live.poses_at(time_s));
    }
    return {line(index).words,
            {"delay_ms 100", "azimuth_deg 30", "rated 2 of 5 (1 is best)"},
            scene_,
            live.take_steps(),
            {{Kind::kLateFrame, 0.35, 0.35, ""},
             {Kind::kClick, 0.8, 0.8, ""},
             {Kind::kGazeLost, 1.0, 1.2, ""},
             {Kind::kResponse, 2.8, 2.8, "rated 2"}},
            samples,
            {"gallery", 37 + static_cast<std::int64_t>(index)}};
  }

 private:
  StagedScene scene_;
};

void show_replay(Window& window) {
  const SteadyClock clock;
  MadeUpTrials trials(preview_scene(window));
  view_replays(window, trials, clock);
}

void show_preview(Window& window) {
  const SteadyClock clock;
  view_preview(window, preview_scene(window), clock);
}

void show_setup(Window& window) {
  const auto entered = ask_screen(window, {lab_screen(window)});
  if (entered) {
    const ScreenGeometry& screen = entered->geometry;
    std::printf("%.4f × %.4f m, %d × %d px, %.3f m away\n", screen.width_m, screen.height_m,
                screen.width_px, screen.height_px, screen.viewing_distance_m);
  } else {
    std::printf("cancelled\n");
  }
}

/// A trial's order of events: pictures during which keys are pressed, then its question.
void show_trial(Window& window) {
  show_until_escape(window, 1.5, [&](double time_s) {
    return two_balls(window, 2.0 + 3.0 * std::abs(1.0 - time_s), 0.0);
  });
  print(window.ask(rating()));
}

void check_sync(Window& window) {
  const SyncTest test = window.sync_test();
  std::printf("%s after %lld tries: %s\n", test.passed ? "passed" : "failed",
              static_cast<long long>(test.tries), test.verdict.c_str());
}

using Screen = std::function<void(Window&)>;

Screen asking(Page (*page)()) {
  return [page](Window& window) { print(window.ask(page())); };
}

Screen showing(double seconds, const std::function<Picture(const Window&, double)>& at) {
  return [seconds, at](Window& window) {
    show_until_escape(window, seconds, [&](double time_s) { return at(window, time_s); });
  };
}

const std::map<std::string, Screen>& screens() {
  static const std::map<std::string, Screen> all{
      {"consent", asking(consent)},
      {"long", asking(long_text)},
      {"form", asking(form)},
      {"question", asking(question)},
      {"instructions", asking(instructions)},
      {"rating", asking(rating)},
      {"break", asking(rest)},
      {"pause", asking(pause)},
      {"thanks", asking(thanks)},
      {"touching", showing(60, [](const Window& w, double) { return two_balls(w, 2.0, 0.0); })},
      {"apart", showing(60, [](const Window& w, double) { return two_balls(w, 6.0, 0.0); })},
      {"aside", showing(60, [](const Window& w, double) { return two_balls(w, 2.0, 60.0); })},
      {"moving", showing(5, [](const Window& w, double t) { return two_balls(w, 2.0 + t, 0.0); })},
      {"crowd", showing(60, [](const Window& w, double t) { return crowd(w, t); })},
      {"boxes", showing(60, [](const Window& w, double) { return two_boxes(w, 0.0); })},
      {"boxes aside", showing(60, [](const Window& w, double) { return two_boxes(w, 40.0); })},
      {"blocks", showing(60, [](const Window& w, double) { return two_l_blocks(w, 0.0, 0.0); })},
      {"blocks aside",
       showing(60, [](const Window& w, double) { return two_l_blocks(w, 35.0, 35.0); })},
      {"blocks turning",
       showing(5, [](const Window& w, double t) { return two_l_blocks(w, 20.0, 72.0 * t); })},
      {"meshes", showing(60, [](const Window& w, double) { return balls_and_meshes(w, 0.0); })},
      {"meshes turning", showing(5, balls_and_meshes)},
      {"enclosure", showing(60, [](const Window& w, double) { return enclosed(w, 0.0, 0.12); })},
      {"enclosure aside",
       showing(60, [](const Window& w, double t) { return enclosed(w, 30.0 + 5.0 * t, 0.12); })},
      {"enclosure round the eye",
       showing(60, [](const Window& w, double) { return enclosed(w, 20.0, 0.6); })},
      {"enclosure lit",
       showing(60, [](const Window& w, double) { return enclosed_and_lit(w, 0.0); })},
      {"ground", showing(60, [](const Window& w, double) { return on_ground(w, 0.0); })},
      {"ground moving", showing(5, on_ground)},
      {"fixation", showing(60,
                           [](const Window& w, double) {
                             Picture picture = two_balls(w, 2.0, 0.0);
                             picture.bodies.clear();
                             picture.fixation_cross = true;
                             return picture;
                           })},
      {"watched", [](Window& window) { window.show_page_for(rating(), 3.0, 3); }},
      {"trial", show_trial},
      {"replay", show_replay},
      {"preview", show_preview},
      {"setup", show_setup},
      {"sync", check_sync}};
  return all;
}

int show(int count, char** arguments) {
  const auto screen = count > 1 ? screens().find(arguments[1]) : screens().end();
  if (screen == screens().end()) {
    std::printf("which screen?");
    for (const auto& [name, unused] : screens()) {
      std::printf(" %s", name.c_str());
    }
    std::printf("\n");
    return 2;
  }
  WindowOptions options;
  options.fullscreen = count < 4;
  if (count >= 4) {
    options.width_px = std::atoi(arguments[2]);
    options.height_px = std::atoi(arguments[3]);
  }
  const SteadyClock clock;
  Window window(options, clock);
  window.set_geometry(lab_screen(window));
  screen->second(window);
  std::printf("%s\n", window.description().c_str());
  return 0;
}

}  // namespace
}  // namespace impetus

int main(int count, char** arguments) {
  try {
    return impetus::show(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
