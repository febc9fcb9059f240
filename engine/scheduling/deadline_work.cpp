// SPDX-License-Identifier: MIT
#include "engine/scheduling/deadline_work.hpp"

#include <algorithm>
#include <utility>

namespace impetus::inline scheduling {
namespace {

/// First guesses, of a machine of 2022; each is corrected within a few steps.
constexpr double kNsPerUnit[kWorkPhases] = {500.0, 10.0, 1'000.0, 30.0, 500.0,
                                            8.0,   8.0,  60.0,    80.0, 80.0};
constexpr double kNsPerThing[kStepParts] = {600.0, 100.0, 20.0, 1'000.0, 1'500.0, 150.0, 250.0};

/// Of the time that is left when a phase begins, besides what later ones take in any case.
constexpr double kShareOfRest[kWorkPhases] = {0.4, 0.3, 0.6, 0.4, 0.6, 1.0, 1.0, 0.5, 0.7, 1.0};

/// Of what is left when refinement begins: so much it gets at least, whatever is reserved, since
/// coarser contacts are more contacts.
constexpr double kLeastShareOfRefinement = 0.3;

/// Of the time that is left, in a slice; a slice is not shorter than the least, so that looks at
/// the clock stay cheap beside the work.
constexpr double kShareOfSlice = 0.2;
constexpr double kLeastSlice_ns = 1'500.0;
constexpr double kMostSlice_ns = 20'000.0;
constexpr double kMostSliceOfBudget = 0.01;  // where that is more

/// Of the budget, kept free for what nobody measures.
constexpr double kMargin = 0.015;

/// A slice is at most so many times as many units as the one before: what is known of a phase may
/// be of other steps.
constexpr std::int64_t kMostGrowth = 2;
constexpr std::int64_t kFirstSlice = 8;
constexpr double kMostRise = 2.0;

/// What a pair and a unit of modelling take besides where there never were as many in a step:
/// memory that is touched for the first time.
constexpr double kNewPair_ns = 1'000.0;
constexpr double kNewModelled_ns = 150.0;

bool can_be_interrupted(WorkPhase phase) {
  return phase != WorkPhase::kPairs && phase != WorkPhase::kModel;
}

/// With the ways of all bodies, or the order of all contacts.
bool begins_at_once(WorkPhase phase) {
  return phase == WorkPhase::kEntry || phase == WorkPhase::kVisible;
}

/// How many things fit into the time, of which there were `most` in a step so far.
std::int64_t fitting(double time_ns, double thing_ns, std::int64_t most, double new_thing_ns) {
  const double known_ns = thing_ns * static_cast<double>(most);
  const double things = time_ns > known_ns ? static_cast<double>(most) +
                                                 (time_ns - known_ns) / (thing_ns + new_thing_ns)
                                           : time_ns / thing_ns;
  return static_cast<std::int64_t>(std::max(0.0, things));
}

std::size_t index_of(WorkPhase phase) { return static_cast<std::size_t>(phase); }

template <std::size_t count>
std::array<LearnedTime, count> guesses(const double (&ns)[count], double fall) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return std::array<LearnedTime, count>{LearnedTime(ns[i], fall)...};
  }
  (std::make_index_sequence<count>{});
}

}  // namespace

void LearnedTime::learn(double elapsed_ns, double units) {
  if (!(units > 0.0) || elapsed_ns < 0.0) {
    return;
  }
  const double found_ns = std::max(elapsed_ns / units, kLeast_ns);
  ns_ = found_ns > ns_ ? std::min(found_ns, kMostRise * ns_) : ns_ + fall_ * (found_ns - ns_);
}

DeadlineWork::DeadlineWork(const WorkClock& clock, std::int64_t ns_per_step)
    : clock_(&clock),
      ns_per_step_(ns_per_step),
      unit_times_(guesses(kNsPerUnit, LearnedTime::kFastFall)),
      times_at_once_(guesses(kNsPerUnit, LearnedTime::kFastFall)),
      part_times_(guesses(kNsPerThing, LearnedTime::kSlowFall)) {}

void DeadlineWork::start_step() {
  end_ns_ = clock_->now_ns() + ns_per_step_ -
            static_cast<std::int64_t>(kMargin * static_cast<double>(ns_per_step_));
  phases_ = {};
  pairs_ = 0;
  reserved_ = 0;
  started_ = true;
  part_units_ = 0;
}

void DeadlineWork::begin(StepPart part, std::int64_t units) {
  if (!started_) {
    return;
  }
  const std::int64_t now_ns = clock_->now_ns();
  if (part == StepPart::kMove) {
    bodies_ = static_cast<double>(units);
    end_ns_ -= static_cast<std::int64_t>(part_ns(StepPart::kRemember) * bodies_);
  }
  learn_before(part, now_ns);
  if (part == StepPart::kModel) {
    later_began_ns_ = now_ns;
  }
  part_ = part;
  part_began_ns_ = now_ns;
  part_units_ = units;
}

