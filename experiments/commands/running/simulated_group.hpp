// Many simulated participants, several at a time; one study file holds them all.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/commands/running/run_part.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline commands {

/// S01, S02, ...: as many digits as the last one needs, two at least.
std::string simulated_name(std::int64_t number, std::int64_t count);

/// "participants S01 to S12".
std::string group_words(std::int64_t count);

/// Runs S01, S02, ... through all parts in order, those who have not finished: the same command
/// goes on where it was stopped, and one with more participants adds to the group. Plans are stored
/// in the order of participants, whoever is done first; every participant does the same whatever
/// runs beside. Tells its progress on standard error. Throws the first error, once the others who
/// had begun are done.
void run_simulated_group(const std::vector<RunPart>& parts, const RunOptions& options,
                         StudyFile& study);

}  // namespace impetus::inline commands
