// What might happen, or might have, as somebody imagines it: a scene goes on from an instant in an
// engine of his own, with an unsteady idea of where things are heading; as it is, or without a body
// that came in between.
//
//   what is shown     A ──> * <── B          they meet: from there on ...
//   what is imagined        <── B            ... B alone, again and again, its heading turned a
//                       <~~~~~~ B            little in every step; how often does it get through?
//
// The share of runs is the answer to "what if", and how far it is from what did happen says how
// much the other body mattered (Gerstenberg, Goodman, Lagnado and Tenenbaum 2021). Of a scene whose
// end is hidden, the share of runs in which two bodies touch is how likely they seem to.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/numerics/random_stream.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline observers {

/// The engine that somebody imagines with.
struct Imagination {
  std::int64_t runs{1000};
  double heading_noise_deg{0.0};  ///< standard deviation of a turn in the picture, in each step
  double step_hz{50.0};
  int level{kUnlimitedLevel};  ///< of refinement, at most
  std::int64_t tests_per_step{kUnlimitedTests};
  /// Every second run turns the other way in each step than the run before it (antithetic draws),
  /// which steadies a share that is asked for; a person's runs know nothing of each other.
  bool in_pairs{true};
};

/// A scene's bodies at some time from onset.
struct Instant {
  double time_s{0.0};
  std::vector<BodyState> states;
};

/// The instant before the goal's body and another that moves first touch.
struct Meeting : Instant {
  std::size_t other{0};
};

/// The last of a scene that is shown, with all the work there is until then.
Instant last_shown_instant(const StagedScene& scene);

/// Of a scene with a goal, from its start; none where nobody meets, and without a goal.
std::optional<Meeting> first_meeting(const StagedScene& scene);

/// Whether the body of the scene's goal gets through in the scene's time, from its start and in its
/// own engine with all the work there is; without the body of this number, where one is given.
/// Precondition: the scene has a goal, and no figures.
bool gets_through(const StagedScene& scene, std::optional<std::size_t> without = {});

/// In how many of the imagined runs it gets through from the meeting on, without the other: a
/// share. The same precondition; the same draws give the same share.
double imagined_share(const StagedScene& scene, const Meeting& from, const Imagination& by,
                      RandomStream& draws);

/// In how many of the imagined runs from an instant on the bodies at two places of the scene touch
/// by its end: a share, drawn as above; the heading of every body that can move is unsteady.
/// Precondition: the scene has no figures.
double imagined_touching(const StagedScene& scene, const Instant& from, const BodyPair& pair,
                         const Imagination& by, RandomStream& draws);

}  // namespace impetus::inline observers
