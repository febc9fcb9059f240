// SPDX-License-Identifier: MIT
#include "experiments/commands/running/laboratory.hpp"

#include <cstdio>
#include <stdexcept>

#include "experiments/commands/running/chosen_screen.hpp"
#include "experiments/observers/headless_lab.hpp"
#include "experiments/protocol/screen_file.hpp"

#ifdef IMPETUS_WINDOW
#include "experiments/commands/window_size.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/viewers/screen_setup.hpp"
#include "experiments/window/audio_device.hpp"
#include "experiments/window/display.hpp"
#include "experiments/window/window.hpp"
#endif

namespace impetus::inline commands {
namespace {

#ifdef IMPETUS_WINDOW
std::filesystem::path screen_file_of(const LaboratoryOptions& options) {
  return options.screen_file.empty() ? default_screen_file() : options.screen_file;
}

bool is_entered(const LaboratoryOptions& options) {
  return !options.screen_file.empty() || std::filesystem::exists(screen_file_of(options));
}

WindowOptions options_of(const LaboratoryOptions& options) {
  WindowOptions window = window_options(options.window_size);
  window.letters = options.letters;
  return window;
}

DisplayMode required_mode(const WindowOptions& window) {
  try {
    return shown_mode(window);
  } catch (const std::runtime_error& error) {
    throw InputError(std::string(error.what()) + "; run with --observer to go on without a window");
  }
}
#else
constexpr const char* kNoWindow =
    "this build has no window; run with --observer NAME, without --show";
#endif

/// A simulated participant in virtual time, without a window.
class HeadlessLaboratory final : public Laboratory {
 public:
  explicit HeadlessLaboratory(const LaboratoryOptions& options)
      : screen_file_(options.screen_file.string()),
        display_(clock_, kHeadlessHz, screen_without_window(screen_file_)),
        observer_(make_observer(*options.observer,
                                {options.seed, options.participant, clock_, clock_})) {}

  Display& display() override { return display_; }
  Input& input() override { return *observer_; }
  [[nodiscard]] const Clock& clock() const override { return clock_; }
  Gaze* gaze() override { return observer_->eye(); }
  Sounds* sounds() override { return &silence_; }
  [[nodiscard]] std::string sound_words() const override { return "headless: heard by nobody"; }
  SyncTest sync_test() override {
    return {0, 0, 0.0, 0.0, true, "virtual time: every flip happens exactly when it is due"};
  }
  [[nodiscard]] std::string description() const override {
    return "headless, virtual time, 60 Hz; flips happen exactly when they are due";
  }
  [[nodiscard]] bool screen_measured() const override { return !screen_file_.empty(); }
  [[nodiscard]] std::optional<ScreenLight> screen_light() const override {
    return screen_file_.empty() ? std::nullopt : chosen_light(screen_file_);
  }

 private:
  std::string screen_file_;  ///< "": the screen is assumed
  VirtualClock clock_;
  HeadlessDisplay display_;
  NoSounds silence_;
  std::unique_ptr<RatingObserver> observer_;
};

#ifdef IMPETUS_WINDOW

/// A simulated participant in a real window: answers like the headless one, once a person could
/// have read the page.
class ShownObserver final : public Input {
 public:
  /// `window` and `clock` must outlive this.
  ShownObserver(const ObserverFile& observer, std::uint64_t seed, const std::string& participant,
                Window& window, const Clock& clock)
      : observer_(make_observer(observer, {seed, participant, own_time_, clock})),
        window_(window),
        clock_(clock) {}

  Answer ask(const Page& page) override {
    // A person who watches may pause or quit; those pages are theirs to answer.
    if (!page.can_pause && page.choices.size() > 1) {
      return window_.ask(page);
    }
    Answer answer = observer_->ask(page);
    const double seconds = static_cast<double>(answer.arrived_ns - answer.shown_ns) / 1e9;
    answer.shown_ns = clock_.now_ns();
    window_.show_page_for(page, seconds,
                          answer.timed_out ? std::nullopt : std::optional(answer.choice));
    answer.arrived_ns = clock_.now_ns();
    answer.interruption = window_.interruption();
    return answer;
  }
  Interruption interruption() override { return window_.interruption(); }
  void witnessed(const AttemptRecord& shown, const StagedScene& scene) override {
    observer_->witnessed(shown, scene);
  }
  std::vector<ClickRecord> take_clicks() override { return observer_->take_clicks(); }

  /// The participant's eye, looking at the window; null when it has none.
  Gaze* eye() { return observer_->eye(); }

