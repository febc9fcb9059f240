// The kinds of simulated participant. Each is one source file in this folder, which says what it is
// made of and what it sees, and one or more files of numbers beside it.
//
//   gap.json, "observer": "gap" ─> the kind ─read─> its parameters ─make─> a participant
//
// A new kind is such a file and its line in observer_kinds.cpp: CONTRIBUTING.md shows one.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "experiments/observers/rating_observer.hpp"
#include "experiments/settings/json_document.hpp"

namespace impetus::inline observers {

/// What a participant is made of besides parameters: its traits and answers follow from `seed` and
/// `pseudonym`. Its answers advance `clock`; its eye, where it has one, lives by `flip_clock`, with
/// which flips are stamped. Both must outlive it, and may be the same.
struct Birth {
  std::uint64_t seed;
  const std::string& pseudonym;
  VirtualClock& clock;
  const Clock& flip_clock;
};

/// What all participants of a kind have in common.
struct ObserverKind {
  std::string name;     ///< as its files call it
  bool clicks{false};   ///< whether it clicks during the stimulus
  bool has_eye{false};  ///< whether its gaze can be followed
  /// Reads what a file of the kind gives; throws InputError as read_parameters() does.
  std::shared_ptr<const RatingParameters> (*read)(const JsonDocument& document);
  /// The participant with what read() gave.
  std::unique_ptr<RatingObserver> (*make)(const RatingParameters& parameters, const Birth& birth);
};

/// All kinds, by name.
const std::vector<std::reference_wrapper<const ObserverKind>>& observer_kinds();

/// The kind that a file names. Throws InputError when there is no such kind.
const ObserverKind& named_kind(const JsonDocument& document);

/// A number that may be anything.
inline constexpr double kAny = 1e9;

/// One number of a file, the least and the greatest that it may be, and where it goes.
struct ParameterEntry {
  const char* name;
  double minimum;
  double maximum;
  double* place;
  bool optional{false};  ///< left out, it stays what it is
};

/// Reads a kind's own numbers and those that every kind has, which go into `rating`. Throws
/// InputError: an unknown number, one that is missing, out of its range or without its unit and
/// source.
void read_parameters(const JsonDocument& document, RatingParameters& rating,
                     std::vector<ParameterEntry> own);

/// The number of a file that was read.
double number_in(const JsonDocument& document, const std::string& name);

}  // namespace impetus::inline observers