/// What the part before has shown, when another begins.
void DeadlineWork::learn_before(StepPart part, std::int64_t now_ns) {
  const auto granting = [this](WorkPhase phase) -> const Granting& {
    return phases_[index_of(phase)];
  };
  const auto since = [now_ns](std::int64_t then_ns) {
    return static_cast<double>(now_ns - then_ns);
  };
  const Granting& motion = granting(WorkPhase::kMotion);
  if (part == StepPart::kPair && motion.refused) {
    left_motion_time_.learn(since(motion.looked_ns), bodies_);
  }
  const Granting& pairs = granting(WorkPhase::kPairs);
  if (part == StepPart::kEnter && pairs.refused) {
    choosing_time_.learn(since(pairs.looked_ns), static_cast<double>(pairs.asked));
  }
  const Granting& entry = granting(WorkPhase::kEntry);
  if (part == StepPart::kRefine && entry.refused) {
    left_entry_time_.learn(since(entry.looked_ns), static_cast<double>(pairs_));
  }
  const Granting& tests = granting(WorkPhase::kTests);
  if (part == StepPart::kModel && tests.refused) {
    left_tests_time_.learn(since(tests.looked_ns), static_cast<double>(pairs_));
  }
  const Granting& model = granting(WorkPhase::kModel);
  if (part == StepPart::kRespond) {
    const auto others = static_cast<double>(std::min(model.asked, model.granted));
    learn_modelling(since(part_began_ns_), static_cast<double>(part_units_), others);
  }
  if (part == StepPart::kRemember && !model.refused && !granting(WorkPhase::kResponse).refused) {
    reserved_unit_time_.learn(since(later_began_ns_), static_cast<double>(reserved_));
  }
}

/// What is modelled in any case, and other units that were granted, took that long together: each
/// its share of it, by what was known of them.
void DeadlineWork::learn_modelling(double elapsed_ns, double in_any_case, double others) {
  const double share_ns = part_ns(StepPart::kModel) * in_any_case;
  const double expected_ns = share_ns + unit_time(WorkPhase::kModel).ns() * others;
  if (expected_ns > 0.0) {
    const double scale = elapsed_ns / expected_ns;
    part_time(StepPart::kModel).learn(scale * share_ns, in_any_case);
    unit_time(WorkPhase::kModel).learn(scale * (expected_ns - share_ns), others);
  }
}

void DeadlineWork::expect_at_walls(std::int64_t bodies) {
  bodies_at_walls_ = static_cast<double>(bodies);
}

void DeadlineWork::finish() {
  if (!started_) {
    return;
  }
  const std::int64_t now_ns = clock_->now_ns();
  const Granting& visible = phases_[index_of(WorkPhase::kVisible)];
  const std::int64_t from_ns = visible.refused ? visible.looked_ns : part_began_ns_;
  part_time(StepPart::kRemember)
      .learn(static_cast<double>(now_ns - from_ns), static_cast<double>(part_units_));
  started_ = false;
}

std::int64_t DeadlineWork::request(WorkPhase phase, std::int64_t total, std::int64_t reserved) {
  if (phase == WorkPhase::kRefinement) {
    return total;  // its tests are asked for as kTests, whose total does not fall
  }
  Granting& granting = phases_[index_of(phase)];
  if (!started_ || granting.refused) {
    return granting.granted;
  }
  if (total <= granting.granted) {
    return granting.granted;
  }
  const std::int64_t now_ns = clock_->now_ns();
  if (!granting.begun) {
    begin_phase(phase, now_ns, granting);
    granting.at_once = begins_at_once(phase) ? total : 0;
  } else {
    learn_since_look(phase, total, now_ns, granting);
  }
  granting.asked = total;
  reserved_ = phase == WorkPhase::kTests ? reserved : reserved_;
  granting.looked_ns = now_ns;
  if (!can_be_interrupted(phase)) {
    grant_what_fits(phase, total, now_ns, granting);
    if (phase == WorkPhase::kPairs) {
      pairs_ = granting.granted;
    }
    return granting.granted;
  }
  const std::int64_t kept_ns = kept_for_later_ns(phase, total, reserved);
  grant_slice(phase, total, granting.until_ns - kept_ns - now_ns, granting);
  return granting.granted;
}

void DeadlineWork::begin_phase(WorkPhase phase, std::int64_t now_ns, Granting& granting) {
  granting.begun = true;
  const double in_part_ns = static_cast<double>(now_ns - part_began_ns_);
  if (phase == WorkPhase::kTests || phase == WorkPhase::kResponse) {
    part_time(part_).learn(in_part_ns, static_cast<double>(part_units_));
  }
  granting.until_ns = until_ns(phase, now_ns);
  if (phase == WorkPhase::kPairs) {
    const Granting& sweep = phases_[index_of(WorkPhase::kSweep)];
    sorting_time_.learn(static_cast<double>(now_ns - sweep.looked_ns),
                        static_cast<double>(std::min(sweep.asked, sweep.granted)));
  }
  if (phase == WorkPhase::kTests) {
    const Granting& roots = phases_[index_of(WorkPhase::kRoots)];
    ordering_time_.learn(roots.begun ? static_cast<double>(now_ns - roots.looked_ns) : 0.0,
                         static_cast<double>(pairs_));
    later_end_ns_ = now_ns + static_cast<std::int64_t>(kLeastShareOfRefinement *
                                                       static_cast<double>(end_ns_ - now_ns));
  }
}

