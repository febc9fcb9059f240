// The numbers that each kind of simulated participant is made of, as its file gives them.
//
//   "observer": "gap"  ─>  the kind's table: name, least, greatest, place  ─>  GapParameters
//
// A new kind is a struct in the variant, a table and a line in kinds().
// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "experiments/observers/causality_observer.hpp"
#include "experiments/observers/gap_observer.hpp"
#include "experiments/observers/gaze_observer.hpp"
#include "experiments/observers/response_observer.hpp"
#include "experiments/settings/json_document.hpp"

namespace impetus::inline protocol {

using ObserverParameters = std::variant<CausalityParameters, GapParameters, GazeObserverParameters,
                                        GapThresholdParameters, ResponseParameters>;

/// Reads the kind that the document names. Throws InputError: an unknown kind or number, one that
/// is missing, out of its range or without its unit and source.
ObserverParameters read_parameters(const JsonDocument& document);

}  // namespace impetus::inline protocol
