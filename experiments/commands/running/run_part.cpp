// SPDX-License-Identifier: MIT
#include "experiments/commands/running/run_part.hpp"

#include <memory>

#include "experiments/commands/patch_corner.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/running/simulated_group.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/observer_file.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"

namespace impetus::inline commands {
namespace {

ScreenCorner photodiode_corner(const RunOptions& options) {
  if (options.simulated() && !options.show) {
    throw InputError(
        "--photodiode: expected a window to draw in; with --observer, give --show too");
  }
  return patch_corner("--photodiode", options.photodiode);
}

}  // namespace

RunPart part_from(const std::filesystem::path& file, const std::string& observer,
                  const RunOptions& options) {
  RunPart part{load_protocol(file), {}};
  if (!observer.empty()) {
    part.lab.observer = load_observer(observer, file);
    check_observer(part.protocol, *part.lab.observer);
  }
  part.lab.show = options.show;
  part.lab.screen_file = options.screen_file;
  part.lab.window_size = options.window_size;
  if (!options.photodiode.empty()) {
    part.lab.photodiode = photodiode_corner(options);
  }
  const bool group = options.participants > 0;
  plan_for(part.protocol, group ? simulated_name(1, options.participants) : options.participant,
           options.seed.value_or(1));
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
