// Where a session that was left begins again, as its protocol says.
//
//   done: | block 1 ......... | block 2 ...      |        at trial: after the last dot
//                             ^ at block: here; the trials of block 2 are set aside and shown again
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <set>

#include "experiments/design/plan.hpp"
#include "experiments/questions/script.hpp"
#include "experiments/session/session_standing.hpp"

namespace impetus::inline session {

/// Where a resumed session begins, and what it does again.
struct Resumption {
  std::optional<std::int64_t> first_slot{};  ///< the first trial that waits; none: all are done
  std::set<std::int64_t> set_aside{};        ///< slots done before that are to be shown again
};

/// What is left of a history to go on from: the slots that the script's rule sets aside are no
/// longer done in it. Practice is never set aside.
Resumption resume(const Script& script, const Plan& plan, SessionHistory& history);

/// Practice goes on with the first round that is not done, or was not understood: in training, with
/// the first that has a trial left. Where it suffices already, it is over.
void go_on_with_practice(const Script& script, SessionStanding& standing);

}  // namespace impetus::inline session
