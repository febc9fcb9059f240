// `impetus timing`: what this machine's display, input, gaze, markers and sounds do in time, for
// the methods section.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "experiments/commands/commands.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/settings/input_error.hpp"

#ifdef IMPETUS_WINDOW
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/running/chosen_screen.hpp"
#include "experiments/commands/sentences.hpp"
#include "experiments/commands/window_size.hpp"
#include "experiments/markers/marker_writer.hpp"
#include "experiments/models/atomic_file.hpp"
#include "experiments/provenance/machine_name.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/timing/timing_json.hpp"
#include "experiments/timing/timing_page.hpp"
#include "experiments/timing/timing_run.hpp"
#include "experiments/timing/timing_verdicts.hpp"
#include "experiments/trackers/tracker_kinds.hpp"
#include "experiments/window/audio_device.hpp"
#include "experiments/window/input_self_test.hpp"
#include "experiments/window/shown_patch.hpp"
#include "experiments/window/window.hpp"
#endif

namespace impetus::inline commands {
namespace {

#ifdef IMPETUS_WINDOW
/// What stands beside the screen.
struct LabDevices {
  std::shared_ptr<Tracker> tracker;  ///< none: the mouse
  std::string marker_address;        ///< "": nobody is told
  std::unique_ptr<MarkerLine> line;
  std::unique_ptr<AudioDevice> audio;  ///< none: no sound was asked for
};

/// The lab's window as a timing report needs it.
class WindowLab final : public TimingLab {
 public:
  /// Opens the window, with the pointer in its middle. Throws what Window throws.
  WindowLab(const WindowOptions& options, const ScreenGeometry& screen, LabDevices devices)
      : window_(options, clock_), devices_(std::move(devices)) {
    window_.set_geometry(screen);
    centre_pointer(window_);
    if (devices_.tracker) {
      eye_.emplace(devices_.tracker, window_.geometry());
    }
    if (devices_.line) {
      markers_.emplace(std::move(devices_.line), MarkerCodes{1, 2, 3, 4, 5, 6}, clock_);
    }
  }

  Display& display() override { return window_; }
  Input& input() override { return window_; }
  Gaze& gaze() override { return eye_ ? static_cast<Gaze&>(*eye_) : window_.mouse_gaze(); }
  [[nodiscard]] std::string gaze_clock() const override {
    return devices_.tracker ? devices_.tracker->clock_words() : "";
  }
  Markers* markers() override { return markers_ ? &*markers_ : nullptr; }
  [[nodiscard]] std::string marker_address() const override { return devices_.marker_address; }
  Sounds* sounds() override { return devices_.audio.get(); }
  [[nodiscard]] std::string sound_device() const override {
    return devices_.audio ? devices_.audio->description() : "";
  }
  [[nodiscard]] const Clock& clock() const override { return clock_; }
  SyncTest sync_test() override { return window_.sync_test(); }
  InputTrace try_input(const std::function<bool()>& show) override {
    return impetus::try_input(window_, clock_, show);
  }
  void show_patch(ScreenCorner corner) override { window_.show_patch(corner); }
  [[nodiscard]] bool can_read_patch() override { return can_read_shown_patch(window_); }
  std::optional<std::int64_t> read_patch() override { return shown_patch(window_); }

  Window& window() { return window_; }

