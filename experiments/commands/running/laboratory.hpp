// The place a session runs in: a window and a person, a window and a simulated participant, or
// nothing but virtual time.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "experiments/protocol/observer_file.hpp"
#include "experiments/record/lab_screen.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/record/sound.hpp"
#include "experiments/session/timing_check.hpp"

namespace impetus::inline commands {

/// Who takes part, and what the window is to be like.
struct LaboratoryOptions {
  std::optional<ObserverFile> observer;
  bool show{false};  ///< a simulated participant in a real window
  std::string participant;
  std::uint64_t seed{0};
  std::filesystem::path screen_file;         ///< "" for the lab's default
  std::string window_size;                   ///< "1280x1024"; "" for fullscreen
  std::optional<ScreenCorner> photodiode{};  ///< where a patch for one is drawn
  std::set<std::uint16_t> letters{};         ///< of kWideLetters, that the window will show
  bool sounds{false};                        ///< scenes of it, or of its series, are heard

  /// Whether somebody sees a window.
  [[nodiscard]] bool has_window() const { return !observer || show; }
};

/// The display, input, gaze and clock that a session runs with.
class Laboratory {
 public:
  virtual ~Laboratory() = default;
  virtual Display& display() = 0;
  virtual Input& input() = 0;
  /// Where the participant looks; none when nothing tells.
  virtual Gaze* gaze() { return nullptr; }
  /// What plays the sounds of scenes; none: the scenes have none.
  virtual Sounds* sounds() { return nullptr; }
  /// By what they are heard, in words.
  [[nodiscard]] virtual std::string sound_words() const { return ""; }
  /// In a sentence, that it is gone; "": it is there, or never was.
  [[nodiscard]] virtual std::string sound_lost() const { return ""; }
  /// Of flips and gaze samples.
  [[nodiscard]] virtual const Clock& clock() const = 0;
  virtual SyncTest sync_test() = 0;
  [[nodiscard]] virtual std::string description() const = 0;
  [[nodiscard]] virtual bool screen_measured() const = 0;
  /// How bright the screen is; none where that was not measured.
  [[nodiscard]] virtual std::optional<ScreenLight> screen_light() const { return std::nullopt; }
};

/// Frames per second that the laboratory will have, found without opening it. Throws InputError
/// when it could not be opened: no window in this build, an impossible window size or screen file,
/// pixels that are not square where nobody said so, or no display.
double refresh_hz_of(const LaboratoryOptions& options);

/// The screen that the laboratory will have; none where it must be asked for when it opens. Throws
/// InputError as refresh_hz_of() does.
std::optional<ScreenGeometry> expected_screen(const LaboratoryOptions& options);

/// Precondition: refresh_hz_of() accepted the options.
std::unique_ptr<Laboratory> open_laboratory(const LaboratoryOptions& options);

}  // namespace impetus::inline commands
