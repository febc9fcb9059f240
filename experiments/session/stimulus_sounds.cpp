// SPDX-License-Identifier: MIT
#include "experiments/session/stimulus_sounds.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline session {
namespace {

constexpr std::int64_t kAhead_ns = 100'000'000;

bool follows_from_the_scene_alone(const StagedScene& scene) {
  return !scene.depends_on_gaze && scene.budget.ns_per_step == 0;
}

/// The contacts of the whole stimulus, or no more than its first.
std::vector<CollisionRecord> foreseen_contacts(LiveRun run, double refresh_hz, bool first_alone) {
  run.drop_digests();
  for (std::int64_t frame = 0; static_cast<double>(frame) / refresh_hz <= run.ends_s(); ++frame) {
    static_cast<void>(run.poses_at(static_cast<double>(frame) / refresh_hz));
    if (first_alone && !run.collisions().empty()) {
      break;
    }
  }
  return run.take_collisions();
}

}  // namespace

StimulusSounds::StimulusSounds(const LiveRun& begins, std::int64_t interval, double refresh_hz,
                               Sounds& sounds)
    : task_(*begins.scene().sound),
      step_hz_(begins.scene().step_hz),
      refresh_hz_(refresh_hz),
      interval_(interval),
      sounds_(sounds),
      is_foreseen_(task_.at_s || follows_from_the_scene_alone(begins.scene())) {
  sounds_.prepare(task_);
  if (task_.kind == SoundKind::kNone) {
    is_foreseen_ = true;  // that there is nothing
  } else if (task_.at_s) {
    planned_.push_back({std::nullopt, frame_of(*task_.at_s), task_.loudness});
  } else if (is_foreseen_) {
    plan_contacts(foreseen_contacts(begins, refresh_hz, !task_.is_of_every_contact));
  }
}

std::int64_t StimulusSounds::frame_of(double time_s) const {
  return static_cast<std::int64_t>(std::ceil(time_s * refresh_hz_ - 1e-9));
}

void StimulusSounds::plan_contacts(const std::vector<CollisionRecord>& contacts) {
  for (; planned_contacts_ < contacts.size(); ++planned_contacts_) {
    if (!planned_.empty() && !task_.is_of_every_contact) {
      return;
    }
    const CollisionRecord& contact = contacts[planned_contacts_];
    const double impulse_Ns = contact.report.impulse_Ns;
    first_impulse_Ns_ = planned_.empty() ? impulse_Ns : first_impulse_Ns_;
    const double louder = first_impulse_Ns_ > 0.0 ? impulse_Ns / first_impulse_Ns_ : 1.0;
    planned_.push_back({contact.step, frame_of(static_cast<double>(contact.step) / step_hz_),
                        std::min(1.0, task_.loudness * louder)});
  }
}

void StimulusSounds::flipped(std::int64_t frame, std::int64_t flipped_ns,
                             const std::vector<CollisionRecord>& so_far) {
  last_frame_ = frame;
  if (!is_foreseen_) {
    plan_contacts(so_far);
  }
  for (Planned& planned : planned_) {
    if (planned.frame == frame) {
      planned.shown_ns = flipped_ns;
    }
    if (!planned.number) {
      planned.intended_ns =
          flipped_ns +
          std::llround(static_cast<double>(planned.frame - frame) / refresh_hz_ * 1e9) +
          std::llround(task_.lag_ms * 1e6);
      if (planned.intended_ns <= flipped_ns + kAhead_ns) {
        hand_over(planned);
      }
    }
  }
}

void StimulusSounds::hand_over(Planned& planned) {
  planned.number = sounds_.play(task_, planned.intended_ns, planned.loudness);
}

void StimulusSounds::end() {
  for (Planned& planned : planned_) {
    if (!planned.number && planned.frame <= last_frame_) {
      hand_over(planned);
    }
  }
}

std::vector<SoundRecord> StimulusSounds::take_records() {
  std::vector<SoundRecord> records;
  for (const Planned& planned : planned_) {
    if (planned.number) {
      records.push_back({planned.step, task_.lag_ms, planned.loudness, planned.shown_ns,
                         planned.intended_ns, sounds_.realised_ns(*planned.number), interval_});
    }
  }
  planned_.clear();
  return records;
}

}  // namespace impetus::inline session
