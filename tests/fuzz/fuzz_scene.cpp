// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <string>

#include "engine/dynamics/finite_states.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/scenes/scene_enclosure.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/settings/json_document.hpp"
#include "tests/fuzz/asked_work.hpp"
#include "tests/fuzz/refusals.hpp"
#include "tests/fuzz/targets.hpp"

namespace impetus {
namespace {

void step(StagedScene& staged) {
  constexpr int kSteps = 5;
  for (int i = 1; i <= kSteps; ++i) {
    FixedWork meter(/*tests_per_step=*/1000);
    StepInput input;
    input.dt_s = 1.0 / staged.step_hz;
    input.viewer = staged.viewer_at_time(i * input.dt_s);
    input.fixation = ScreenPoint{0.01, 0.0};
    if (staged.region.kind != RegionKind::kNone) {
      input.region = GazeRegion{{0.0, 0.01}, staged.region.radius_deg};
    }
    staged.world.step(input, meter);
  }
  for (const BodyState& state : staged.world.states()) {
    if (!state.pose.position.allFinite() || !state.pose.orientation.coeffs().allFinite()) {
      std::abort();  // whatever is asked for, what is drawn is finite
    }
  }
}

}  // namespace

void fuzz_scene(std::string_view bytes) {
  expect_taken_or_refused({"a.json:"}, [&] {
    const JsonDocument scene = parse_json("a.json", std::string(bytes));
    if (asks_for_much(scene.value)) {
      return;
    }
    require_scene(scene);
    ShapeLibrary library;
    StagedScene staged = build_scene(scene.value, screen_for_checks(), 0.0, library);
    step(staged);
  });
}

}  // namespace impetus
