// One protocol of a run, from its files to what a session needs.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/commands/running/laboratory.hpp"
#include "experiments/gaze/recorded_eye.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/protocol/solved_values.hpp"
#include "experiments/scenes/shape_library.hpp"
#include "experiments/trackers/tracker.hpp"

namespace impetus::inline commands {

/// What `impetus run` was asked for.
struct RunOptions {
  std::string protocol;  ///< or a series of them
  std::string database{"study.sqlite"};
  std::string participant;
  std::vector<std::string> observers;  ///< one for all parts, or one for each
  std::int64_t participants{0};
  std::int64_t jobs{0};  ///< simulated participants at a time; 0: as many as there are cores
  std::optional<std::uint64_t> seed;
  bool show{false};
  bool allow_rounding{false};
  bool override_sync_test{false};
  bool changed_screen{false};  ///< a resumed session may have another screen than the one before
  std::string screen_file;
  std::string window_size;
  std::string gaze;        ///< a file of recorded gaze, or a tracker's URL; "": the mouse
  std::string photodiode;  ///< the corner of a patch for one; "": none
  std::string markers;     ///< the address of another recorder; "": none
  bool keeps_steps{true};  ///< false: of a study that is analysed once and deleted

  [[nodiscard]] bool simulated() const { return !observers.empty(); }
};

/// One protocol of a run; a run of a series has several.
struct RunPart {
  Protocol protocol;
  LaboratoryOptions lab;                        ///< without participant and seed
  std::vector<SolvedFor> solved{};              ///< for the plan of whoever comes
  std::shared_ptr<const GazeRecording> gaze{};  ///< in place of the participant's; none: his own
  std::shared_ptr<Tracker> tracker{};           ///< of the participant's; none: the mouse
  std::string series{};                         ///< "": it is alone
  std::int64_t series_place{1};                 ///< from 1
};

/// Whether its scene has a sound, be it silent at some levels.
bool is_heard(const Protocol& protocol);

/// Reads and checks the protocol and, unless "", the observer (a name or a file). Throws
/// InputError.
RunPart part_from(const std::filesystem::path& file, const std::string& observer,
                  const RunOptions& options);

/// Of the plan's main trials.
std::vector<std::int64_t> main_slots(const Plan& plan);

/// Builds all bodies of the part, telling its progress.
void build_shapes(const RunPart& part);

/// Solves what the plan needs, telling its progress. Throws InputError where there is no solution.
void solve_what_is_asked(RunPart& part);

}  // namespace impetus::inline commands
