// How a simulated participant answers, as functions that draw nothing: the participant draws from
// them, and a fit takes from them how probable a recorded answer is.
//
//   stimulus ─percept─> numbers ─seen─> 0 … 1 ─rating, yes, first─> the chance of each answer
//                                 ▲               ▲
//                                 └── parameters of the kind, traits of the participant
//
// A percept is without noise and without parameters that are fitted, so it is measured once per
// trial, whatever is tried afterwards.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "experiments/record/record.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline observers {

struct RatingParameters;
struct ParameterEntry;

/// How a participant differs from the mean of the group, in standard deviations over participants.
struct Traits {
  double threshold{0.0};
  double intercept{0.0};  ///< of ratings
  double slope{0.0};      ///< of ratings
};

/// What a kind of participant goes by in one stimulus: numbers of its own, in an order of its own.
using Percept = std::vector<double>;

/// How clearly something wrong may have been seen in a trial, and how probable that is.
struct Outcome {
  double probability{1.0};
  double seen{0.0};
};

/// A mark on a line, in the terms of what is seen: where it is, and where the line ends.
struct Mark {
  double value{0.0};
  double least{0.0};
  double most{1.0};
  double grain{0.01};  ///< marks are rounded to it, from `least` on
  bool operator==(const Mark&) const = default;
};

/// A trait and the parameter that is its spread over participants.
struct TraitSpread {
  const char* parameter;
  double Traits::*trait;
};

/// What a kind that can be fitted answers by. Functions get the kind's own parameters.
struct AnswerModel {
  Percept (*percept)(const RatingParameters& parameters, const AttemptRecord& shown,
                     const StagedScene& scene){nullptr};
  /// From 0 to 1.
  double (*seen)(const RatingParameters& parameters, const Traits& traits,
                 const Percept& percept){nullptr};
  /// Where chance decides what is seen: fills what may have been, and how probably in the light of
  /// the clicks (seconds from onset; null: none were asked for), and returns the logarithm of the
  /// probability of the clicks. It goes by no trait. Null: `seen` says it, and clicks say nothing.
  double (*outcomes)(const RatingParameters& parameters, const Percept& percept,
                     const std::vector<double>* clicks_s, std::vector<Outcome>& outcomes){nullptr};
  /// The percept without what differs from trial to trial; null: any other's will do.
  Percept (*blank)(const Percept& percept){nullptr};
  /// The chance of the point so many steps from the good end of a scale.
  double (*rating)(const RatingParameters& parameters, const Traits& traits, double seen,
                   std::size_t steps, std::size_t points){nullptr};
  /// The chance of a mark on a line. Null: a kind that marks no lines.
  double (*mark)(const RatingParameters& parameters, double seen, const Mark& mark){nullptr};
  /// What happened in the stimulus, in the terms of what is seen: a mark on a line from the
  /// contrary, -1 to 1, is this less what is seen. Null: a kind that marks no such lines.
  double (*happened)(const StagedScene& scene){nullptr};

  bool is_of_scene{false};  ///< `percept` goes by the scene as it begins alone, and takes long

  /// Parameters that a fit looks for beside those of all ratings, the most telling first.
  std::vector<std::string> fitted{};
  std::vector<TraitSpread> spreads{};
  /// Of a ModelledObserver, which draws its threshold before its other traits where this is null.
  /// Else after them, and only where this spread is above 0.
  double (*late_threshold_sd)(const RatingParameters& parameters){nullptr};

  /// Each parameter of the file and where it lies in `parameters`, which must be the kind's.
  std::vector<ParameterEntry> (*entries)(RatingParameters& parameters){nullptr};
  std::shared_ptr<RatingParameters> (*copy)(const RatingParameters& parameters){nullptr};
  /// Makes parameters that follow from others follow; null: none do.
  void (*settle)(RatingParameters& parameters){nullptr};
};

/// The chance of a point of a rating scale: see observer_kinds.hpp.
double cumulative_rating(const RatingParameters& parameters, const Traits& traits, double seen,
                         std::size_t steps, std::size_t points);

double yes_chance(const RatingParameters& parameters, double seen);

/// That the first of two intervals is chosen.
double first_chance(const RatingParameters& parameters, double seen_first, double seen_second);

/// The chance of a mark where `meant` is meant, with noise of that standard deviation, which is cut
/// at the line's ends.
double mark_chance(const Mark& mark, double meant, double sd);

/// The chance of a mark that is set anywhere.
double mark_chance_anywhere(const Mark& mark);

}  // namespace impetus::inline observers