 private:
  VirtualClock own_time_;  ///< of the model's reaction times; the record takes the real clock's
  std::unique_ptr<RatingObserver> observer_;
  Window& window_;
  const Clock& clock_;
};

/// A window, with a person or a simulated participant before it.
class WindowLaboratory final : public Laboratory {
 public:
  explicit WindowLaboratory(const LaboratoryOptions& options)
      : audio_(options.sounds ? std::make_unique<AudioDevice>() : nullptr),
        window_(options_of(options), clock_) {
    window_.set_geometry(lab_screen(options));
    window_.close_when_resized();
    if (options.photodiode) {
      window_.show_patch(*options.photodiode);
    }
    if (options.observer) {
      observer_ = std::make_unique<ShownObserver>(*options.observer, options.seed,
                                                  options.participant, window_, clock_);
    }
  }

  Display& display() override { return window_; }
  Input& input() override { return observer_ ? static_cast<Input&>(*observer_) : window_; }
  Gaze* gaze() override { return observer_ ? observer_->eye() : &window_.mouse_gaze(); }
  Sounds* sounds() override { return audio_.get(); }
  [[nodiscard]] std::string sound_words() const override {
    return audio_ ? audio_->description() : "";
  }
  [[nodiscard]] std::string sound_lost() const override {
    return audio_ && audio_->is_gone()
               ? "the sound device went away; sounds without an instant were not heard"
               : "";
  }
  [[nodiscard]] const Clock& clock() const override { return clock_; }
  SyncTest sync_test() override { return window_.sync_test(); }
  [[nodiscard]] std::string description() const override { return window_.description(); }
  [[nodiscard]] bool screen_measured() const override { return measured_; }
  [[nodiscard]] std::optional<ScreenLight> screen_light() const override { return light_; }

 private:
  /// From the file; asked for once and kept when there is none yet. What a simulated participant
  /// looks at needs no ruler.
  ScreenGeometry lab_screen(const LaboratoryOptions& options) {
    const auto file = screen_file_of(options);
    measured_ = is_entered(options) || !options.observer;
    if (!is_entered(options)) {
      const LabScreen assumed{assumed_screen(window_.width_px(), window_.height_px())};
      if (options.observer) {
        return assumed.geometry;
      }
      const auto entered = ask_screen(window_, assumed);
      if (!entered) {
        throw InputError(
            "the screen's size and distance were not entered; `impetus screen` asks "
            "again");
      }
      save_screen(*entered, file);
    }
    light_ = load_screen(file).light;
    tell_smaller_window();
    return load_screen_of(file, window_.width_px(), window_.height_px());
  }

  void tell_smaller_window() const {
    const DisplayMode display = display_mode();
    if (display.width_px != window_.width_px() || display.height_px != window_.height_px()) {
      std::fprintf(stderr,
                   "warning: --window: the screen's measures are taken as those of the window, "
                   "%d x %d of the display's %d x %d pixels\n",
                   window_.width_px(), window_.height_px(), display.width_px, display.height_px);
    }
  }

  SteadyClock clock_;
  std::unique_ptr<AudioDevice> audio_;  ///< before the window, which nobody should see without it
  Window window_;
  std::unique_ptr<ShownObserver> observer_;
  bool measured_{false};
  std::optional<ScreenLight> light_;
};

#endif

}  // namespace

double refresh_hz_of(const LaboratoryOptions& options) {
  if (!options.has_window()) {
    screen_without_window(options.screen_file.string());  // what is wrong with it is told now
    return kHeadlessHz;
  }
#ifdef IMPETUS_WINDOW
  const WindowOptions window = window_options(options.window_size);
  if (is_entered(options)) {
    load_screen(screen_file_of(options));  // what is wrong with it needs no display to be told
  }
  const DisplayMode shown = required_mode(window);
  if (is_entered(options)) {
    load_screen_of(screen_file_of(options), shown.width_px, shown.height_px);
  }
  return shown.refresh_hz;
#else
  throw InputError(kNoWindow);
#endif
}

std::optional<ScreenGeometry> expected_screen(const LaboratoryOptions& options) {
#ifdef IMPETUS_WINDOW
  if (options.has_window()) {
    const DisplayMode shown = required_mode(window_options(options.window_size));
    if (is_entered(options)) {
      return load_screen_of(screen_file_of(options), shown.width_px, shown.height_px);
    }
    return options.observer ? std::optional(assumed_screen(shown.width_px, shown.height_px))
                            : std::nullopt;
  }
#endif
  return screen_without_window(options.screen_file.string());
}

std::unique_ptr<Laboratory> open_laboratory(const LaboratoryOptions& options) {
  if (!options.has_window()) {
    return std::make_unique<HeadlessLaboratory>(options);
  }
#ifdef IMPETUS_WINDOW
  return std::make_unique<WindowLaboratory>(options);
#else
  throw InputError(kNoWindow);
#endif
}

}  // namespace impetus::inline commands