/// What was done since the last look. After the first, it was what the phase began with.
void DeadlineWork::learn_since_look(WorkPhase phase, std::int64_t total, std::int64_t now_ns,
                                    Granting& granting) {
  const auto elapsed_ns = static_cast<double>(now_ns - granting.looked_ns);
  if (granting.at_once > 0) {
    time_at_once(phase).learn(elapsed_ns, static_cast<double>(granting.at_once));
    granting.at_once = 0;
  } else {
    unit_time(phase).learn(elapsed_ns, static_cast<double>(total - granting.asked));
  }
}

/// When the phase's time is up: it has a share of what is not due to others, whatever is granted.
std::int64_t DeadlineWork::until_ns(WorkPhase phase, std::int64_t now_ns) const {
  const auto pairs = static_cast<double>(pairs_);
  double due_ns = phase < WorkPhase::kTests || phase == WorkPhase::kModel ? walls_ns() : 0.0;
  if (phase == WorkPhase::kMotion) {
    due_ns += (left_motion_time_.ns() + part_ns(StepPart::kPair)) * bodies_;
  } else if (phase == WorkPhase::kEntry) {
    due_ns += (left_entry_time_.ns() + part_ns(StepPart::kRefine)) * pairs;
  } else if (phase == WorkPhase::kRoots) {
    due_ns += ordering_time_.ns() * pairs;
  }
  const double rest_ns = static_cast<double>(end_ns_ - now_ns) - due_ns;
  return now_ns + static_cast<std::int64_t>(kShareOfRest[index_of(phase)] * std::max(0.0, rest_ns));
}

void DeadlineWork::grant_what_fits(WorkPhase phase, std::int64_t total, std::int64_t now_ns,
                                   Granting& granting) {
  const auto left_ns = static_cast<double>(granting.until_ns - now_ns);
  if (phase == WorkPhase::kPairs) {
    const double pair_ns = left_entry_time_.ns() + part_ns(StepPart::kRefine);
    granting.granted = std::min(total, fitting(left_ns, pair_ns, most_pairs_, kNewPair_ns));
    most_pairs_ = std::max(most_pairs_, granting.granted);
  } else {
    const auto modelled_in = [&](double time_ns) {
      return fitting(time_ns, unit_time(phase).ns(), most_modelled_, kNewModelled_ns);
    };
    granting.granted = std::min(total, modelled_in(left_ns));
    if (granting.granted < total) {  // who comes first is found out before
      granting.granted = modelled_in(left_ns - ordering_time_.ns() * static_cast<double>(pairs_));
    }
    most_modelled_ = std::max(most_modelled_, granting.granted);
  }
  granting.refused = granting.granted < total;
}

std::int64_t DeadlineWork::kept_for_later_ns(WorkPhase phase, std::int64_t total,
                                             std::int64_t reserved) const {
  if (phase == WorkPhase::kSweep) {
    return static_cast<std::int64_t>((sorting_time_.ns() + choosing_time_.ns()) *
                                     static_cast<double>(total));
  }
  if (phase != WorkPhase::kTests) {
    return 0;
  }
  const auto wanted_ns =
      static_cast<std::int64_t>(reserved_unit_time_.ns() * static_cast<double>(reserved));
  const auto left_ns =
      static_cast<std::int64_t>(left_tests_time_.ns() * static_cast<double>(pairs_));
  return left_ns + std::max(static_cast<std::int64_t>(walls_ns()),
                            std::min(wanted_ns, end_ns_ - later_end_ns_));
}

void DeadlineWork::grant_slice(WorkPhase phase, std::int64_t total, std::int64_t left_ns,
                               Granting& granting) {
  const double needed_ns = time_at_once(phase).ns() * static_cast<double>(granting.at_once);
  if (left_ns <= 0 || needed_ns > static_cast<double>(left_ns)) {
    if (left_ns > 0) {
      time_at_once(phase).doubt();
    }
    granting.refused = true;
    return;
  }
  const double most_ns =
      std::max(kMostSlice_ns, kMostSliceOfBudget * static_cast<double>(ns_per_step_));
  const double slice_ns =
      std::clamp(kShareOfSlice * static_cast<double>(left_ns), kLeastSlice_ns, most_ns);
  granting.slice = std::min(static_cast<std::int64_t>(slice_ns / unit_time(phase).ns()),
                            std::max(kFirstSlice, kMostGrowth * granting.slice));
  granting.granted = total + granting.slice;
}

}  // namespace impetus::inline scheduling