 private:
  SteadyClock clock_;
  Window window_;
  LabDevices devices_;
  std::optional<TrackedEye> eye_;
  std::optional<MarkerWriter> markers_;
};
#endif

/// What `impetus timing` was asked for.
struct TimingOptions {
  std::string out{"timing"};
  double seconds{10.0};
  std::string window_size;
  std::string screen_file;
  std::string patch{"bottom left"};
  std::string gaze;     ///< an eye tracker's URL; "": the mouse
  std::string markers;  ///< "": nobody is told
  bool sound{false};
  bool json{false};
  bool force{false};
};

#ifdef IMPETUS_WINDOW

/// Throws InputError where nobody answers.
LabDevices opened_devices(const TimingOptions& options) {
  LabDevices devices;
  if (!options.gaze.empty()) {
    devices.tracker = open_tracker(options.gaze);
  }
  devices.marker_address = options.markers;
  if (!options.markers.empty()) {
    devices.line = open_marker_line(options.markers);
  }
  if (options.sound) {
    devices.audio = std::make_unique<AudioDevice>();
  }
  return devices;
}

/// What takes long, before the window opens.
void build_bodies(const TimingScenes& scenes, const ScreenGeometry& screen, ShapeLibrary& shapes) {
  ProgressLine line("building the bodies");
  shapes.tell([&line](double share) { line.tell(share); });
  for (const int bodies : {1, 15, 250}) {
    static_cast<void>(scenes.stage(timing_trial(bodies), screen));
  }
  shapes.tell({});
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

TimingFacts facts_before(WindowLab& lab, double seconds) {
  TimingFacts facts;
  facts.build = build_name();
  facts.machine = machine_name();
  facts.started_utc = utc_now();
  facts.compositor = compositor_of(lab.window());
  facts.width_px = lab.window().width_px();
  facts.height_px = lab.window().height_px();
  facts.nominal_hz = lab.window().refresh_hz();
  facts.seconds = seconds;
  return facts;
}

/// Throws InputError when it was stopped.
TimingReport measured(const TimingOptions& options, const ScreenCorner corner,
                      const ScreenGeometry& screen, const TimingScenes& scenes,
                      LabDevices devices) {
  WindowLab lab(window_options(options.window_size), screen, std::move(devices));
  TimingFacts facts = facts_before(lab, options.seconds);
  const TellPart tell = [](const SessionProgress& progress) {
    std::fprintf(stderr, "%s\n", progress.label.c_str());
  };
  auto report = run_timing(lab, scenes, {options.seconds, corner}, tell);
  require(report.has_value(), "stopped before all was measured; nothing was written");
  facts.display = lab.window().description();
  report->facts = std::move(facts);
  return std::move(*report);
}

void print_verdicts(const std::vector<TimingVerdict>& verdicts) {
  for (const TimingVerdict& verdict : verdicts) {
    std::printf("%s: %s\n  %s\n", verdict.subject.c_str(), words_of(verdict.grade),
                verdict.measured.c_str());
  }
}

int report_timing(const TimingOptions& options) {
  const ScreenCorner corner = patch_corner("--patch", options.patch);
  const WindowOptions window = window_options(options.window_size);
  const std::filesystem::path folder = options.out;
  require_new_files(folder, {"timing.html", "timing.json"}, options.force);
  const ScreenGeometry screen = chosen_screen(options.screen_file, window);
  LabDevices devices = opened_devices(options);
  ShapeLibrary shapes;
  const TimingScenes scenes(options.seconds, shapes);
  build_bodies(scenes, screen, shapes);
  const TimingReport report = measured(options, corner, screen, scenes, std::move(devices));
  const std::vector<TimingVerdict> verdicts = timing_verdicts(report);
  const std::string text = timing_json(report).dump(2) + "\n";
  make_out_folder(folder);
  write_whole_file(folder / "timing.html", timing_page(report));
  write_whole_file(folder / "timing.json", text);
  if (options.json) {
    std::fputs(text.c_str(), stdout);
  } else {
    print_verdicts(verdicts);
    std::printf("Written to %s and timing.json beside it\n",
                (folder / "timing.html").string().c_str());
  }
  return worst_of(verdicts) == TimingGrade::kNotForTiming ? kFound : kDone;
}

#else

int report_timing(const TimingOptions& /*options*/) {
  throw InputError("this build has no window, and without one there is no timing to report");
}

#endif

}  // namespace

void add_timing(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<TimingOptions>(
      app, chosen, report_timing, "timing",
      "Measure this machine's flips, input and gaze in time: a page for the methods");
  command->add_option("--out", options->out, "The folder to write to")->capture_default_str();
  command->add_option("--seconds", options->seconds, "That each of the six or seven parts takes")
      ->check(number_from(1.0, 3600.0))
      ->capture_default_str();
  command->add_option("--window", options->window_size, "WIDTHxHEIGHT instead of fullscreen");
  command->add_option("--screen", options->screen_file,
                      "The lab's screen file (default: what `impetus screen` saved)");
  command->add_option("--patch", options->patch, "The corner of the coded patch")
      ->capture_default_str();
  command->add_option("--gaze", options->gaze,
                      "An eye tracker to measure in place of the mouse: pupil://HOST[:PORT], "
                      "gazepoint://HOST[:PORT] or lsl://STREAM");
  command->add_option("--markers", options->markers,
                      "Where to send markers, and measure how soon: serial:///dev/PORT or "
                      "tcp://HOST:PORT or lsl://NAME");
  command->add_flag("--sound", options->sound,
                    "Play sounds, and measure how near they come to when they were asked for");
  command->add_flag("--json", options->json, "Print the report as JSON, too");
  command->add_flag("--force", options->force, "Overwrite an earlier report");
}

}  // namespace impetus::inline commands
