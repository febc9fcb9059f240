// SPDX-License-Identifier: MIT
#include "experiments/commands/running/run_part.hpp"

#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "experiments/commands/named_observer.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/running/simulated_group.hpp"
#include "experiments/files/gaze_file.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/protocol_language.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/trackers/tracker_kinds.hpp"
#ifdef IMPETUS_WINDOW
#include "experiments/window/window.hpp"
#endif

namespace impetus::inline commands {
namespace {

ScreenCorner photodiode_corner(const RunOptions& options) {
  if (options.simulated() && !options.show) {
    throw InputError(
        "--photodiode: expected a window to draw in; with --observer, give --show too");
  }
  return patch_corner("--photodiode", options.photodiode);
}

/// Markers go by real time, and are those that the protocol names.
void require_markers(const RunPart& part, const RunOptions& options) {
  if (options.markers.empty()) {
    if (part.protocol.script.markers && part.lab.has_window()) {
      std::fprintf(stderr, "note: no markers are sent; --markers ADDRESS says where to\n");
    }
    return;
  }
  if (!part.lab.has_window()) {
    throw InputError(
        "--markers: expected a window, whose flips are marked; with --observer, give --show too");
  }
  if (!part.protocol.script.markers) {
    refuse(part.protocol.document, "",
           "expected the key \"markers\", which --markers asks for: this protocol marks nothing");
  }
}

/// Where there is a window, some font has all letters.
void require_fonts([[maybe_unused]] const RunPart& part) {
#ifdef IMPETUS_WINDOW
  const auto missing =
      part.lab.has_window() ? first_letter_without_font(part.lab.letters) : std::nullopt;
  if (missing) {
    const std::string code = printed("U+%04X", static_cast<unsigned>(*missing));
    refuse(
        part.protocol.document, "",
        std::string("expected a font that has all letters of the protocol and its language, but ") +
            code +
            " is in none; `apt install fonts-noto-cjk`, or fonts-wqy-microhei, which is "
            "smaller");
  }
#endif
}

void require_gaze(const Protocol& protocol) {
  if (!protocol.script.gaze) {
    refuse(protocol.document, "",
           "expected the key \"gaze\", which --gaze asks for: this protocol does not follow it");
  }
}

/// Of one trial for all, or of each.
std::shared_ptr<const GazeRecording> recorded_gaze(const Plan& plan, const std::string& file) {
  auto recording = std::make_shared<const GazeRecording>(load_gaze_recording(file));
  const std::size_t recorded = recording->trials.size();
  const std::size_t main_trials = main_slots(plan).size();
  if (recorded != 1 && recorded != main_trials) {
    throw InputError(file + ": expected the gaze of one trial, or of each of the " +
                     std::to_string(main_trials) + " main trials, got " + std::to_string(recorded));
  }
  return recording;
}

}  // namespace

std::vector<std::int64_t> main_slots(const Plan& plan) {
  std::vector<std::int64_t> slots;
  for (const PlannedTrial& trial : plan) {
    if (trial.phase == TrialPhase::kMain) {
      slots.push_back(trial.slot);
    }
  }
  return slots;
}

bool is_heard(const Protocol& protocol) { return protocol.scene.value.contains("sound"); }

RunPart part_from(const std::filesystem::path& file, const std::string& observer,
                  const RunOptions& options) {
  RunPart part{load_protocol(file), {}};
  if (!observer.empty()) {
    part.lab.observer = observer_for(part.protocol, file, observer);
    tell_unseen_factors(part.protocol, *part.lab.observer);
  }
  part.lab.show = options.show;
  part.lab.screen_file = options.screen_file;
  part.lab.window_size = options.window_size;
  part.lab.letters = wide_letters(part.protocol);
  part.lab.sounds = is_heard(part.protocol);
  require_fonts(part);
  require_markers(part, options);
  if (!options.photodiode.empty()) {
    part.lab.photodiode = photodiode_corner(options);
  }
  const bool group = options.participants > 0;
  const Plan plan =
      plan_for(part.protocol, group ? simulated_name(1, options.participants) : options.participant,
               options.seed.value_or(1));
  if (!options.gaze.empty()) {
    require_gaze(part.protocol);
  }
  if (!options.gaze.empty() && !is_tracker_url(options.gaze)) {
    part.gaze = recorded_gaze(plan, options.gaze);
  }
  check_frames(part.protocol, refresh_hz_of(part.lab), options.allow_rounding);
  return part;
}

void build_shapes(const RunPart& part) {
  ProgressLine line("building the bodies");
  part.protocol.shapes->tell([&line](double share) { line.tell(share); });
  ProtocolScenes(part.protocol, 0.0)
      .build_shapes(expected_screen(part.lab).value_or(assumed_screen()));
  part.protocol.shapes->tell({});
}

void solve_what_is_asked(RunPart& part) {
  ProgressLine line("solving what the plan needs");
  part.solved =
      solve(part.protocol, *part.protocol.shapes, [&line](double share) { line.tell(share); });
}

}  // namespace impetus::inline commands
