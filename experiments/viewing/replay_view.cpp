// SPDX-License-Identifier: MIT
#include "experiments/viewing/replay_view.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/dynamics/motion.hpp"
#include "experiments/run/seen_apart.hpp"

namespace impetus::inline viewing {
void end_with_last_step(ReplayView& view) {
  const double shown_s = static_cast<double>(view.states.size() - 1) / view.step_hz;
  if (shown_s < view.duration_s) {
    view.duration_s = shown_s;
    std::erase_if(view.marks, [&](const TimelineMark& mark) { return mark.begin_s > shown_s; });
  }
}

GazeInput gaze_of_step(const ReplayView& view, std::int64_t step) {
  const bool known = step >= 0 && step < static_cast<std::int64_t>(view.gaze.size());
  return known ? view.gaze[static_cast<std::size_t>(step)] : GazeInput{};
}

std::int64_t step_at(const ReplayView& view, double time_s) {
  const auto step = static_cast<std::int64_t>(std::floor(time_s * view.step_hz + kStepRounding));
  return std::min(step, static_cast<std::int64_t>(view.states.size()) - 1);
}

std::vector<PosedBody> bodies_at(const ReplayView& view, double time_s) {
  const auto before = static_cast<std::size_t>(step_at(view, time_s));
  const std::size_t after = std::min(before + 1, view.states.size() - 1);
  const double fraction = std::clamp(time_s * view.step_hz - static_cast<double>(before), 0.0, 1.0);
  std::vector<PosedBody> bodies;
  for (std::size_t body = 0; body < view.looks.size(); ++body) {
    const BodyState& here = view.states[before][body];
    const Pose pose =
        after > before ? between(here, view.states[after][body], fraction) : here.pose;
    bodies.push_back({pose, view.looks[body].at(time_s)});
  }
  flash(view.flashing, time_s, bodies);
  return bodies;
}

std::vector<BodyDetail> details_at(const ReplayView& view, std::int64_t step) {
  const bool known = step >= 0 && step < static_cast<std::int64_t>(view.details.size());
  return known ? view.details[static_cast<std::size_t>(step)]
               : std::vector<BodyDetail>(view.looks.size());
}

std::vector<FadingContact> contacts_at(const ReplayView& view, std::int64_t step) {
  std::vector<FadingContact> contacts;
  std::set<std::pair<std::int32_t, std::int32_t>> told;
  const std::int64_t span = std::llround(kDetailInView_s * view.step_hz);
  const std::int64_t last = std::min(step, static_cast<std::int64_t>(view.contacts.size()) - 1);
  for (std::int64_t then = last; then >= 0 && step - then < span; --then) {
    const auto& of_step = view.contacts[static_cast<std::size_t>(then)];
    const double freshness = 1.0 - static_cast<double>(step - then) / static_cast<double>(span);
    for (const StepContact& contact : of_step) {
      if (!told.contains({contact.bodies.a, contact.bodies.b})) {
        contacts.push_back({contact.touch, freshness});
      }
    }
    for (const StepContact& contact : of_step) {
      told.insert({contact.bodies.a, contact.bodies.b});
    }
  }
  return contacts;
}

std::optional<std::int64_t> parting_step(const ReplayView& recorded, const ReplayView& finest) {
  const std::size_t steps = std::min(recorded.states.size(), finest.states.size());
  for (std::size_t step = 0; step < steps; ++step) {
    const double time_s = static_cast<double>(step) / recorded.step_hz;
    const Viewer viewer = turned_viewer(recorded.viewer, recorded.turn, time_s);
    for (std::size_t body = 0; body < recorded.looks.size(); ++body) {
      if (seen_apart(recorded.states[step][body].pose, finest.states[step][body].pose,
                     recorded.looks[body].mesh != nullptr, viewer)) {
        return static_cast<std::int64_t>(step);
      }
    }
  }
  return std::nullopt;
}

}  // namespace impetus::inline viewing
