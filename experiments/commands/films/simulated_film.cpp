// SPDX-License-Identifier: MIT
#include "experiments/commands/films/simulated_film.hpp"

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "engine/dynamics/state_hash.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/design/between_participants.hpp"
#include "experiments/protocol/solved_values.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/record/frame_grid.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {
namespace {

/// A frame of a screen that misses none.
FrameRecord perfect_frame(std::int64_t frame, double refresh_hz) {
  FrameRecord record;
  record.frame = frame;
  record.shown_time_s = static_cast<double>(frame) / refresh_hz;
  record.flip.scheduled_ns = record.flip.flipped_ns = std::llround(record.shown_time_s * 1e9);
  return record;
}

/// Every stimulus that may be planned, the same ones more than once.
class PlannedTrials {
 public:
  explicit PlannedTrials(const Design& design) : design_(design) {
    for (const Condition& cell : cells(design)) {
      for (std::int64_t repetition = 1; repetition <= design.repetitions; ++repetition) {
        add("main", TrialPhase::kMain, cell, repetition);
      }
    }
    for (const ConditionBeside& beside : conditions_beside(design)) {
      const bool adapts = beside.place.starts_with("/design/adaptation");
      add_in_every_group(adapts ? "adaptation" : "catch",
                         adapts ? TrialPhase::kAdaptation : TrialPhase::kMain, beside.condition);
    }
    for (const Condition& practised : design.practice) {
      add_in_every_group("practice", TrialPhase::kPractice, practised);
    }
  }

  std::vector<std::string> parts;
  Plan plan;

 private:
  void add(const char* part, TrialPhase phase, const Condition& condition,
           std::int64_t repetition) {
    PlannedTrial& trial = plan.emplace_back();
    trial.phase = phase;
    trial.condition = condition;
    trial.repetition = repetition;
    trial.seed = kFilmSeed;
    parts.emplace_back(part);
  }

  void add_in_every_group(const char* part, TrialPhase phase, const Condition& condition) {
    for (const Condition& whole : in_every_group(condition, design_)) {
      add(part, phase, whole, 1);
    }
  }

  const Design& design_;
};

/// What is solved before a session begins.
void put_what_is_solved(const Protocol& protocol, Plan& plan) {
  ProgressLine line("solving what the plan needs");
  put_solved(solve(protocol, *protocol.shapes, [&line](double share) { line.tell(share); }), plan);
}

/// Two stimuli with the same of it look alike.
std::string looks_of(const nlohmann::json& scene, const StagedScene& staged) {
  return scene.dump() + std::to_string(hash_state(staged.world.states()).hash);
}

/// The scene as it begins; a participant's recorded gaze would be part of what it shows.
StagedScene staged_unwatched(const Protocol& protocol, const ProtocolScenes& scenes,
                             const PlannedTrial& trial, const ScreenGeometry& screen) {
  StagedScene scene = scenes.stage(trial, screen);
  if (scene.region.kind == RegionKind::kRecorded) {
    throw InputError(protocol.document.name +
                     ": expected stimuli that nobody has to look at, got a region that follows a "
                     "participant's recorded gaze; a trial of a study has it, and can be filmed");
  }
  return scene;
}

}  // namespace

Film simulated_film(StagedScene scene, double refresh_hz, const Clock& clock) {
  Film film;
  film.refresh_hz = refresh_hz;
  film.was_flipped = false;
  LiveRun live(scene, kFilmSeed, &clock);
  for (std::int64_t frame = 0; frame <= whole_frames(live.ends_s(), refresh_hz); ++frame) {
    film.frames.push_back(perfect_frame(frame, refresh_hz));
    static_cast<void>(live.poses_at(film.frames.back().shown_time_s));
  }
  film.stimuli.push_back({std::move(scene), live.take_steps()});
  return film;
}

void tell_of_gaze(const Film& film, nlohmann::ordered_json& head) {
  if (film.stimuli.front().scene.depends_on_gaze) {
    head["gaze"] = "the detail of collisions follows it, and here nobody looks";
  }
}

std::vector<PlannedFilm> planned_films(const Protocol& protocol, const ProtocolScenes& scenes,
                                       const ScreenGeometry& screen) {
  PlannedTrials planned(protocol.design);
  put_what_is_solved(protocol, planned.plan);
  std::map<std::string, std::size_t> known;
  std::set<std::string> told;
  std::vector<PlannedFilm> films;
  for (std::size_t i = 0; i < planned.plan.size(); ++i) {
    for (const PlannedTrial& shown : stimuli_of(protocol.script, planned.plan[i])) {
      const bool own = shown.condition == planned.plan[i].condition;
      const std::string looks =
          looks_of(scene_of(protocol, shown), staged_unwatched(protocol, scenes, shown, screen));
      const PlannedFilm film{own ? planned.parts[i] : "standard", shown,
                             known.emplace(looks, known.size()).first->second};
      if (told.insert(film.part + to_json(shown.condition).dump() + std::to_string(film.film))
              .second) {
        films.push_back(film);
      }
    }
  }
  return films;
}

}  // namespace impetus::inline commands
